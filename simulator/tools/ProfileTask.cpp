//===- ProfileTask.cpp - The profile of a run -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ProfileTask.h"

#include "simulator/profile/ProfileBuilder.h"

#include "llvm/Object/ELFObjectFile.h"

using namespace llvm;

namespace tp {

/// The words of the text at which the symbol table has functions.
static std::vector<uint32_t> functionEntries(const RunSetup &Loaded) {
  std::vector<uint32_t> Entries;
  const Program &Text = Loaded.Text;
  for (const object::ELFSymbolRef Symbol : Loaded.Elf.object().symbols()) {
    Expected<uint64_t> Address = Symbol.getAddress();
    if (!Address) {
      consumeError(Address.takeError());
      continue;
    }
    if (Symbol.getELFType() == ELF::STT_FUNC && *Address % 4 == 0 &&
        *Address >= Text.textBegin() && *Address < Text.textEnd())
      Entries.push_back(uint32_t(*Address - Text.textBegin()) / 4);
  }
  return Entries;
}

std::unique_ptr<ExecutionRecorder> makeRecorder(const ChipConfig &Chip,
                                                const RunSetup &Loaded) {
  return std::make_unique<ExecutionRecorder>(Chip, Loaded.Text,
                                             functionEntries(Loaded));
}

llvm::Error ProfileTask::pause(Engine &Machine, RunResult::EndKind Now) {
  bool IsLast = Now != RunResult::Paused;
  if (IsLast || Machine.cycles() >= Tms.nextLook())
    Tms.look(Machine.statistics(), IsLast);
  return llvm::Error::success();
}

void ProfileTask::serialize(Archive &A) {
  A(Recorder);
  A(Tms);
}

Profile ProfileTask::finish(const RunSummary &Run) {
  return makeProfile(Run, Loaded.Elf, Recorder.record(Run.Stats), Tms.take());
}

} // namespace tp
