//===- TPMCTargetDesc.h - The TP's machine code layer -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The enumerations that TableGen makes from TP.td, and the factories of the
// machine code layer's parts.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPMCTARGETDESC_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPMCTARGETDESC_H

#include "llvm/MC/MCRegisterInfo.h"
#include "llvm/MC/MCTargetOptions.h"
#include <cstdint>
#include <memory>

namespace llvm {

class MCAsmBackend;
class MCCodeEmitter;
class MCContext;
class MCInstrInfo;
class MCObjectTargetWriter;
class MCRegisterInfo;
class MCSubtargetInfo;
class Target;

/// Makes the encoder of instructions.
MCCodeEmitter *createTPMCCodeEmitter(const MCInstrInfo &MCII, MCContext &Ctx);

/// Makes the part that resolves fixups and pads code.
MCAsmBackend *createTPAsmBackend(const Target &T, const MCSubtargetInfo &STI,
                                 const MCRegisterInfo &MRI,
                                 const MCTargetOptions &Options);

/// Makes the part that turns unresolved fixups into ELF relocations.
std::unique_ptr<MCObjectTargetWriter> createTPELFObjectWriter();

} // namespace llvm

#define GET_REGINFO_ENUM
#include "TPGenRegisterInfo.inc"

#define GET_INSTRINFO_ENUM
#define GET_INSTRINFO_MC_HELPER_DECLS
#include "TPGenInstrInfo.inc"

#define GET_SUBTARGETINFO_ENUM
#include "TPGenSubtargetInfo.inc"

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPMCTARGETDESC_H
