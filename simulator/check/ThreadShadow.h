//===- ThreadShadow.h - What the checks know of a thread --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_THREADSHADOW_H
#define TP_SIMULATOR_CHECK_THREADSHADOW_H

#include "simulator/check/CallContexts.h"
#include "simulator/check/ShadowMemory.h"
#include "simulator/check/UndefinedBits.h"
#include "simulator/check/UndefinedOrigins.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// An object of a thread's stack.
struct StackObject {
  uint32_t Begin = 0;
  uint32_t Bytes = 0;
  std::string_view Name;
  CodePlace BeganAt;

  /// Where \p Address lies, such as "4 bytes behind 'values' of 40 bytes".
  std::string describe(uint32_t Address) const;
};

struct ThreadShadow {
  /// By register. What NoRegister has means nothing.
  std::array<UndefinedBits, NumRegisters> Undefined;
  std::array<OriginId, NumRegisters> Origin;
  std::unique_ptr<ShadowMemory> Local;
  ThreadCallStack Calls;
  /// As it was last seen; 0: there is no stack yet.
  uint32_t StackPointer = 0;
  /// As it was at first.
  uint32_t StackTop = 0;
  /// The bytes that the calls of the allocator under way were asked for.
  std::vector<uint32_t> Requests;
  /// The descriptor of the next message about an object of the stack.
  uint32_t ObjectDescriptor = 0;
  /// The bytes of that object, if the descriptor does not say it.
  uint32_t ObjectBytes = 0;
  /// Those that the program has told of, by address.
  std::map<uint32_t, StackObject> Objects;

  ThreadShadow() {
    Undefined.fill(AllUndefined);
    Undefined[0] = 0;
    Origin.fill(UnwrittenRegister);
  }

  /// The object that holds \p Address or is next to it; null if there is none.
  const StackObject *nearestObject(uint32_t Address) const;
  /// Functions have returned whose memory, from \p Begin on, lies below \p End.
  void forgetObjects(uint32_t Begin, uint32_t End);

  bool isInAllocator() const { return !Requests.empty(); }
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_THREADSHADOW_H
