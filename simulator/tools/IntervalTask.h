//===- IntervalTask.h - The course of a run over time -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_INTERVALTASK_H
#define TP_SIMULATOR_TOOLS_INTERVALTASK_H

#include "simulator/stats/IntervalWriter.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/RunLoop.h"

#include "llvm/Support/raw_ostream.h"

#include <memory>
#include <vector>

namespace tp {

/// Writes what happened in each interval of a run. An interval ends with the
/// arbitration window in which a multiple of its length lies; the last one may
/// be shorter.
class IntervalTask : public RunTask {
public:
  /// The series of \p Machine from now on, as \p Request wants it. The
  /// machine's text consists of \p Opcodes.
  static llvm::Expected<std::unique_ptr<IntervalTask>>
  start(const Options &Request, const ChipConfig &Chip,
        std::vector<Opcode> Opcodes, const Engine &Machine);

  ~IntervalTask() override;

  uint64_t nextPause() const override { return NextEnd; }
  llvm::Error pause(Engine &Machine, RunResult::EndKind Now) override;

  /// Writes the rest of the run, which has ended.
  llvm::Error finish(const Engine &Machine);

private:
  IntervalTask(const Options &Request, const ChipConfig &Chip,
               std::vector<Opcode> Opcodes, const Engine &Machine,
               std::unique_ptr<llvm::raw_fd_ostream> File);

  llvm::Error writeInterval(const Engine &Machine);
  llvm::Error writeError();

  const ChipConfig &Chip;
  const uint64_t Length;
  const std::string Path;
  const std::vector<Opcode> Opcodes;
  std::unique_ptr<llvm::raw_fd_ostream> File;
  std::unique_ptr<IntervalWriter> Writer;
  /// What was counted before the interval at hand, and the cycle to end it.
  Statistics Before;
  uint64_t NextEnd;
  bool IsFinished = false;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_INTERVALTASK_H
