//===- tpsim.cpp - The simulator's command --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/SchemaTable.h"
#include "simulator/tools/ChipSelection.h"
#include "simulator/tools/CompareRuns.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/ProfileOutputs.h"
#include "simulator/tools/Simulation.h"

#include "llvm/Support/raw_ostream.h"

using namespace llvm;

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
  if (Request->Profile && !Request->Profile->Input.empty()) {
    if (Error E = tp::showProfile(*Request->Profile))
      return std::move(E);
    return 0;
  }
  Expected<tp::ChipConfig> Chip =
      tp::selectChip(*Request, tp::chipFolder(Argv[0]));
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
