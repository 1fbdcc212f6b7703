//===- TPInstrFormats.td - Instruction formats of the TP ---*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// All instructions are 32 bits, little-endian, and start with a 6-bit opcode.
//
//            31    26 25   21 20   16 15   11 10    6 5      0
//           +--------+-------+-------+-------+-------+--------+
//   R       | opcode |   a   |   b   |   c   |   d   | funct  |
//           +--------+-------+-------+-------+-------+--------+
//   I       | opcode |   a   |   b   |         imm16          |
//           +--------+-------+-------+------------------------+
//   J       | opcode |                target26                |
//           +--------+----------------------------------------+
//
// A word of zeros is no instruction, so that running into empty memory traps.
//
//===----------------------------------------------------------------------===//

//===----------------------------------------------------------------------===//
// Operands
//===----------------------------------------------------------------------===//

// What the assembler accepts for an operand, and what it says of anything else.
class TPImmediateAsmOperand<string name, string diagnostic>
    : AsmOperandClass {
  let Name = name;
  let RenderMethod = "addImmOperands";
  let DiagnosticType = "Invalid"#name;
  let DiagnosticString = diagnostic;
}

// An immediate of `width` bits. The value that the instruction uses is the field,
// sign-extended where `isSigned`, times `scale`.
class TPImmediate<TPImmediateAsmOperand asmOperand, int width, bit isSigned,
                  int scale, ValueType type = i32> : Operand<type> {
  int Bits = width;
  bit IsSigned = isSigned;
  int Scale = scale;
  let ParserMatchClass = asmOperand;
}

class TPValueImmediate<TPImmediateAsmOperand asmOperand, int width,
                       bit isSigned, code predicate>
    : TPImmediate<asmOperand, width, isSigned, 1>, ImmLeaf<i32, predicate> {
  let EncoderMethod = !if(isSigned, "getSImmValue", "getUImmValue");
  let DecoderMethod =
      !if(isSigned, "decodeSImm<"#width#">", "decodeUImm<"#width#">");
}

def SImm16AsmOperand : TPImmediateAsmOperand<"SImm16",
    "immediate must be an integer in the range [-32768, 32767] or %lo(symbol)">;
def UImm16AsmOperand : TPImmediateAsmOperand<"UImm16",
    "immediate must be an integer in the range [0, 65535] or %hi(symbol)">;
def UImm5AsmOperand : TPImmediateAsmOperand<"UImm5",
    "immediate must be an integer in the range [0, 31]">;

def simm16 : TPValueImmediate<SImm16AsmOperand, 16, 1,
                              [{ return isInt<16>(Imm); }]>;
def uimm16 : TPValueImmediate<UImm16AsmOperand, 16, 0,
                              [{ return isUInt<16>(Imm); }]>;
def uimm5 : TPValueImmediate<UImm5AsmOperand, 5, 0,
                             [{ return isUInt<5>(Imm); }]>;

// A special register by name, or its number.
def SpecialRegisterAsmOperand : TPImmediateAsmOperand<"SpecialRegister",
    "operand must be a special register"> {
  let ParserMethod = "parseSpecialRegister";
}
def sreg : TPImmediate<SpecialRegisterAsmOperand, 5, 0, 1> {
  let EncoderMethod = "getUImmValue";
  let DecoderMethod = "decodeSpecialRegister";
  let PrintMethod = "printSpecialRegister";
}

// Targets are relative to the instruction's own address, in words.
class TPTarget<TPImmediateAsmOperand asmOperand, int width, ValueType type>
    : TPImmediate<asmOperand, width, 1, 4, type> {
  let OperandType = "OPERAND_PCREL";
  let PrintMethod = "printPCRelativeTarget";
  let EncoderMethod = "getTargetValue<"#width#">";
  let DecoderMethod = "decodeTarget<"#width#">";
}

// Any identifier is a symbol here, also one that is a register's name.
let ParserMethod = "parseSymbol" in {
def BranchTargetAsmOperand : TPImmediateAsmOperand<"BranchTarget",
    "branch target must be a symbol or a multiple of 4 in the range "
    "[-131072, 131068]">;
def JumpTargetAsmOperand : TPImmediateAsmOperand<"JumpTarget",
    "jump target must be a symbol or a multiple of 4 in the range "
    "[-134217728, 134217724]">;
def SymbolAsmOperand : TPImmediateAsmOperand<"Symbol",
    "operand must be a symbol or an address in the range [0, 4294967295]">;
}

def brtarget : TPTarget<BranchTargetAsmOperand, 16, OtherVT>;
def jmptarget : TPTarget<JumpTargetAsmOperand, 26, OtherVT>;
def calltarget : TPTarget<JumpTargetAsmOperand, 26, i32>;

// Operands of the assembler's macros.
def Imm32AsmOperand : TPImmediateAsmOperand<"Imm32",
    "immediate must be an integer in the range [-2147483648, 4294967295]">;
def imm32 : TPImmediate<Imm32AsmOperand, 32, 1, 1>;
def symbol : TPImmediate<SymbolAsmOperand, 32, 0, 1>;

// Register plus signed 16-bit offset, and register plus register.
def AddrRI : ComplexPattern<i32, 2, "selectAddrRI">;
def AddrRR : ComplexPattern<i32, 2, "selectAddrRR">;

//===----------------------------------------------------------------------===//
// Base classes
//===----------------------------------------------------------------------===//

class TPInstructionBase<dag outs, dag ins, string asm, list<dag> pattern>
    : Instruction {
  let Namespace = "TP";
  let OutOperandList = outs;
  let InOperandList = ins;
  let AsmString = asm;
  let Pattern = pattern;
  let hasSideEffects = 0;
  let mayLoad = 0;
  let mayStore = 0;
}

// A machine instruction. `time` is the latency class, which names its unit and
// latency, or NoTime; `action`
// says in one line what it does (for the manual; the simulator has the body).
class TPInst<bits<6> opcode, dag outs, dag ins, string mnemonic,
             string operands, list<dag> pattern, TPTime time, string action>
    : TPInstructionBase<outs, ins,
                        mnemonic#!if(!empty(operands), "", "\t"#operands),
                        pattern> {
  field bits<32> Inst;
  field bits<32> SoftFail = 0;
  let Size = 4;
  let DecoderNamespace = "TP";
  let Inst{31-26} = opcode;
  let SchedRW = [time];
  TPTime Time = time;
  string Mnemonic = mnemonic;
  string Action = action;
}

// Exists only in the code generator.
class TPPseudo<dag outs, dag ins, list<dag> pattern>
    : TPInstructionBase<outs, ins, "", pattern> {
  let isPseudo = 1;
  let isCodeGenOnly = 1;
  let Size = 4;
}

// Exists only in the assembler, which makes one or two instructions of it.
class TPMacro<dag outs, dag ins, string mnemonic, string operands,
              string action>
    : TPInstructionBase<outs, ins, mnemonic#"\t"#operands, []> {
  let isPseudo = 1;
  let isAsmParserOnly = 1;
  string Mnemonic = mnemonic;
  string Action = action;
}

//===----------------------------------------------------------------------===//
// R formats
//===----------------------------------------------------------------------===//

defvar OpInteger = 0;
defvar OpFloat = 1;
defvar OpIndexed = 2;
defvar OpAtomic = 3;
defvar OpControl = 4;

class FormatR<bits<6> opcode, bits<6> funct, dag outs, dag ins, string mnemonic,
              string operands, list<dag> pattern, TPLatencyClass latencyClass,
              string action>
    : TPInst<opcode, outs, ins, mnemonic, operands, pattern, latencyClass,
             action> {
  bits<5> a = 0;
  bits<5> b = 0;
  bits<5> c = 0;
  bits<5> d = 0;
  let Inst{25-21} = a;
  let Inst{20-16} = b;
  let Inst{15-11} = c;
  let Inst{10-6} = d;
  let Inst{5-0} = funct;
}

// op rd, rs, rt                                a = rd, b = rs, c = rt
class FormatRRR<bits<6> opcode, bits<6> funct, RegisterClass rdClass,
                RegisterClass rsClass, RegisterClass rtClass, string mnemonic,
                list<dag> pattern, TPLatencyClass latencyClass, string action>
    : FormatR<opcode, funct, (outs rdClass:$rd), (ins rsClass:$rs, rtClass:$rt),
              mnemonic, "$rd, $rs, $rt", pattern, latencyClass, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let a = rd;
  let b = rs;
  let c = rt;
}

// op rd, rs                                    a = rd, b = rs
class FormatRR<bits<6> opcode, bits<6> funct, RegisterClass rdClass,
               RegisterClass rsClass, string mnemonic, list<dag> pattern,
               TPLatencyClass latencyClass, string action>
    : FormatR<opcode, funct, (outs rdClass:$rd), (ins rsClass:$rs), mnemonic,
              "$rd, $rs", pattern, latencyClass, action> {
  bits<5> rd;
  bits<5> rs;
  let a = rd;
  let b = rs;
}

// op rd, rs, amount                            a = rd, b = rs, c = amount
class FormatShift<bits<6> funct, string mnemonic, list<dag> pattern,
                  string action>
    : FormatR<OpInteger, funct, (outs GPR:$rd), (ins GPR:$rs, uimm5:$amount),
              mnemonic, "$rd, $rs, $amount", pattern, Bitwise, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> amount;
  let a = rd;
  let b = rs;
  let c = amount;
}

// op rd, rs, rt where rd keeps its value unless the condition holds.
class FormatConditionalMove<bits<6> funct, RegisterClass valueClass,
                            string mnemonic, list<dag> pattern, string action>
    : FormatR<!if(!eq(valueClass, GPR), OpInteger, OpFloat), funct,
              (outs valueClass:$rd),
              (ins valueClass:$rdold, valueClass:$rs, GPR:$rt), mnemonic,
              "$rd, $rs, $rt", pattern, Bitwise, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let Constraints = "$rd = $rdold";
  let a = rd;
  let b = rs;
  let c = rt;
}

// op rd, rs, rt where rd's old value is the third operand; floats only.
class FormatAccumulate<bits<6> funct, string mnemonic, list<dag> pattern,
                       TPLatencyClass latencyClass, string action>
    : FormatR<OpFloat, funct, (outs FPR:$rd),
              (ins FPR:$rdold, FPR:$rs, FPR:$rt), mnemonic, "$rd, $rs, $rt",
              pattern, latencyClass, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let Constraints = "$rd = $rdold";
  let a = rd;
  let b = rs;
  let c = rt;
}

// op rd, rt(rs): address rs + rt               a = rd, b = rs, c = rt
class FormatLoadIndexed<bits<6> funct, RegisterClass valueClass,
                        string mnemonic, string action>
    : FormatR<OpIndexed, funct, (outs valueClass:$rd), (ins GPR:$rs, GPR:$rt),
              mnemonic, "$rd, ${rt}(${rs})", [], Load, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let mayLoad = 1;
  let a = rd;
  let b = rs;
  let c = rt;
}

// op value, rt(rs): address rs + rt            a = value, b = rs, c = rt
class FormatStoreIndexed<bits<6> funct, RegisterClass valueClass,
                         string mnemonic, string action>
    : FormatR<OpIndexed, funct, (outs), (ins valueClass:$value, GPR:$rs, GPR:$rt),
              mnemonic, "$value, ${rt}(${rs})", [], Store, action> {
  bits<5> value;
  bits<5> rs;
  bits<5> rt;
  let mayStore = 1;
  let a = value;
  let b = rs;
  let c = rt;
}

// op rd, rt, (rs): rd = old memory[rs]         a = rd, b = rs, c = rt
class FormatAtomic<bits<6> funct, string mnemonic, list<dag> pattern,
                   string action>
    : FormatR<OpAtomic, funct, (outs GPR:$rd), (ins GPR:$rt, GPR:$rs),
              mnemonic, "$rd, $rt, (${rs})", pattern, Atomic, action> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let mayLoad = 1;
  let mayStore = 1;
  let a = rd;
  let b = rs;
  let c = rt;
}

// Control without operands.
class FormatControl<bits<6> funct, string mnemonic, list<dag> pattern,
                    string action>
    : FormatR<OpControl, funct, (outs), (ins), mnemonic, "", pattern, Control,
              action> {
  let hasSideEffects = 1;
}

// op rs                                        b = rs
class FormatControlR<bits<6> opcode, bits<6> funct, string mnemonic,
                     list<dag> pattern, TPLatencyClass latencyClass,
                     string action>
    : FormatR<opcode, funct, (outs), (ins GPR:$rs), mnemonic, "$rs", pattern,
              latencyClass, action> {
  bits<5> rs;
  let b = rs;
}

// op rs, rt: trap if the condition holds       b = rs, c = rt
class FormatTrap<bits<6> funct, string mnemonic, string action>
    : FormatR<OpControl, funct, (outs), (ins GPR:$rs, GPR:$rt), mnemonic,
              "$rs, $rt", [], Control, action> {
  bits<5> rs;
  bits<5> rt;
  let hasSideEffects = 1;
  let b = rs;
  let c = rt;
}

//===----------------------------------------------------------------------===//
// I formats
//===----------------------------------------------------------------------===//

class FormatI<bits<6> opcode, dag outs, dag ins, string mnemonic,
              string operands, list<dag> pattern, TPTime time, string action>
    : TPInst<opcode, outs, ins, mnemonic, operands, pattern, time, action> {
  bits<5> a = 0;
  bits<5> b = 0;
  bits<16> imm;
  let Inst{25-21} = a;
  let Inst{20-16} = b;
  let Inst{15-0} = imm;
}

// op rd, rs, imm                               a = rd, b = rs
class FormatRI<bits<6> opcode, Operand immediate, string mnemonic,
               list<dag> pattern, TPLatencyClass latencyClass, string action>
    : FormatI<opcode, (outs GPR:$rd), (ins GPR:$rs, immediate:$imm), mnemonic,
              "$rd, $rs, $imm", pattern, latencyClass, action> {
  bits<5> rd;
  bits<5> rs;
  let a = rd;
  let b = rs;
}

// op rd, imm(rs)                               a = rd, b = rs
class FormatLoad<bits<6> opcode, RegisterClass valueClass, string mnemonic,
                 string action>
    : FormatI<opcode, (outs valueClass:$rd), (ins GPR:$rs, simm16:$imm),
              mnemonic, "$rd, ${imm}(${rs})", [], Load, action> {
  bits<5> rd;
  bits<5> rs;
  let mayLoad = 1;
  let a = rd;
  let b = rs;
}

// op value, imm(rs)                            a = value, b = rs
class FormatStore<bits<6> opcode, RegisterClass valueClass, string mnemonic,
                  string action>
    : FormatI<opcode, (outs), (ins valueClass:$value, GPR:$rs, simm16:$imm),
              mnemonic, "$value, ${imm}(${rs})", [], Store, action> {
  bits<5> value;
  bits<5> rs;
  let mayStore = 1;
  let a = value;
  let b = rs;
}

// op rs, rt, target                            a = rs, b = rt
class FormatBranch<bits<6> opcode, string mnemonic, PatFrag condition,
                   string action>
    : FormatI<opcode, (outs), (ins GPR:$rs, GPR:$rt, brtarget:$imm), mnemonic,
              "$rs, $rt, $imm",
              [(brcond (i32 (condition (i32 GPR:$rs), (i32 GPR:$rt))),
                       bb:$imm)],
              Branch, action> {
  bits<5> rs;
  bits<5> rt;
  let isBranch = 1;
  let isTerminator = 1;
  let a = rs;
  let b = rt;
}

// op rs, target: link if the condition holds   a = rs
class FormatBranchLink<bits<6> opcode, string mnemonic, string action>
    : FormatI<opcode, (outs), (ins GPR:$rs, brtarget:$imm), mnemonic,
              "$rs, $imm", [], Branch, action> {
  bits<5> rs;
  let isCall = 1;
  let hasSideEffects = 1;
  let Defs = [R31];
  let a = rs;
}

// op imm
class FormatControlI<bits<6> opcode, string mnemonic, list<dag> pattern,
                     string action>
    : FormatI<opcode, (outs), (ins uimm16:$imm), mnemonic, "$imm", pattern,
              Control, action> {
  let hasSideEffects = 1;
}

// op imm, values...: a message to the observer of the run. For the code
// generator it is a store to memory of its own (TPProfilePort), so that it stays
// where it is but no access to other memory waits for it.
class FormatProfile<bits<6> opcode, dag values, string mnemonic,
                    string operands, list<dag> pattern, string action>
    : FormatI<opcode, (outs), !con((ins uimm16:$imm), values), mnemonic,
              operands, pattern, NoTime, action> {
  let mayStore = 1;
}

//===----------------------------------------------------------------------===//
// J format
//===----------------------------------------------------------------------===//

class FormatJ<bits<6> opcode, dag ins, string mnemonic, list<dag> pattern,
              string action>
    : TPInst<opcode, (outs), ins, mnemonic, "$target", pattern, Branch,
             action> {
  bits<26> target;
  let Inst{25-0} = target;
}
