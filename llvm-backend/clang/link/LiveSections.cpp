//===- LiveSections.cpp - What of the inputs a program needs --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/LiveSections.h"

using namespace llvm;
using namespace llvm::ELF;

namespace tp {

namespace {
class Marker {
public:
  explicit Marker(ArrayRef<std::unique_ptr<ElfObject>> Objects);
  void mark(InputSection *Section);
  void mark(const Symbol *Target);
  void followReferences();

private:
  std::vector<InputSection *> Pending;
  /// Sections that `__start_<name>` refers to, by name.
  StringMap<std::vector<InputSection *>> ByName;
};
} // namespace

Marker::Marker(ArrayRef<std::unique_ptr<ElfObject>> Objects) {
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections())
      if (Section)
        ByName[Section->Name].push_back(Section.get());
}

void Marker::mark(InputSection *Section) {
  if (!Section || Section->Live)
    return;
  Section->Live = true;
  Pending.push_back(Section);
}

void Marker::mark(const Symbol *Target) {
  if (!Target)
    return;
  if (Target->Defined)
    return mark(Target->Section);
  StringRef Name = Target->Name;
  if (Name.consume_front("__start_") || Name.consume_front("__stop_"))
    if (auto Sections = ByName.find(Name); Sections != ByName.end())
      for (InputSection *Section : Sections->second)
        mark(Section);
}

void Marker::followReferences() {
  while (!Pending.empty()) {
    InputSection *Section = Pending.back();
    Pending.pop_back();
    for (const ElfType::Rela &Relocation : Section->Relocations)
      mark(Section->File->symbol(Relocation.getSymbol(false)));
  }
}

static bool isAlwaysLive(const InputSection &Section) {
  return Section.Flags & SHF_GNU_RETAIN || Section.Type == SHT_NOTE ||
         Section.Name.starts_with(".init_array") ||
         Section.Name.starts_with(".fini_array") ||
         Section.Name.starts_with(".preinit_array");
}

void markLiveSections(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                      const SymbolTable &Globals, ArrayRef<std::string> Roots,
                      bool KeepAll) {
  Marker Needed(Objects);
  for (const std::string &Root : Roots)
    Needed.mark(Globals.find(Root));
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections())
      if (Section && Section->isAllocated() &&
          (KeepAll || isAlwaysLive(*Section)))
        Needed.mark(Section.get());
  Needed.followReferences();
  // Debug data describes the program and keeps nothing in it.
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections())
      if (Section && !Section->isAllocated())
        Section->Live = !(Section->Flags & SHF_EXCLUDE);
}

} // namespace tp
