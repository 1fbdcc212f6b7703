//===- tp-mc.cpp - The TP's assembler -------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Assembles text, or disassembles bytes given as text. Options as llvm-mc's.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MachineCode/MachineCode.h"
#include "llvm-backend/tools/tp-mc/HexInput.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/FormattedStream.h"
#include "llvm/Support/InitLLVM.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/ToolOutputFile.h"
#include "llvm/Support/VirtualFileSystem.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

static cl::OptionCategory Category("tp-mc options");

static cl::opt<std::string> InputFilename(cl::Positional,
                                          cl::desc("<input file>"),
                                          cl::init("-"), cl::cat(Category));
static cl::opt<std::string> OutputFilename("o", cl::desc("Output file"),
                                           cl::value_desc("file"),
                                           cl::init("-"), cl::cat(Category));

enum class OutputKind { Assembly, Object, Nothing };
static cl::opt<OutputKind>
    FileType("filetype", cl::desc("What to write:"),
             cl::init(OutputKind::Assembly),
             cl::values(clEnumValN(OutputKind::Assembly, "asm", "assembly"),
                        clEnumValN(OutputKind::Object, "obj", "an ELF object"),
                        clEnumValN(OutputKind::Nothing, "null", "nothing")),
             cl::cat(Category));

static cl::opt<bool> Disassemble(
    "disassemble",
    cl::desc("Read bytes in hexadecimal and disassemble them as instructions"),
    cl::cat(Category));
static cl::opt<bool>
    ShowEncoding("show-encoding",
                 cl::desc("Add the bytes of each instruction as a comment"),
                 cl::cat(Category));
static cl::opt<bool>
    NoAliases("no-aliases",
              cl::desc("Print instructions under their own names"),
              cl::cat(Category));
static cl::opt<bool>
    DebugInfo("g", cl::desc("Add DWARF that leads back to the source lines"),
              cl::cat(Category));
static cl::list<std::string>
    IncludeDirectories("I", cl::desc("Directory of files for .include"),
                       cl::value_desc("directory"), cl::Prefix,
                       cl::cat(Category));

static int fail(const Twine &Message) {
  WithColor::error(errs(), "tp-mc") << Message << '\n';
  return 1;
}

static std::unique_ptr<MCStreamer> createStreamer(tp::MachineCode &Code,
                                                  raw_pwrite_stream &Output) {
  if (FileType == OutputKind::Nothing)
    return std::unique_ptr<MCStreamer>(createNullStreamer(Code.Context));

  if (FileType == OutputKind::Object)
    return Code.createObjectStreamer(Output);

  std::unique_ptr<MCInstPrinter> Printer = Code.createPrinter();
  if (NoAliases)
    Printer->applyTargetSpecificCLOption("no-aliases");
  std::unique_ptr<MCCodeEmitter> Encoder;
  if (ShowEncoding)
    Encoder = Code.createEncoder();
  return std::unique_ptr<MCStreamer>(Code.Target.createAsmStreamer(
      Code.Context, std::make_unique<formatted_raw_ostream>(Output),
      std::move(Printer), std::move(Encoder), Code.createAsmBackend()));
}

static void describeSource(const SourceMgr &Sources, tp::MachineCode &Code) {
  SmallString<128> Directory;
  if (!sys::fs::current_path(Directory))
    Code.Context.setCompilationDir(Directory);
  Code.Context.setDwarfDebugProducer("tp-mc");
  Code.describeLines(
      InputFilename,
      Sources.getMemoryBuffer(Sources.getMainFileID())->getBuffer());
}

static bool assemble(SourceMgr &Sources, tp::MachineCode &Code,
                     MCStreamer &Streamer) {
  if (DebugInfo)
    describeSource(Sources, Code);
  return Code.assemble(Sources, Streamer);
}

static bool disassemble(SourceMgr &Sources, tp::MachineCode &Code,
                        MCStreamer &Streamer) {
  StringRef Text =
      Sources.getMemoryBuffer(Sources.getMainFileID())->getBuffer();
  tp::HexBytes Bytes;
  bool Good = tp::parseHexBytes(Text, Sources, Bytes);
  std::unique_ptr<MCDisassembler> Disassembler = Code.createDisassembler();
  Streamer.initSections(/*NoExecStack=*/false, *Code.Subtarget);
  uint64_t Size;
  for (size_t Index = 0; Index < Bytes.Values.size(); Index += Size) {
    MCInst Instruction;
    auto Status = Disassembler->getInstruction(
        Instruction, Size, ArrayRef(Bytes.Values).drop_front(Index), Index,
        nulls());
    if (Status == MCDisassembler::Success) {
      Streamer.emitInstruction(Instruction, *Code.Subtarget);
      continue;
    }
    Sources.PrintMessage(SMLoc::getFromPointer(Bytes.Places[Index]),
                         SourceMgr::DK_Error,
                         Size < 4 ? "an instruction has 4 bytes"
                                  : "these 4 bytes are no instruction");
    Good = false;
  }
  Streamer.finish();
  return Good;
}

int main(int argc, char **argv) {
  InitLLVM Init(argc, argv);
  cl::HideUnrelatedOptions(Category);
  cl::ParseCommandLineOptions(argc, argv, "The TP's assembler\n");

  ErrorOr<std::unique_ptr<MemoryBuffer>> Input =
      MemoryBuffer::getFileOrSTDIN(InputFilename, /*IsText=*/true);
  if (std::error_code Error = Input.getError())
    return fail("'" + InputFilename + "': " + Error.message());

  SourceMgr Sources;
  Sources.AddNewSourceBuffer(std::move(*Input), SMLoc());
  Sources.setIncludeDirs(IncludeDirectories);
  Sources.setVirtualFileSystem(vfs::getRealFileSystem());

  std::error_code Error;
  ToolOutputFile Output(OutputFilename, Error,
                        FileType == OutputKind::Object
                            ? sys::fs::OF_None
                            : sys::fs::OF_TextWithCRLF);
  if (Error)
    return fail("'" + OutputFilename + "': " + Error.message());
  // An object's writer goes back in its output, which a pipe cannot.
  std::unique_ptr<buffer_ostream> Buffered;
  raw_pwrite_stream *Stream = &Output.os();
  if (FileType == OutputKind::Object && !Output.os().supportsSeeking()) {
    Buffered = std::make_unique<buffer_ostream>(Output.os());
    Stream = Buffered.get();
  }

  MCTargetOptions Options;
  Options.AsmVerbose = true;
  Options.ShowMCEncoding = ShowEncoding;
  tp::MachineCode Code(&Sources, Options);
  Code.Syntax->setPreserveAsmComments(false);
  std::unique_ptr<MCStreamer> Streamer = createStreamer(Code, *Stream);
  bool Good = Disassemble ? disassemble(Sources, Code, *Streamer)
                          : assemble(Sources, Code, *Streamer);
  if (!Good || Code.Context.hadError())
    return 1;
  Output.keep();
  return 0;
}
