//===- SlotArgument.h - The argument slots=N --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_STACKCACHE_SLOTARGUMENT_H
#define TP_KERNELS_STACKCACHE_SLOTARGUMENT_H

#include "tp/host_call.h"
#include "tp/memory.h"
#include "tp/thread.h"

#include <stdint.h>
#ifndef __tp__
#include <stdio.h>
#endif

namespace tp {

/// Writes the pieces of a message to stderr if this is thread 0. On the chip it
/// does without <stdio.h>, whose buffers would take space of the local store.
template <class... Pieces> void complain(const Pieces *...Text) {
  if (threadId() != 0)
    return;
#ifdef __tp__
  constexpr unsigned StandardError = 2;
  (__builtin_tp_hostcall(kHostCallWrite, StandardError, deviceAddress(Text),
                         __builtin_strlen(Text)),
   ...);
#else
  (fputs(Text, stderr), ...);
#endif
}

/// The number that \p Text is in decimal digits, at most \p Most; -1 if it is
/// none.
inline int64_t parseCount(const char *Text, uint32_t Most) {
  if (*Text == '\0')
    return -1;
  uint64_t Result = 0;
  for (; *Text != '\0'; ++Text) {
    if (*Text < '0' || *Text > '9')
      return -1;
    Result = Result * 10 + static_cast<uint64_t>(*Text - '0');
    Result = Result < Most ? Result : Most;
  }
  return static_cast<int64_t>(Result);
}

/// The number of slots to use: that of the argument `slots=N` in \p Arguments
/// (as of main), at most \p Available; without the argument all of these. 0
/// after an error, of which there has been a message: another argument, or less
/// than three slots.
inline uint32_t readSlotArgument(int ArgumentCount, char **Arguments,
                                 uint32_t Available) {
  constexpr uint32_t Least = 3;
  if (Available < Least) {
    complain("StackCached: error: the local store has no room for 3 slots; "
             "choose a chip with a larger one\n");
    return 0;
  }
  uint32_t Slots = Available;
  for (int Index = 1; Index < ArgumentCount; ++Index) {
    const char *Argument = Arguments[Index];
    constexpr char Name[] = "slots=";
    constexpr unsigned NameLength = sizeof(Name) - 1;
    const int64_t Count = __builtin_strncmp(Argument, Name, NameLength) == 0
                              ? parseCount(Argument + NameLength, Available)
                              : -1;
    if (Count < Least) {
      complain("StackCached: error: argument '", Argument,
               "'; expected slots=N, where N is 3 or more\n");
      return 0;
    }
    Slots = static_cast<uint32_t>(Count);
  }
  return Slots;
}

} // namespace tp

#endif // TP_KERNELS_STACKCACHE_SLOTARGUMENT_H
