//===- ThreadShadow.cpp - What the checks know of a thread ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/ThreadShadow.h"

#include "simulator/check/ObjectPlace.h"

#include <iterator>

namespace tp {

std::string StackObject::describe(uint32_t Address) const {
  return describePlace(Address, Begin, Bytes,
                       "the stack object '" + std::string(Name) + "'");
}

const StackObject *ThreadShadow::nearestObject(uint32_t Address) const {
  auto Behind = Objects.upper_bound(Address);
  if (Behind == Objects.begin())
    return Behind == Objects.end() ? nullptr : &Behind->second;
  const StackObject &Before = std::prev(Behind)->second;
  if (Behind == Objects.end() || Address - Before.Begin < Before.Bytes)
    return &Before;
  uint32_t Distance = Address - Before.Begin - Before.Bytes;
  return Distance <= Behind->first - Address ? &Before : &Behind->second;
}

void ThreadShadow::forgetObjects(uint32_t Begin, uint32_t End) {
  if (Objects.empty())
    return;
  const uint32_t First = Begin & ~(AccessGranule - 1);
  Local->setAccess(First, toGranules(End) - First, Access::All);
  Objects.erase(Objects.lower_bound(Begin), Objects.lower_bound(End));
}

} // namespace tp
