//===- TP.td - The thread processor (TP) target ------------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// These files are the only definition of the TP's instruction set. The build
// derives from them the code generator, assembler, disassembler, encoder,
// schedule model, the simulator's decoder and docs/isa.md.
//
//===----------------------------------------------------------------------===//

include "llvm/Target/Target.td"

//===----------------------------------------------------------------------===//
// Chip features
//===----------------------------------------------------------------------===//

def FeatureTrigonometry
    : SubtargetFeature<"trig", "HasTrigonometry", "true",
                       "The chip has the sin_s and cos_s instructions">;

def FeatureFMA
    : SubtargetFeature<"fma", "HasFMA", "true",
                       "The chip has the fused multiply-add, madd_s">;

include "TPRegisterInfo.td"
include "TPSchedule.td"
include "TPInstrFormats.td"
include "TPInstrInfo.td"
include "TPInstrPatterns.td"
include "TPCallingConv.td"

//===----------------------------------------------------------------------===//
// Processors
//===----------------------------------------------------------------------===//

def : ProcessorModel<"generic", TPSchedModel, [FeatureTrigonometry]>;

//===----------------------------------------------------------------------===//
// Assembler and target
//===----------------------------------------------------------------------===//

def TPAsmParser : AsmParser {
  let ShouldEmitMatchRegisterName = 1;
  let ShouldEmitMatchRegisterAltName = 1;
}

def TPAsmWriter : AsmWriter {
  string AsmWriterClassName = "InstPrinter";
  int PassSubtarget = 0;
}

def TPInstrInfo : InstrInfo;

def TP : Target {
  let InstructionSet = TPInstrInfo;
  let AssemblyParsers = [TPAsmParser];
  let AssemblyWriters = [TPAsmWriter];
}
