//===- MachineCode.h - The TP's machine code objects ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MACHINECODE_MACHINECODE_H
#define TP_LLVM_BACKEND_MACHINECODE_MACHINECODE_H

#include "llvm/MC/MCAsmBackend.h"
#include "llvm/MC/MCAsmInfo.h"
#include "llvm/MC/MCCodeEmitter.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCDisassembler/MCDisassembler.h"
#include "llvm/MC/MCInstPrinter.h"
#include "llvm/MC/MCInstrAnalysis.h"
#include "llvm/MC/MCInstrInfo.h"
#include "llvm/MC/MCObjectFileInfo.h"
#include "llvm/MC/MCRegisterInfo.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/MC/MCTargetOptions.h"
#include <memory>

namespace llvm {
class SourceMgr;
class Target;
} // namespace llvm

namespace tp {

/// What the TP's backend offers for reading and writing machine code. Making
/// one registers the backend.
class MachineCode {
public:
  /// `Sources`, if given, serves diagnostics and must outlive this object.
  /// `Cpu` and `Features` are those of the target machine, where they matter.
  explicit MachineCode(const llvm::SourceMgr *Sources = nullptr,
                       const llvm::MCTargetOptions &Options = {},
                       llvm::StringRef Cpu = "", llvm::StringRef Features = "");

  std::unique_ptr<llvm::MCInstPrinter> createPrinter() const;
  std::unique_ptr<llvm::MCCodeEmitter> createEncoder();
  std::unique_ptr<llvm::MCAsmBackend> createAsmBackend() const;
  std::unique_ptr<llvm::MCDisassembler> createDisassembler();
  /// A streamer that writes an ELF object; `Output` must be able to seek.
  std::unique_ptr<llvm::MCStreamer>
  createObjectStreamer(llvm::raw_pwrite_stream &Output);

  /// Assembles the main file of `Sources` into `Streamer`.
  /// \returns false after an error, which has been reported.
  bool assemble(llvm::SourceMgr &Sources, llvm::MCStreamer &Streamer);

  /// Makes the next assemble() add DWARF that leads back to the lines of the
  /// file \p Name with the contents \p Text.
  void describeLines(llvm::StringRef Name, llvm::StringRef Text);

  const llvm::Triple TargetTriple;
  const llvm::Target &Target;
  const llvm::MCTargetOptions Options;
  const std::unique_ptr<llvm::MCRegisterInfo> Registers;
  const std::unique_ptr<llvm::MCAsmInfo> Syntax;
  const std::unique_ptr<llvm::MCSubtargetInfo> Subtarget;
  const std::unique_ptr<llvm::MCInstrInfo> Instructions;
  const std::unique_ptr<llvm::MCInstrAnalysis> Analysis;
  llvm::MCContext Context;
  const std::unique_ptr<llvm::MCObjectFileInfo> Sections;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_MACHINECODE_MACHINECODE_H
