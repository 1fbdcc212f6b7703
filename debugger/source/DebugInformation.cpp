//===- DebugInformation.cpp - All that is known of a program's source ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/DebugInformation.h"

#include "debugger/source/LocationEvaluator.h"
#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

DebugInformation::DebugInformation(const ElfProgram &Program) {
  auto Warn = [this](Error Problem) {
    handleAllErrors(std::move(Problem), [this](const ErrorInfoBase &Info) {
      if (!is_contained(Warnings, Info.message()))
        Warnings.push_back(Info.message());
    });
  };
  Dwarf = DWARFContext::create(Program.object(),
                               DWARFContext::ProcessDebugRelocations::Process,
                               nullptr, "", Warn, Warn);
  for (const auto &Unit : Dwarf->normal_units())
    if (Unit->getDWOId()) {
      Warnings.push_back(Program.path() +
                         ": variables and types that are in .dwo files are "
                         "not read; compile without -gsplit-dwarf");
      break;
    }
  Index = std::make_unique<NameIndex>(*Dwarf);
  Map = std::make_unique<SourceMap>(Program, *Dwarf, *Index, Files);
  Types = std::make_unique<TypeTable>(*Index);
  Frames = std::make_unique<Unwinder>(*Dwarf, *Map);
  Locations = std::make_unique<LocationEvaluator>(*Map, *Frames);
  Names = std::make_unique<Variables>(*Map, *Index, *Types, *Locations);
}

DebugInformation::~DebugInformation() = default;

} // namespace tp
