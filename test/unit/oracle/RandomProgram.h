//===- RandomProgram.h - Random programs and chips --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ORACLE_RANDOMPROGRAM_H
#define TP_TEST_UNIT_ORACLE_RANDOMPROGRAM_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Memory.h"
#include "simulator/core/Program.h"

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace tp::test {

/// Random numbers that are the same on every host.
class RandomSource {
public:
  explicit RandomSource(uint64_t Seed) : Engine(Seed) {}

  /// One of 0..Limit-1.
  uint32_t below(uint32_t Limit) { return uint32_t(Engine() % Limit); }
  uint32_t between(uint32_t Least, uint32_t Most) {
    return Least + below(Most - Least + 1);
  }
  bool oneIn(uint32_t Count) { return below(Count) == 0; }
  uint32_t word() { return uint32_t(Engine()); }

private:
  std::mt19937_64 Engine;
};

/// Ways through a program.
enum class ProgramShape {
  /// Every branch leads to the next instruction.
  StraightLine,
  /// Branches forward, and loops of a few rounds.
  Branching,
};

/// A program of all instructions with its data.
struct RandomProgram {
  std::vector<uint32_t> Words;
  uint32_t Entry = 0;
  uint32_t ReadOnlyEnd = 0;
  uint32_t StackLimit = 0;
  /// With floating-point checks; empty if the ends are the same.
  uint32_t CheckedBegin = 0;
  uint32_t CheckedEnd = 0;
  /// Address and value of the words that are not 0 at the start.
  std::vector<std::pair<uint32_t, uint32_t>> Data;

  RandomProgram(RandomSource &Random, ProgramShape Shape,
                const ChipConfig &Chip);

  Program text() const;
  void initialize(Memory &Global) const;
};

/// A chip on which TPs get into each other's way.
ChipConfig randomChip(RandomSource &Random);
/// The same with some of L1, crossbar, L2 and DRAM, all small.
ChipConfig randomMemoryChip(RandomSource &Random);

} // namespace tp::test

#endif // TP_TEST_UNIT_ORACLE_RANDOMPROGRAM_H
