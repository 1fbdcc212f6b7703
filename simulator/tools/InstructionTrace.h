//===- InstructionTrace.h - A thread's instructions as text --- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One line per instruction, before it is executed: its address, and the
// registers that have changed since the line before, all in hexadecimal:
//
//   00010004 r29=fffffed0 f4=3f800000
//
// All registers are 0 in the beginning.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_INSTRUCTIONTRACE_H
#define TP_SIMULATOR_TOOLS_INSTRUCTIONTRACE_H

#include "simulator/functional/FunctionalMachine.h"
#include "simulator/tools/Options.h"

#include "llvm/Support/raw_ostream.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace tp {

/// Writes what a thread does to a file.
class InstructionTrace {
public:
  /// Opens the file that \p Request names and watches the thread. The trace
  /// must outlive the machine's runs.
  llvm::Error start(FunctionalMachine &Machine, const ChipConfig &Chip,
                    const Options &Request);
  /// Closes the file, if there is one.
  llvm::Error finish();

private:
  void write(uint32_t Pc, const std::array<uint32_t, NumRegisters> &Registers);

  std::string Path;
  std::unique_ptr<llvm::raw_fd_ostream> File;
  std::array<uint32_t, NumRegisters> Before{};
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_INSTRUCTIONTRACE_H
