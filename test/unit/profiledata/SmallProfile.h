//===- SmallProfile.h - A profile for tests ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_PROFILEDATA_SMALLPROFILE_H
#define TP_TEST_UNIT_PROFILEDATA_SMALLPROFILE_H

#include "simulator/profile/Profile.h"

namespace tp::test {

inline ProfileCounts counts(uint64_t Instructions, uint64_t Data) {
  ProfileCounts Result;
  Result.Instructions = Instructions;
  Result.Lost[unsigned(Loss::Data)] = Data;
  return Result;
}

/// main (0) calls leaf (1) from two places, once itself and once in helper (2),
/// which is inlined into main. leaf did 30 instructions and 9 cycles of waits:
/// 10 and 9 for the first call, 20 and 0 for the second.
inline Profile smallProfile() {
  Profile Data;
  Data.Run.TmCount = Data.Run.TpsPerTm = 1;
  Data.Run.Cycles = 46;
  Data.Functions = {{"main", std::nullopt, 1},
                    {"leaf", std::nullopt, 10},
                    {"helper", std::nullopt, 20}};
  Data.Frames = {{0, std::nullopt, 2, 0, std::nullopt},
                 {0, std::nullopt, 3, 0, std::nullopt},
                 {2, std::nullopt, 21, 0, 1},
                 {1, std::nullopt, 11, 0, std::nullopt}};
  Data.Instructions = {{0x10000, "jal", 0, counts(1, 2), {}},
                       {0x10004, "jal", 2, counts(4, 0), {}},
                       {0x10008, "add", 3, counts(15, 9), {}},
                       {0x1000c, "jr", 3, counts(15, 0), {}}};
  Data.Calls = {{0, std::nullopt, std::nullopt, 1, counts(5, 2)},
                {1, 0, 0, 1, counts(10, 9)},
                {1, 0, 1, 2, counts(20, 0)}};
  Data.Tms.Issued = Data.Tms.Memory = Data.Tms.Finished = {{}};
  return Data;
}

} // namespace tp::test

#endif // TP_TEST_UNIT_PROFILEDATA_SMALLPROFILE_H
