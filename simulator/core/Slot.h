//===- Slot.h - A decoded instruction and who executes it -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_SLOT_H
#define TP_SIMULATOR_CORE_SLOT_H

#include "simulator/core/TmRunner.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tp {

template <class Word> struct Slot;
template <class Word> struct TmRunner;

/// The state of the running thread: itself, the instruction at hand, the
/// relative cycle, the resource table such that Free[Cycle] is this cycle's,
/// and all guard bits.
#define TP_HANDLER_PARAMETERS                                                  \
  Thread *T, const Slot<Word> *S, uint64_t Cycle, Word *Free, TmRunner<Word> *R
#define TP_HANDLER_ARGUMENTS T, S, Cycle, Free, R
#define TP_TAIL_CALL [[clang::musttail]] return

template <class Word>
using Handler = void(__attribute__((preserve_none)) *)(TP_HANDLER_PARAMETERS);

/// A host thread's working state with its table of resources.
template <class Word> struct TmRunner : TmRunnerState {
  /// The text, one slot per word and one behind it.
  const Slot<Word> *Slots = nullptr;
  /// On a chip whose instruction caches can miss, who executes the slot's
  /// instruction once it is there.
  const Handler<Word> *Fetched = nullptr;
  Word IcacheGuards = 0;
  Word Guards = 0;
  /// The guard bit of a cycle in which nothing may start.
  Word Closed = 0;
  /// What each cycle of the window still has free in the TM at hand; after the
  /// last cycle comes a closed one.
  std::vector<Word> Free;
};

/// A decoded instruction, ready for one chip.
template <class Word> struct Slot {
  /// What it takes of its cycle's resources.
  Word Use;
  Handler<Word> Execute;
  tp::Instruction Instruction;
  /// Ready word of the result, to which the cycle of issue is added.
  ReadyWord Result;
  /// Of the instruction in the text.
  uint32_t Number;
};

/// The ready word of the source that is ready last of the first \p Count.
template <unsigned Count, class Word>
ReadyWord latestSource(const Thread *T, const Slot<Word> *S) {
  ReadyWord Latest = 0;
  for (unsigned I = 0; I != Count; ++I)
    Latest = std::max(Latest, T->Ready[S->Instruction.Source[I]]);
  return Latest;
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_SLOT_H
