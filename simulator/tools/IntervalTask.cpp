//===- IntervalTask.cpp - The course of a run over time -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/IntervalTask.h"

#include "simulator/stats/SumCheck.h"

using namespace llvm;

namespace tp {

Expected<std::unique_ptr<IntervalTask>>
IntervalTask::start(const Options &Request, const ChipConfig &Chip,
                    std::vector<Opcode> Opcodes, const Engine &Machine) {
  std::error_code EC;
  auto File = std::make_unique<raw_fd_ostream>(Request.IntervalOutput, EC);
  if (EC)
    return createStringError("cannot write " + Request.IntervalOutput + ": " +
                             EC.message());
  return std::unique_ptr<IntervalTask>(new IntervalTask(
      Request, Chip, std::move(Opcodes), Machine, std::move(File)));
}

IntervalTask::IntervalTask(const Options &Request, const ChipConfig &Chip,
                           std::vector<Opcode> Opcodes, const Engine &Machine,
                           std::unique_ptr<raw_fd_ostream> Output)
    : Chip(Chip), Length(Request.Interval), Path(Request.IntervalOutput),
      Opcodes(std::move(Opcodes)), File(std::move(Output)),
      Before(Machine.statistics()),
      NextEnd((Before.Cycles / Length + 1) * Length) {
  Writer = StringRef(Path).ends_with(".csv") ? makeCsvWriter(*File)
                                             : makeTraceWriter(Chip, *File);
}

IntervalTask::~IntervalTask() {
  // An error here is of a run that has failed for another reason.
  Writer.reset();
  if (!IsFinished)
    File->flush();
  File->clear_error();
}

llvm::Error IntervalTask::pause(Engine &Machine, RunResult::EndKind) {
  if (Machine.cycles() < NextEnd)
    return llvm::Error::success();
  return writeInterval(Machine);
}

llvm::Error IntervalTask::finish(const Engine &Machine) {
  if (Machine.cycles() > Before.Cycles)
    if (llvm::Error E = writeInterval(Machine))
      return E;
  Writer->finish();
  File->close();
  IsFinished = true;
  return writeError();
}

llvm::Error IntervalTask::writeInterval(const Engine &Machine) {
  Statistics Now = Machine.statistics();
  Statistics Interval = Now.since(Before);
  if (llvm::Error E = checkSums(Chip, Interval, Opcodes))
    return createStringError("cycles " + Twine(Before.Cycles) + " to " +
                             Twine(Now.Cycles) + ": " + toString(std::move(E)));
  Writer->write(Before.Cycles, Now.Cycles, intervalFigures(Chip, Interval));
  Before = std::move(Now);
  NextEnd = (Before.Cycles / Length + 1) * Length;
  return writeError();
}

llvm::Error IntervalTask::writeError() {
  if (!File->has_error())
    return llvm::Error::success();
  std::error_code EC = File->error();
  File->clear_error();
  return createStringError("cannot write " + Path + ": " + EC.message());
}

} // namespace tp
