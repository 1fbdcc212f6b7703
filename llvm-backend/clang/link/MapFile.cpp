//===- MapFile.cpp - Describes a program's layout -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/MapFile.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

static void writeLine(raw_ostream &Stream, uint32_t Address, uint32_t Size,
                      unsigned Indent, const Twine &Name) {
  Stream << format("%08x %8x ", Address, Size);
  Stream.indent(Indent) << Name << '\n';
}

static DenseMap<const InputSection *, std::vector<const Symbol *>>
symbolsBySection(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                 const SymbolTable &Globals) {
  DenseMap<const InputSection *, std::vector<const Symbol *>> BySection;
  auto Add = [&](const Symbol &Candidate) {
    if (Candidate.Section && Candidate.Type != ELF::STT_SECTION)
      BySection[Candidate.Section].push_back(&Candidate);
  };
  for (const auto &Object : Objects)
    for_each(Object->locals(), Add);
  for_each(Globals.symbols(), Add);
  for (auto &Entry : BySection)
    llvm::stable_sort(Entry.second, [](const Symbol *A, const Symbol *B) {
      return A->Value < B->Value;
    });
  return BySection;
}

static void writeStack(raw_ostream &Stream, const StackBound &Stack) {
  if (!Stack.Bytes) {
    Stream << "\nThe stack of a thread has no bound:\n" << Stack.Reason << '\n';
    return;
  }
  Stream << "\nThe stack of a thread takes at most " << *Stack.Bytes
         << " bytes:\n   total    frame function\n";
  uint32_t Total = 0;
  for (const StackBound::Step &Step : Stack.DeepestChain) {
    Total += Step.FrameBytes;
    Stream << format("%8u %8u ", Total, Step.FrameBytes) << Step.Function
           << '\n';
  }
}

void writeMapFile(StringRef Path, const Layout &Program,
                  const StackBound &Stack,
                  ArrayRef<std::unique_ptr<ElfObject>> Objects,
                  const SymbolTable &Globals, LinkDiagnostics &Diags) {
  std::error_code Failure;
  raw_fd_ostream Stream(Path, Failure, sys::fs::OF_Text);
  if (Failure) {
    Diags.error("cannot write the map file '" + Path +
                "': " + Failure.message());
    return;
  }
  auto BySection = symbolsBySection(Objects, Globals);
  Stream << " address     size name\n";
  for (const auto &Section : Program.Sections) {
    if (Section->Class == SectionClass::NotLoaded)
      continue;
    writeLine(Stream, Section->Address, Section->Size, 0, Section->Name);
    for (const InputSection *Input : Section->Inputs) {
      writeLine(Stream, Input->address(0), Input->Size, 2,
                Input->File->name() + ":(" + Input->Name + ")");
      for (const Symbol *Contained : BySection.lookup(Input))
        writeLine(Stream, Contained->address(), Contained->Size, 4,
                  Contained->Name);
    }
  }
  writeStack(Stream, Stack);
}

} // namespace tp
