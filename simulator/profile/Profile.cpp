//===- Profile.cpp - Where a run spent its cycles -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/Profile.h"

#include <numeric>

namespace tp {

uint64_t ProfileCounts::lost() const {
  return std::accumulate(Lost.begin(), Lost.end(), uint64_t(0));
}

uint64_t ProfileCounts::cycles() const { return Instructions + lost(); }

uint64_t ProfileCounts::memoryWaits() const {
  uint64_t Sum = 0;
  for (Loss Reason :
       {Loss::Memory, Loss::L1, Loss::L2, Loss::Dram, Loss::StoreBuffer})
    Sum += Lost[unsigned(Reason)];
  return Sum;
}

ProfileCounts &ProfileCounts::operator+=(const ProfileCounts &Other) {
  Instructions += Other.Instructions;
  for (unsigned I = 0; I != NumLosses; ++I)
    Lost[I] += Other.Lost[I];
  return *this;
}

ServedAccesses servedBetween(const MemoryBehaviour &Memory, ServedBy First,
                             ServedBy Last) {
  ServedAccesses Sum;
  for (unsigned Level = unsigned(First); Level <= unsigned(Last); ++Level) {
    Sum.Accesses += Memory.Served[Level].Accesses;
    Sum.Cycles += Memory.Served[Level].Cycles;
  }
  return Sum;
}

ProfileCounts Profile::total() const {
  ProfileCounts Sum;
  for (const ProfileInstruction &Instruction : Instructions)
    Sum += Instruction.Counts;
  return Sum;
}

std::vector<uint32_t> Profile::framesFrom(uint32_t Innermost) const {
  std::vector<uint32_t> Chain = {Innermost};
  while (std::optional<uint32_t> Outer = Frames[Chain.back()].InlinedInto)
    Chain.push_back(*Outer);
  return Chain;
}

} // namespace tp
