//===- DebuggedProgram.h - A program that runs under test -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_SOURCE_DEBUGGEDPROGRAM_H
#define TP_TEST_UNIT_SOURCE_DEBUGGEDPROGRAM_H

#include "debugger/source/DebugInformation.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/functional/FunctionalMachine.h"
#include "simulator/tools/RunSetup.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tp::test {

/// A program that tpcc has made, and one run of it without timing.
class DebuggedProgram {
public:
  /// Compiles \p Source, below test/ if it is relative; fails the test and ends
  /// if that does not work.
  DebuggedProgram(const std::string &Source,
                  const std::vector<std::string> &Options);

  DebugInformation &information() { return *Information; }
  const SourceMap &map() { return Information->map(); }
  const ElfProgram &elf() const { return Loaded->Elf; }

  /// Runs, and calls \p Function before each instruction with the innermost
  /// frame; writes through the frame take effect in memory only.
  void run(const std::function<void(const FrameContext &)> &Function);

  /// Runs, and calls \p Function at the first instruction of each call of the
  /// function \p Name, with the frame that called it.
  void runToCallsOf(const std::string &Name,
                    const std::function<void(const FrameContext &)> &Function);

  /// The frame \p Number of a backtrace.
  FrameContext frame(const FrameContext &Innermost, size_t Number);
  /// The backtrace, which must be complete.
  std::vector<Frame> backtrace(const FrameContext &Innermost);

  /// What the last write to a register through a frame was.
  unsigned WrittenRegister = 0;
  uint32_t WrittenValue = 0;

private:
  ChipConfig Chip;
  std::unique_ptr<RunSetup> Loaded;
  std::unique_ptr<DebugInformation> Information;
};

/// The text of an expression's value at a frame, or `error: ` and why not.
std::string print(DebugInformation &Information, const FrameContext &Frame,
                  const std::string &Expression, char Format = 0);

} // namespace tp::test

#endif // TP_TEST_UNIT_SOURCE_DEBUGGEDPROGRAM_H
