//===- ObjectPlace.cpp - An address beside an object, in words ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/ObjectPlace.h"

namespace tp {

std::string inBytes(uint64_t Count) {
  return std::to_string(Count) + (Count == 1 ? " byte" : " bytes");
}

static std::string relation(uint32_t Address, uint32_t Begin, uint64_t Bytes) {
  if (Address < Begin)
    return inBytes(Begin - Address) + " before";
  uint32_t Offset = Address - Begin;
  if (Offset == Bytes)
    return "right behind";
  if (Offset > Bytes)
    return inBytes(Offset - Bytes) + " behind";
  return Offset == 0 ? "at the start of" : inBytes(Offset) + " into";
}

std::string describePlace(uint32_t Address, uint32_t Begin, uint64_t Bytes,
                          const std::string &Name) {
  return relation(Address, Begin, Bytes) + " " + Name + " of " + inBytes(Bytes);
}

} // namespace tp
