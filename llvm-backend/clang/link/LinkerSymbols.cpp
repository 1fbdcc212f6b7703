//===- LinkerSymbols.cpp - Symbols that the linker defines ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/LinkerSymbols.h"
#include "llvm-backend/clang/link/MemoryMap.h"
#include "llvm-backend/clang/link/ProgramStack.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {

static void defineAbsolute(Symbol &Name, uint32_t Value) {
  if (Name.Defined)
    return;
  Name.Defined = true;
  Name.Value = Value;
  Name.Binding = ELF::STB_GLOBAL;
}

static void defineIfNamed(SymbolTable &Globals, StringRef Name,
                          uint32_t Value) {
  if (Symbol *Named = Globals.find(Name))
    defineAbsolute(*Named, Value);
}

// Begin and end of the section \p Name; both the end of the image if there is
// no such section, so that loops over it do nothing.
static void defineBounds(const Layout &Program, SymbolTable &Globals,
                         StringRef Section, const Twine &BeginName,
                         const Twine &EndName) {
  uint32_t Begin = Program.ImageEnd, End = Program.ImageEnd;
  if (const OutputSection *Found = Program.find(Section)) {
    Begin = Found->Address;
    End = Begin + Found->Size;
  }
  defineIfNamed(Globals, BeginName.str(), Begin);
  defineIfNamed(Globals, EndName.str(), End);
}

void defineLinkerSymbols(const Layout &Program,
                         std::optional<uint32_t> StackBytes,
                         SymbolTable &Globals) {
  const auto StackTop = static_cast<uint32_t>(
      alignDown(Program.ThreadLocalBegin, memorymap::StackAlignment));
  struct {
    const char *Name;
    uint32_t Value;
  } const Always[] = {
      {"__tp_image_end", Program.ImageEnd},
      {"__tp_tls_begin", Program.ThreadLocalBegin},
      {"__tp_tls_end", memorymap::ThreadLocalEnd},
      {"__tp_stack_top", StackTop},
      {"__tp_tdata_image", Program.ThreadLocalDataImage
                               ? Program.ThreadLocalDataImage
                               : Program.ImageEnd},
      {"__tp_tdata_size", Program.ThreadLocalDataSize},
      {"__tp_tbss_size", Program.ThreadLocalZeroFilledSize},
  };
  for (const auto &Entry : Always)
    defineAbsolute(Globals.get(Entry.Name), Entry.Value);
  if (StackBytes) {
    defineAbsolute(Globals.get(StackBytesSymbol), *StackBytes);
    defineAbsolute(Globals.get(StackLimitSymbol), StackTop - *StackBytes);
  }

  defineBounds(Program, Globals, ".preinit_array", "__preinit_array_start",
               "__preinit_array_end");
  defineBounds(Program, Globals, ".init_array", "__init_array_start",
               "__init_array_end");
  defineBounds(Program, Globals, ".fini_array", "__fini_array_start",
               "__fini_array_end");
  defineBounds(Program, Globals, ".text", "__text_start", "_etext");
  defineBounds(Program, Globals, ".text", "__executable_start", "etext");
  defineBounds(Program, Globals, ".bss", "__bss_start", "__bss_end");
  for (const char *Name : {"_end", "end"})
    defineIfNamed(Globals, Name, Program.ImageEnd);
  defineIfNamed(Globals, "__dso_handle", memorymap::GlobalBegin);
  for (const auto &Section : Program.Sections)
    if (all_of(Section->Name, [](char C) { return isAlnum(C) || C == '_'; }))
      defineBounds(Program, Globals, Section->Name, "__start_" + Section->Name,
                   "__stop_" + Section->Name);
}

} // namespace tp
