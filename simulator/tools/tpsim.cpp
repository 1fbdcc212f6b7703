//===- tpsim.cpp - The simulator's command --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipSettings.h"
#include "simulator/chip/SchemaTable.h"
#include "simulator/tools/CompareRuns.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/Simulation.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace llvm;

/// The folder of the chips that go by name: `<bin>/../share/tp/chips`.
static std::string chipFolder(const char *Argv0) {
  std::string Binary =
      sys::fs::getMainExecutable(Argv0, reinterpret_cast<void *>(&chipFolder));
  SmallString<256> Folder =
      sys::path::parent_path(sys::path::parent_path(Binary));
  sys::path::append(Folder, "share", "tp", "chips");
  return std::string(Folder);
}

static Expected<int> run(int Argc, char **Argv) {
  Expected<tp::Options> Request =
      tp::parseOptions(ArrayRef(Argv, Argc).drop_front());
  if (!Request)
    return Request.takeError();
  if (Request->Help) {
    tp::printHelp(outs());
    return 0;
  }
  if (Request->Version) {
    outs() << "tpsim " TP_VERSION "\n";
    return 0;
  }
  if (Request->PrintChipSchema) {
    tp::writeSchemaTable(outs());
    return 0;
  }
  if (Request->Comparison) {
    if (Error E = tp::compareRuns(*Request->Comparison))
      return std::move(E);
    return 0;
  }
  std::string ChipFolder = chipFolder(Argv[0]);
  Expected<tp::ChipConfig> Chip = tp::loadChip(Request->Chip, ChipFolder);
  if (Chip && !Request->ChipSettings.empty())
    Chip = tp::withSettings(*Chip, Request->ChipSettings,
                            tp::foldersOfChip(Request->Chip, ChipFolder));
  if (!Chip)
    return Chip.takeError();
  if (Request->PrintChip) {
    tp::writeChip(*Chip, outs());
    return 0;
  }
  return tp::simulate(*Request, *Chip);
}

int main(int Argc, char **Argv) {
  Expected<int> Status = run(Argc, Argv);
  if (Status)
    return *Status & 0xff;
  tp::reportError(Status.takeError());
  return 1;
}
