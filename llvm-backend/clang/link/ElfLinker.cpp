//===- ElfLinker.cpp - Objects to an executable ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ElfLinker.h"
#include "llvm-backend/clang/link/ElfWriter.h"
#include "llvm-backend/clang/link/LinkerSymbols.h"
#include "llvm-backend/clang/link/LiveSections.h"
#include "llvm-backend/clang/link/MapFile.h"
#include "llvm-backend/clang/link/ProgramStack.h"

using namespace llvm;

namespace tp {

static void allocateCommonSymbols(SymbolTable &Globals) {
  for (Symbol &Global : Globals.symbols()) {
    if (!Global.Common)
      continue;
    Global.Section = Global.File->addCommonSection(Global);
    Global.Value = 0;
    Global.Common = false;
    if (Global.Type == ELF::STT_NOTYPE)
      Global.Type = ELF::STT_OBJECT;
  }
}

SmallVector<uint8_t, 0> linkElf(ArrayRef<MemoryBufferRef> Inputs,
                                const ElfLinkOptions &Options,
                                LinkDiagnostics &Diags) {
  SymbolTable Globals;
  StringSet<> ComdatGroups;
  std::vector<std::unique_ptr<ElfObject>> Objects;
  for (MemoryBufferRef Input : Inputs)
    if (auto Object = ElfObject::read(Input, Input.getBufferIdentifier(),
                                      Globals, ComdatGroups, Diags))
      Objects.push_back(std::move(Object));
  allocateCommonSymbols(Globals);

  const Symbol *Entry = Globals.find(Options.EntrySymbol);
  if (!Diags.hasErrors() && (!Entry || !Entry->Defined))
    Diags.error("undefined entry symbol: " + Options.EntrySymbol +
                "; link with the runtime, define the symbol, or name another "
                "one with -Wl,--entry=<symbol>");
  if (Diags.hasErrors())
    return {};

  std::vector<std::string> Roots = Options.Roots;
  Roots.push_back(Options.EntrySymbol);
  markLiveSections(Objects, Globals, Roots, !Options.CollectGarbage);
  Layout Program = layOut(Objects, Diags);
  if (Diags.hasErrors())
    return {};
  const ProgramStack Stack =
      determineStack(Objects, Globals, *Entry, Options, Diags);
  if (Diags.hasErrors())
    return {};
  defineLinkerSymbols(Program, Stack.Bytes, Globals);
  reportUndefinedSymbols(Objects, Options.Hint, Diags);
  if (Diags.hasErrors())
    return {};

  SmallVector<uint8_t, 0> File =
      writeElf(Program, Objects, Globals, Entry->address(), Diags);
  if (Diags.hasErrors())
    return {};
  if (!Options.MapPath.empty())
    writeMapFile(Options.MapPath, Program, Stack.Bound, Objects, Globals,
                 Diags);
  return File;
}

} // namespace tp
