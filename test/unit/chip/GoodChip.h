//===- GoodChip.h - A chip file that is right -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_CHIP_GOODCHIP_H
#define TP_TEST_UNIT_CHIP_GOODCHIP_H

#include "simulator/chip/ChipFile.h"

#include "gtest/gtest.h"

#include <string>

namespace tp {

/// A chip file that is right; tests change one line of it.
inline std::string goodChip() {
  std::string Text = R"(description: "a test's chip"
clock_ghz: 1.5
tm:
  count: 2
  tps: 4
arbitration_window_cycles: 20
memory:
  bytes: 64 MiB
  latency_cycles: 50
local_store:
  bytes: 4096
icache:
  banks: 8
  ports_per_bank: 2
  bytes: 4 KiB
units:
)";
  for (unsigned I = 0; I != NumUnits; ++I)
    Text += "  " + std::string(unitName(Unit(I))) +
            ": {count: " + std::to_string(I + 1) + "}\n";
  return Text;
}

inline std::string replaced(std::string Text, const std::string &From,
                            const std::string &To) {
  size_t At = Text.find(From);
  EXPECT_NE(At, std::string::npos) << From;
  return At == std::string::npos ? Text : Text.replace(At, From.size(), To);
}

/// The error of a chip file; empty if there is none.
inline std::string errorOf(const std::string &Text) {
  llvm::Expected<ChipConfig> Chip = parseChip(Text, "c.yaml", "c");
  return Chip ? "" : llvm::toString(Chip.takeError());
}

inline std::string written(const ChipConfig &Chip) {
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  writeChip(Chip, OS);
  return Text;
}

} // namespace tp

#endif // TP_TEST_UNIT_CHIP_GOODCHIP_H
