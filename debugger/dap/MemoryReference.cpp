//===- MemoryReference.cpp - Addresses as a client keeps them -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/MemoryReference.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp::dap {

std::string addressText(uint32_t Address) {
  return "0x" + utohexstr(Address, /*LowerCase=*/true, /*Width=*/8);
}

std::string MemoryReference::text() const {
  return addressText(Address) + (Thread ? "@" + utostr(*Thread) : "");
}

Expected<MemoryReference> parseMemoryReference(StringRef Text) {
  auto [Address, Thread] = Text.split('@');
  MemoryReference Result;
  uint32_t Number = 0;
  bool HasThread = Text.contains('@');
  if (Address.getAsInteger(0, Result.Address) ||
      (HasThread && Thread.getAsInteger(10, Number)))
    return createStringError("'" + Text + "' is no address; expected 0x<hex>");
  if (HasThread)
    Result.Thread = Number;
  return Result;
}

Expected<uint32_t> addressPlus(uint32_t Address, int64_t Offset) {
  int64_t Sum;
  if (AddOverflow(int64_t(Address), Offset, Sum) || !isUInt<32>(Sum))
    return createStringError("address " + addressText(Address) + " plus " +
                             Twine(Offset) + " is outside of 32 bits");
  return uint32_t(Sum);
}

} // namespace tp::dap
