//===- ProgramLinker.cpp - Everything to one program ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ProgramLinker.h"
#include "llvm-backend/clang/link/ElfLinker.h"
#include "llvm-backend/clang/link/InfinityAssumptions.h"
#include "llvm-backend/clang/link/InputFiles.h"
#include "llvm-backend/clang/link/WholeProgram.h"
#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/ToolOutputFile.h"

using namespace llvm;

namespace tp {

// What tpsim looks for in a program; see runtime/include/tp/launch.h.
static constexpr const char LaunchBlockSymbol[] = "__tp_launch";

// Messages about code of the whole program say where the source is.
static constexpr const char WholeProgramName[] = "<program>";

static void addRuntime(WholeProgram &Program, LLVMContext &Context,
                       const LinkOptions &Options, const InputFiles &Files,
                       LinkDiagnostics &Diags) {
  const std::string &Path = Options.RuntimePath;
  auto Buffer = MemoryBuffer::getFile(Path);
  if (std::error_code Failure = Buffer.getError()) {
    Diags.error("cannot read the runtime '" + Path + "': " + Failure.message() +
                "; build the target tp-runtime, or link with -nostdlib");
    return;
  }
  Expected<std::unique_ptr<Module>> Runtime =
      getOwningLazyBitcodeModule(std::move(*Buffer), Context);
  if (!Runtime) {
    Diags.error("cannot read the runtime '" + Path +
                "': " + toString(Runtime.takeError()) +
                "; build the target tp-runtime again");
    return;
  }
  Program.addRuntime(std::move(*Runtime), "the runtime",
                     Options.FullRuntimeDebugInfo, Files.DefinedByObjects);
}

// Bitcode and objects are linked at different stages, so that symbols that one
// of each defines need a check of their own.
static void reportDuplicates(const WholeProgram &Program,
                             const InputFiles &Files, LinkDiagnostics &Diags) {
  for (const auto &Symbol : Files.DefinedByObjects)
    if (StringRef Unit = Program.definitionOf(Symbol.getKey()); !Unit.empty())
      Diags.error("duplicate symbol: " + Symbol.getKey() + "\n  defined in " +
                  Unit + "\n  defined in " + Symbol.getValue());
}

static bool writeExecutable(ArrayRef<uint8_t> Contents, StringRef Path,
                            LinkDiagnostics &Diags) {
  std::error_code Failure;
  ToolOutputFile File(Path, Failure, sys::fs::OF_None);
  if (!Failure) {
    File.os().write(reinterpret_cast<const char *>(Contents.data()),
                    Contents.size());
    File.os().flush();
    Failure = File.os().error();
    File.os().clear_error();
  }
  if (Failure) {
    Diags.error("cannot write '" + Path + "': " + Failure.message());
    return false;
  }
  File.keep();
  if (auto Permissions = sys::fs::getPermissions(Path);
      Permissions && sys::fs::is_regular_file(Path))
    if (std::error_code Refusal =
            sys::fs::setPermissions(Path, *Permissions | sys::fs::all_exe))
      Diags.warning("cannot make '" + Path +
                    "' executable: " + Refusal.message());
  return true;
}

bool linkProgram(LLVMContext &Context, std::vector<LinkInput> Inputs,
                 const LinkOptions &Options, LinkDiagnostics &Diags) {
  InputFiles Files(Context, Diags);
  for (LinkInput &Input : Inputs)
    Files.add(std::move(Input));
  Files.resolveArchives();

  WholeProgram Program(Context, Options.Reports, Diags);
  InfinityAssumptions Infinities;
  for (InputFiles::NamedUnit &Unit : Files.Units) {
    Infinities.add(*Unit.Unit);
    Program.add(std::move(Unit.Unit), Unit.Name);
  }
  for (MemoryBufferRef Object : Files.Objects)
    Infinities.add(Object);
  Infinities.report(Options.Warnings, Diags);
  reportDuplicates(Program, Files, Diags);
  ElfLinkOptions ElfOptions;
  ElfOptions.EntrySymbol = Options.EntrySymbol;
  ElfOptions.Roots = Options.KeptSymbols;
  ElfOptions.Roots.push_back(LaunchBlockSymbol);
  ElfOptions.CollectGarbage = Options.CollectGarbage;
  ElfOptions.MapPath = Options.MapPath;
  ElfOptions.StackBytes = Options.StackBytes;
  ElfOptions.Hint = [&](StringRef Symbol, StringRef Function) {
    return Program.referenceTo(Symbol, Function);
  };

  StringSet<> Exported = Files.MentionedByObjects;
  Exported.insert_range(ElfOptions.Roots);
  Exported.insert(Options.EntrySymbol);
  // The name stays for debuggers and profiles.
  Exported.insert("main");
  Program.exportSymbols(Exported);
  if (!Options.RuntimePath.empty())
    addRuntime(Program, Context, Options, Files, Diags);
  if (Diags.hasErrors())
    return false;

  std::vector<MemoryBufferRef> Objects;
  SmallVector<char, 0> ProgramObject;
  if (!Program.isEmpty()) {
    ProgramObject = Program.compile(Options.Level);
    if (Diags.hasErrors())
      return false;
    Objects.push_back({StringRef(ProgramObject.data(), ProgramObject.size()),
                       WholeProgramName});
  }
  append_range(Objects, Files.Objects);
  SmallVector<uint8_t, 0> File = linkElf(Objects, ElfOptions, Diags);
  return !Diags.hasErrors() && writeExecutable(File, Options.OutputPath, Diags);
}

} // namespace tp
