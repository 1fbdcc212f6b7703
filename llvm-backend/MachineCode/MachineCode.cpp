//===- MachineCode.cpp - The TP's machine code objects --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MachineCode/MachineCode.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/MC/MCObjectWriter.h"
#include "llvm/MC/MCParser/MCAsmParser.h"
#include "llvm/MC/MCParser/MCTargetAsmParser.h"
#include "llvm/MC/TargetRegistry.h"

using namespace llvm;

static const Target &registerTarget() {
  LLVMInitializeTPTargetInfo();
  LLVMInitializeTPTargetMC();
  LLVMInitializeTPAsmParser();
  LLVMInitializeTPDisassembler();
  return getTheTPTarget();
}

namespace tp {

MachineCode::MachineCode(const SourceMgr *Sources,
                         const MCTargetOptions &Options, StringRef Cpu,
                         StringRef Features)
    : TargetTriple(TPTriple), Target(registerTarget()), Options(Options),
      Registers(Target.createMCRegInfo(TargetTriple)),
      Syntax(Target.createMCAsmInfo(*Registers, TargetTriple, Options)),
      Subtarget(Target.createMCSubtargetInfo(TargetTriple, Cpu, Features)),
      Instructions(Target.createMCInstrInfo()),
      Analysis(Target.createMCInstrAnalysis(Instructions.get())),
      Context(TargetTriple, Syntax.get(), Registers.get(), Subtarget.get(),
              Sources, &this->Options),
      Sections(Target.createMCObjectFileInfo(Context, /*PIC=*/false)) {
  Context.setObjectFileInfo(Sections.get());
}

std::unique_ptr<MCInstPrinter> MachineCode::createPrinter() const {
  return std::unique_ptr<MCInstPrinter>(Target.createMCInstPrinter(
      TargetTriple, /*SyntaxVariant=*/0, *Syntax, *Instructions, *Registers));
}

std::unique_ptr<MCCodeEmitter> MachineCode::createEncoder() {
  return std::unique_ptr<MCCodeEmitter>(
      Target.createMCCodeEmitter(*Instructions, Context));
}

std::unique_ptr<MCAsmBackend> MachineCode::createAsmBackend() const {
  return std::unique_ptr<MCAsmBackend>(
      Target.createMCAsmBackend(*Subtarget, *Registers, Options));
}

std::unique_ptr<MCDisassembler> MachineCode::createDisassembler() {
  return std::unique_ptr<MCDisassembler>(
      Target.createMCDisassembler(*Subtarget, Context));
}

std::unique_ptr<MCStreamer>
MachineCode::createObjectStreamer(raw_pwrite_stream &Output) {
  std::unique_ptr<MCAsmBackend> Backend = createAsmBackend();
  std::unique_ptr<MCObjectWriter> Writer = Backend->createObjectWriter(Output);
  return std::unique_ptr<MCStreamer>(Target.createMCObjectStreamer(
      TargetTriple, Context, std::move(Backend), std::move(Writer),
      createEncoder(), *Subtarget));
}

bool MachineCode::assemble(SourceMgr &Sources, MCStreamer &Streamer) {
  std::unique_ptr<MCAsmParser> Parser(
      createMCAsmParser(Sources, Context, Streamer, *Syntax));
  std::unique_ptr<MCTargetAsmParser> TargetParser(
      Target.createMCAsmParser(*Subtarget, *Parser, *Instructions, Options));
  Parser->setTargetParser(*TargetParser);
  return !Parser->Run(/*NoInitialTextSection=*/false);
}

void MachineCode::describeLines(StringRef Name, StringRef Text) {
  Context.setGenDwarfForAssembly(true);
  if (Context.getMainFileName().empty())
    Context.setMainFileName(Name);
  Context.setGenDwarfRootFile(Name, Text);
}

} // namespace tp
