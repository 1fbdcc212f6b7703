//===- Trap.cpp - Why a simulated program was stopped ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Trap.h"

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"

#include <cstdio>

namespace tp {

static std::string at(const char *What, uint32_t Address) {
  char Buffer[16];
  std::snprintf(Buffer, sizeof(Buffer), " 0x%08x", unsigned(Address));
  return std::string(What) + Buffer;
}

std::string Trap::what() const {
  switch (Kind) {
  case TrapKind::IllegalInstruction:
    return "illegal instruction";
  case TrapKind::FetchOutsideText:
    return at("execution left the program's text to", Address);
  case TrapKind::MisalignedAccess:
    return at("misaligned access to", Address);
  case TrapKind::NullAccess:
    return at("null dereference: access to", Address);
  case TrapKind::AddressOutOfRange:
    return at("access outside memory to", Address);
  case TrapKind::StoreToReadOnly:
    return at("store to read-only memory at", Address);
  case TrapKind::DivisionByZero:
    return "integer division by zero";
  case TrapKind::Condition:
    return "trap instruction";
  case TrapKind::Break:
    return "break " + std::to_string(Address);
  case TrapKind::BadHostCall:
    return "bad host call " + std::to_string(Address);
  case TrapKind::SubnormalOperand:
    return "subnormal operand " + describeFloat(Address, CheckType::Float) +
           " flushed to zero";
  case TrapKind::SubnormalResult:
    return "subnormal result " + describeFloat(Address, CheckType::Float) +
           " flushed to zero";
  case TrapKind::StackOverflow:
    return at("stack overflow: the stack pointer fell to", Address);
  case TrapKind::BadStream:
    return at("bad stream at", Address);
  }
  return "unknown trap";
}

} // namespace tp
