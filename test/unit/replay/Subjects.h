//===- Subjects.h - Random programs to go back and forth in -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random programs whose threads use the same memory, on random chips, with
// timing and without. What a replay shows at any moment is compared with a
// machine that runs from the start to there and knows no replay.
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_REPLAY_SUBJECTS_H
#define TP_TEST_UNIT_REPLAY_SUBJECTS_H

#include "simulator/replay/Replay.h"
#include "test/unit/oracle/RandomProgram.h"
#include "test/unit/replay/State.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tp::test {

/// A random program and a chip for it.
struct Subject {
  RandomSource Random;
  ChipConfig Chip;
  RandomProgram Source;
  Program Text;
  /// Where it is ended if it does not end by itself.
  uint64_t Most;
  /// How it ends, when, and what it is like then.
  RunResult Result{};
  uint64_t End = 0;
  State AtEnd;

  bool traps() const { return Result.End == RunResult::Trapped; }
  /// Of a machine that has run from the start to there.
  virtual State stateAt(uint64_t Time) const = 0;
  virtual std::unique_ptr<Replay> makeReplay(Memory &Global,
                                             ReplayOptions Request,
                                             std::string &Error) const = 0;

protected:
  Subject(uint64_t Seed, ChipConfig (*MakeChip)(RandomSource &), uint64_t Most)
      : Random(Seed), Chip(MakeChip(Random)),
        Source(Random,
               Seed % 3 ? ProgramShape::Branching : ProgramShape::StraightLine,
               Chip),
        Text(Source.text()), Most(Most) {}
  ~Subject() = default;
};

/// With timing, half of the chips with caches or DRAM.
struct CycleSubject final : Subject {
  explicit CycleSubject(uint64_t Seed);
  State stateAt(uint64_t Time) const override;
  std::unique_ptr<Replay> makeReplay(Memory &Global, ReplayOptions Request,
                                     std::string &Error) const override;
};

/// Without timing.
struct FunctionalSubject final : Subject {
  explicit FunctionalSubject(uint64_t Seed);
  State stateAt(uint64_t Time) const override;
  std::unique_ptr<Replay> makeReplay(Memory &Global, ReplayOptions Request,
                                     std::string &Error) const override;
};

/// A replay of a subject, with frequent points.
struct Replayed {
  const Subject &S;
  Memory Global;
  std::unique_ptr<Replay> Run;
  std::string Output;

  explicit Replayed(Subject &S);
  State state() const { return stateOf(*Run, S.Chip, Global); }
  /// All events of a run, forward from its beginning.
  std::vector<ReplayStop> all(const Events &Wanted);
};

} // namespace tp::test

#endif // TP_TEST_UNIT_REPLAY_SUBJECTS_H
