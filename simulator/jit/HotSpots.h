//===- HotSpots.h - Where code is worth compiling ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_HOTSPOTS_H
#define TP_SIMULATOR_JIT_HOTSPOTS_H

#include "simulator/jit/Segment.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// Chooses where segments begin, by what the interpreter has executed.
class HotSpots {
public:
  /// \p Interpreted is how often the interpreter has executed each word since
  /// the last call, \p Executed how often it and generated code have in all.
  /// Gives the segments to compile, the hottest first: from each word where
  /// threads come from elsewhere than the word before, if the interpreter has
  /// executed it at least \p HotCount times, and on from where those end.
  std::vector<Segment> choose(const CodeSubject &Subject,
                              std::span<const uint64_t> Interpreted,
                              std::span<const uint64_t> Executed,
                              uint64_t HotCount);

private:
  /// Of each word, whether a segment begins there.
  std::vector<bool> IsHead;
};

} // namespace tp

#endif // TP_SIMULATOR_JIT_HOTSPOTS_H
