//===- Campaign.h - Many random programs against the model ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// TP_ORACLE_PROGRAMS and TP_ORACLE_SEED in the environment replace the number
// of programs of each campaign and the seed of the first.
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ORACLE_CAMPAIGN_H
#define TP_TEST_UNIT_ORACLE_CAMPAIGN_H

#include "test/unit/oracle/Comparison.h"

namespace tp::test {

using ChipMaker = ChipConfig (*)(RandomSource &Random);

/// Runs \p Count random programs of a shape, each on a random chip, on the
/// engine and in the model, and expects that nothing differs. If they are at
/// least 1000, also that nothing was left out: opcodes, losses, ways to end.
void checkPrograms(ProgramShape Shape, ChipMaker MakeChip, uint64_t Count,
                   const EngineRun &Run);

} // namespace tp::test

#endif // TP_TEST_UNIT_ORACLE_CAMPAIGN_H
