//===- profile.h - What a program tells its observer ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Profile instructions are for whoever watches the run. On the chip they take
// no time at all, and no memory access waits for them.
//
//===----------------------------------------------------------------------===//

#ifndef TP_PROFILE_H
#define TP_PROFILE_H

#include <stdint.h>

namespace tp {

#ifdef __tp__

/// Marks the start of the program's phase \p Phase for the simulator's
/// statistics. Nothing on the host.
template <uint32_t Phase> inline void profile() { __builtin_tp_prof(Phase); }

/// Hands \p Value to the observer of the run as that of \p Marker (below
/// 65536).
template <uint32_t Marker> inline void profileValue(uint32_t Value) {
  __builtin_tp_profv(Marker, Value);
}

#else

/// Receives the profile values of a kernel that runs natively.
class ProfileObserver {
public:
  virtual ~ProfileObserver() = default;

  /// Called by thread \p Thread itself: concurrently with those of others.
  virtual void profileValue(uint32_t Thread, uint32_t Marker,
                            uint32_t Value) = 0;
};

/// The observer of the running kernel, or none. Set it while no kernel runs.
extern ProfileObserver *CurrentProfileObserver;

uint32_t threadId();

template <uint32_t Phase> inline void profile() {}

template <uint32_t Marker> inline void profileValue(uint32_t Value) {
  if (CurrentProfileObserver)
    CurrentProfileObserver->profileValue(threadId(), Marker, Value);
}

#endif

} // namespace tp

#endif // TP_PROFILE_H
