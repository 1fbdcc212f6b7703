//===- tp-objdump.cpp - Shows what is in TP objects and executables -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/AssemblyText.h"
#include "llvm-backend/tools/tp-objdump/Disassembly.h"
#include "llvm-backend/tools/tp-objdump/Listings.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/InitLLVM.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

static cl::OptionCategory Category("tp-objdump options");

static cl::list<std::string> InputFilenames(cl::Positional, cl::OneOrMore,
                                            cl::desc("<files>"),
                                            cl::cat(Category));

static cl::opt<bool> Disassemble("disassemble",
                                 cl::desc("Disassemble the instructions"),
                                 cl::cat(Category));
static cl::alias DisassembleShort("d", cl::desc("Alias for --disassemble"),
                                  cl::aliasopt(Disassemble), cl::NotHidden,
                                  cl::Grouping, cl::cat(Category));
static cl::opt<bool>
    Assembly("assembly",
             cl::desc("Print the instructions so that tp-mc accepts them"),
             cl::cat(Category));
static cl::opt<bool>
    NoAliases("no-aliases",
              cl::desc("Print instructions under their own names"),
              cl::cat(Category));
static cl::opt<bool>
    LineNumbers("line-numbers",
                cl::desc("Show function, file and line of instructions"),
                cl::cat(Category));
static cl::alias LineNumbersShort("l", cl::desc("Alias for --line-numbers"),
                                  cl::aliasopt(LineNumbers), cl::NotHidden,
                                  cl::Grouping, cl::cat(Category));
static cl::opt<bool> Source("source",
                            cl::desc("Show source lines; disassembles too"),
                            cl::cat(Category));
static cl::alias SourceShort("S", cl::desc("Alias for --source"),
                             cl::aliasopt(Source), cl::NotHidden, cl::Grouping,
                             cl::cat(Category));
static cl::opt<bool> Symbols("syms", cl::desc("Show the symbols"),
                             cl::cat(Category));
static cl::alias SymbolsShort("t", cl::desc("Alias for --syms"),
                              cl::aliasopt(Symbols), cl::NotHidden,
                              cl::Grouping, cl::cat(Category));
static cl::opt<bool>
    Relocations("reloc",
                cl::desc("Show the relocations, in the disassembly if there "
                         "is one"),
                cl::cat(Category));
static cl::alias RelocationsShort("r", cl::desc("Alias for --reloc"),
                                  cl::aliasopt(Relocations), cl::NotHidden,
                                  cl::Grouping, cl::cat(Category));
static cl::opt<bool> Sections("section-headers", cl::desc("Show the sections"),
                              cl::cat(Category));
static cl::alias SectionsShort("h", cl::desc("Alias for --section-headers"),
                               cl::aliasopt(Sections), cl::NotHidden,
                               cl::Grouping, cl::cat(Category));

static int fail(const Twine &Message) {
  WithColor::error(errs(), "tp-objdump") << Message << '\n';
  return 1;
}

static int dump(StringRef Path, raw_ostream &OS) {
  Expected<tp::ObjectInput> Input = tp::ObjectInput::open(Path);
  if (!Input)
    return fail(Path + ": " + toString(Input.takeError()));

  tp::InstructionText Text(*Input, !NoAliases);
  if (Assembly) {
    tp::printAssembly(*Input, Text, OS);
    return 0;
  }
  OS << '\n' << Path << ":\tfile format elf32-tp\n";
  if (Sections)
    tp::printSections(*Input, OS);
  if (Symbols)
    tp::printSymbols(*Input, OS);
  if (Disassemble || Source)
    tp::printDisassembly(*Input, Text, {Relocations, LineNumbers, Source}, OS);
  else if (Relocations)
    tp::printRelocations(*Input, OS);
  return 0;
}

int main(int argc, char **argv) {
  InitLLVM Init(argc, argv);
  cl::HideUnrelatedOptions(Category);
  cl::ParseCommandLineOptions(argc, argv,
                              "Shows what is in TP objects and executables\n");
  if (!Disassemble && !Source && !Symbols && !Relocations && !Sections &&
      !Assembly)
    return fail("nothing to show: give at least one of -d, -S, -t, -r, -h, "
                "--assembly");
  if (LineNumbers && !Disassemble && !Source)
    return fail("-l needs -d or -S");

  int Status = 0;
  for (const std::string &Path : InputFilenames)
    Status |= dump(Path, outs());
  return Status;
}
