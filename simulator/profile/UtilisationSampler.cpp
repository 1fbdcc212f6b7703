//===- UtilisationSampler.cpp - What each TM does over time ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/UtilisationSampler.h"

#include <algorithm>

namespace tp {

/// Numbers that a profile has of TMs and intervals, at most.
static constexpr size_t MaxNumbers = 32768;
static constexpr size_t FewestIntervals = 64, MostIntervals = 512;
/// Cycles of an interval at first.
static constexpr uint64_t FirstLength = 1024;

UtilisationSampler::UtilisationSampler(const ChipConfig &Chip)
    : Chip(Chip), MaxIntervals(std::clamp(MaxNumbers / Chip.TmCount,
                                          FewestIntervals, MostIntervals)),
      Length(FirstLength) {
  Result.Issued.resize(Chip.TmCount);
  Result.Memory.resize(Chip.TmCount);
  Result.Finished.resize(Chip.TmCount);
}

void UtilisationSampler::look(const Statistics &Now, bool IsLast) {
  if (!HasBegun) {
    beginAt(Now);
    return;
  }
  if (Now.Cycles >= NextEnd || (IsLast && Now.Cycles > Begin))
    addInterval(Now);
}

void UtilisationSampler::beginAt(const Statistics &Now) {
  HasBegun = true;
  Begin = Now.Cycles;
  Before = Now.Threads;
  NextEnd = Begin + Length;
}

void UtilisationSampler::addInterval(const Statistics &Now) {
  ProfileCounts Chip;
  std::vector<ProfileCounts> Tms(Result.Issued.size());
  for (size_t Thread = 0; Thread != Now.Threads.size(); ++Thread) {
    const ThreadStatistics &From = Before[Thread], &To = Now.Threads[Thread];
    ProfileCounts &Tm = Tms[Thread / this->Chip.TpsPerTm];
    Tm.Instructions += To.Instructions - From.Instructions;
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      Tm.Lost[Reason] += To.Lost[Reason] - From.Lost[Reason];
  }
  for (size_t Tm = 0; Tm != Tms.size(); ++Tm) {
    Chip += Tms[Tm];
    Result.Issued[Tm].push_back(Tms[Tm].Instructions);
    Result.Memory[Tm].push_back(Tms[Tm].memoryWaits());
    Result.Finished[Tm].push_back(Tms[Tm].Lost[unsigned(Loss::Finished)]);
  }
  Result.Chip.push_back(Chip);
  Result.Ends.push_back(Now.Cycles);
  if (Result.Ends.size() == MaxIntervals)
    joinPairs();
  beginAt(Now);
}

void UtilisationSampler::serialize(Archive &A) {
  A(Length);
  A(NextEnd);
  A(HasBegun);
  A(Begin);
  A(Before);
  A(Result.Ends);
  A(Result.Chip);
  A(Result.Issued);
  A(Result.Memory);
  A(Result.Finished);
}

void UtilisationSampler::joinPairs() {
  auto Join = [](auto &Series) {
    for (size_t I = 0; I != Series.size() / 2; ++I) {
      Series[I] = Series[2 * I];
      Series[I] += Series[2 * I + 1];
    }
    Series.resize(Series.size() / 2);
  };
  for (size_t I = 0; I != Result.Ends.size() / 2; ++I)
    Result.Ends[I] = Result.Ends[2 * I + 1];
  Result.Ends.resize(Result.Ends.size() / 2);
  Join(Result.Chip);
  for (auto *Tms : {&Result.Issued, &Result.Memory, &Result.Finished})
    for (std::vector<uint64_t> &Tm : *Tms)
      Join(Tm);
  Length *= 2;
}

} // namespace tp
