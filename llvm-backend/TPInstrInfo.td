//===- TPInstrInfo.td - The TP's instructions --------------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One definition per instruction. To add one: a line here, its body in
// simulator/isa/semantics, its tests in test/MC and test/unit/isa.
//
// Where an instruction has a direct meaning in the selection DAG its pattern
// stands with it; the other patterns are in TPInstrPatterns.td.
//
//===----------------------------------------------------------------------===//

//===----------------------------------------------------------------------===//
// Nodes of the selection DAG
//===----------------------------------------------------------------------===//

def SDT_TPCall : SDTypeProfile<0, -1, [SDTCisVT<0, i32>]>;
def SDT_TPSpecialRegister
    : SDTypeProfile<1, 1, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_TPFloatToInt : SDTypeProfile<1, 1, [SDTCisVT<0, i32>, SDTCisVT<1, f32>]>;
def SDT_TPImmediate : SDTypeProfile<0, 1, [SDTCisVT<0, i32>]>;
def SDT_TPImmediateAndRegister
    : SDTypeProfile<0, 2, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;
def SDT_TPRegister : SDTypeProfile<0, 1, [SDTCisVT<0, i32>]>;
def SDT_TPStreamPush
    : SDTypeProfile<1, 2, [SDTCisVT<0, i32>, SDTCisVT<1, i32>, SDTCisVT<2, i32>]>;
def SDT_TPStreamPop : SDTypeProfile<1, 1, [SDTCisVT<0, i32>, SDTCisVT<1, i32>]>;

// The high and low halves of an address: (hi << 16) + sign-extended lo.
def TPHi : SDNode<"TPISD::HI", SDTIntUnaryOp>;
def TPLo : SDNode<"TPISD::LO", SDTIntUnaryOp>;
def TPRet : SDNode<"TPISD::RET", SDTNone,
                   [SDNPHasChain, SDNPOptInGlue, SDNPVariadic]>;
def TPCall : SDNode<"TPISD::CALL", SDT_TPCall,
                    [SDNPHasChain, SDNPOptInGlue, SDNPOutGlue, SDNPVariadic]>;
def TPTailCall : SDNode<"TPISD::TAIL_CALL", SDT_TPCall,
                        [SDNPHasChain, SDNPOptInGlue, SDNPVariadic]>;
def callseq_start : SDNode<"ISD::CALLSEQ_START",
                           SDCallSeqStart<[SDTCisVT<0, i32>, SDTCisVT<1, i32>]>,
                           [SDNPHasChain, SDNPOutGlue]>;
def callseq_end : SDNode<"ISD::CALLSEQ_END",
                         SDCallSeqEnd<[SDTCisVT<0, i32>, SDTCisVT<1, i32>]>,
                         [SDNPHasChain, SDNPOptInGlue, SDNPOutGlue]>;

def TPRcp : SDNode<"TPISD::RCP", SDTFPUnaryOp>;
def TPRsqrt : SDNode<"TPISD::RSQRT", SDTFPUnaryOp>;
def TPSin : SDNode<"TPISD::SIN", SDTFPUnaryOp>;
def TPCos : SDNode<"TPISD::COS", SDTFPUnaryOp>;
def TPTruncW : SDNode<"TPISD::TRUNC_W", SDT_TPFloatToInt>;
def TPRoundW : SDNode<"TPISD::ROUND_W", SDT_TPFloatToInt>;
def TPFloorW : SDNode<"TPISD::FLOOR_W", SDT_TPFloatToInt>;
def TPCeilW : SDNode<"TPISD::CEIL_W", SDT_TPFloatToInt>;

// A special register that never changes during a run, and one that does.
def TPReadConstant : SDNode<"TPISD::READ_CONSTANT", SDT_TPSpecialRegister>;
def TPReadCounter : SDNode<"TPISD::READ_COUNTER", SDT_TPSpecialRegister,
                           [SDNPHasChain, SDNPSideEffect]>;
def TPBarrier : SDNode<"TPISD::BARRIER", SDTNone, [SDNPHasChain, SDNPSideEffect]>;
def TPSync : SDNode<"TPISD::SYNC", SDTNone, [SDNPHasChain, SDNPSideEffect]>;
def TPSleep : SDNode<"TPISD::SLEEP", SDT_TPRegister,
                     [SDNPHasChain, SDNPSideEffect]>;
def TPHalt : SDNode<"TPISD::HALT", SDT_TPRegister,
                    [SDNPHasChain, SDNPSideEffect]>;
def TPBreak : SDNode<"TPISD::BREAK", SDT_TPImmediate,
                     [SDNPHasChain, SDNPSideEffect]>;
// The values are in r4..r9, by glue.
def TPFpCheckFailed : SDNode<"TPISD::FP_CHECK_FAILED", SDT_TPImmediate,
                             [SDNPHasChain, SDNPInGlue, SDNPSideEffect]>;
def TPProf : SDNode<"TPISD::PROF", SDT_TPImmediate,
                    [SDNPHasChain, SDNPMayStore, SDNPMemOperand]>;
def TPProfV : SDNode<"TPISD::PROFV", SDT_TPImmediateAndRegister,
                     [SDNPHasChain, SDNPMayStore, SDNPMemOperand]>;
// Arguments and result are in r4..r6 and r2, by glue.
def TPHostCall : SDNode<"TPISD::HOSTCALL", SDT_TPImmediate,
                        [SDNPHasChain, SDNPInGlue, SDNPOutGlue,
                         SDNPSideEffect]>;
def TPStreamPush : SDNode<"TPISD::STREAM_PUSH", SDT_TPStreamPush,
                          [SDNPHasChain, SDNPMayLoad, SDNPMayStore,
                           SDNPSideEffect]>;
def TPStreamPop : SDNode<"TPISD::STREAM_POP", SDT_TPStreamPop,
                         [SDNPHasChain, SDNPMayLoad, SDNPMayStore,
                          SDNPSideEffect]>;

//===----------------------------------------------------------------------===//
// Integer arithmetic and logic
//===----------------------------------------------------------------------===//

class IntegerRRR<bits<6> funct, string mnemonic, SDPatternOperator node,
                 TPLatencyClass latencyClass, string action>
    : FormatRRR<OpInteger, funct, GPR, GPR, GPR, mnemonic,
                [(set (i32 GPR:$rd), (node (i32 GPR:$rs), (i32 GPR:$rt)))],
                latencyClass, action>;

class IntegerRR<bits<6> funct, string mnemonic, list<dag> pattern,
                string action>
    : FormatRR<OpInteger, funct, GPR, GPR, mnemonic, pattern, Bitwise, action>;

class IntegerRI<bits<6> opcode, string mnemonic, Operand immediate,
                SDPatternOperator node, TPLatencyClass latencyClass,
                string action>
    : FormatRI<opcode, immediate, mnemonic,
               [(set (i32 GPR:$rd), (node (i32 GPR:$rs), immediate:$imm))],
               latencyClass, action>;

let isCommutable = 1 in {
def ADD : IntegerRRR<1, "add", add, IntAdd, "rd = rs + rt">;
def AND : IntegerRRR<3, "and", and, Bitwise, "rd = rs & rt">;
def OR : IntegerRRR<4, "or", or, Bitwise, "rd = rs | rt">;
def XOR : IntegerRRR<5, "xor", xor, Bitwise, "rd = rs ^ rt">;
def NOR : IntegerRRR<6, "nor", PatFrag<(ops node:$a, node:$b), (not (or $a, $b))>,
                     Bitwise, "rd = ~(rs | rt)">;
def MUL : IntegerRRR<16, "mul", mul, IntMul, "rd = low word of rs * rt">;
def MULH : IntegerRRR<17, "mulh", mulhs, IntMul,
                      "rd = high word of signed rs * rt">;
def MULHU : IntegerRRR<18, "mulhu", mulhu, IntMul,
                       "rd = high word of unsigned rs * rt">;
def ADDC : FormatRRR<OpInteger, 9, GPR, GPR, GPR, "addc", [], IntAdd,
                     "rd = carry out of rs + rt (0 or 1)">;
}
def SUB : IntegerRRR<2, "sub", sub, IntAdd, "rd = rs - rt">;
def SUBC : FormatRRR<OpInteger, 10, GPR, GPR, GPR, "subc", [], IntAdd,
                     "rd = borrow out of rs - rt (0 or 1)">;
def SLT : IntegerRRR<7, "slt", setlt, IntAdd, "rd = rs < rt, signed">;
def SLTU : IntegerRRR<8, "sltu", setult, IntAdd, "rd = rs < rt, unsigned">;

// They trap on division by zero; -2^31 / -1 is -2^31 with remainder 0.
let hasSideEffects = 1 in {
def DIV : IntegerRRR<20, "div", sdiv, IntDiv,
                     "rd = rs / rt, signed, towards zero; traps if rt is 0">;
def DIVU : IntegerRRR<21, "divu", udiv, IntDiv,
                      "rd = rs / rt, unsigned; traps if rt is 0">;
def REM : IntegerRRR<22, "rem", srem, IntDiv,
                     "rd = rs % rt, sign of rs; traps if rt is 0">;
def REMU : IntegerRRR<23, "remu", urem, IntDiv,
                      "rd = rs % rt, unsigned; traps if rt is 0">;
}

let isReMaterializable = 1, isAsCheapAsAMove = 1 in {
def ADDI : IntegerRI<8, "addi", simm16, add, IntAdd, "rd = rs + imm">;
def ORI : IntegerRI<10, "ori", uimm16, or, Bitwise, "rd = rs | imm">;
def LUI : FormatI<14, (outs GPR:$rd), (ins uimm16:$imm), "lui", "$rd, $imm", [],
                  Bitwise, "rd = imm << 16"> {
  bits<5> rd;
  let a = rd;
}
}
def ANDI : IntegerRI<9, "andi", uimm16, and, Bitwise, "rd = rs & imm">;
def XORI : IntegerRI<11, "xori", uimm16, xor, Bitwise, "rd = rs ^ imm">;
def SLTI : IntegerRI<12, "slti", simm16, setlt, IntAdd, "rd = rs < imm, signed">;
def SLTIU : IntegerRI<13, "sltiu", simm16, setult, IntAdd,
                      "rd = rs < sign-extended imm, unsigned">;

//===----------------------------------------------------------------------===//
// Shifts and bit fields
//===----------------------------------------------------------------------===//

class ShiftImmediate<bits<6> funct, string mnemonic, SDPatternOperator node,
                     string action>
    : FormatShift<funct, mnemonic,
                  [(set (i32 GPR:$rd), (node (i32 GPR:$rs), uimm5:$amount))],
                  action>;

def SLL : ShiftImmediate<32, "sll", shl, "rd = rs << amount">;
def SRL : ShiftImmediate<33, "srl", srl, "rd = rs >> amount, unsigned">;
def SRA : ShiftImmediate<34, "sra", sra, "rd = rs >> amount, signed">;
def ROTR : ShiftImmediate<35, "rotr", rotr, "rd = rs rotated right by amount">;
def SLLV : IntegerRRR<36, "sllv", shl, Bitwise, "rd = rs << (rt & 31)">;
def SRLV : IntegerRRR<37, "srlv", srl, Bitwise, "rd = rs >> (rt & 31), unsigned">;
def SRAV : IntegerRRR<38, "srav", sra, Bitwise, "rd = rs >> (rt & 31), signed">;
def ROTRV : IntegerRRR<39, "rotrv", rotr, Bitwise,
                       "rd = rs rotated right by rt & 31">;

def CLZ : IntegerRR<40, "clz", [(set (i32 GPR:$rd), (ctlz (i32 GPR:$rs)))],
                    "rd = leading zeros of rs, 32 for 0">;
def SEB : IntegerRR<41, "seb",
                    [(set (i32 GPR:$rd), (sext_inreg (i32 GPR:$rs), i8))],
                    "rd = sign-extended low byte of rs">;
def SEH : IntegerRR<42, "seh",
                    [(set (i32 GPR:$rd), (sext_inreg (i32 GPR:$rs), i16))],
                    "rd = sign-extended low half of rs">;

// Bit fields are named by their lowest and highest bit, lowest <= highest; the
// reverse is an illegal instruction.
def EXT : FormatR<OpInteger, 43, (outs GPR:$rd),
                  (ins GPR:$rs, uimm5:$lowest, uimm5:$highest), "ext",
                  "$rd, $rs, $lowest, $highest", [], Bitwise,
                  "rd = bits lowest..highest of rs, zero-extended (lowest <= highest)"> {
  bits<5> rd;
  bits<5> rs;
  bits<5> lowest;
  bits<5> highest;
  let a = rd;
  let b = rs;
  let c = lowest;
  let d = highest;
}
def INS : FormatR<OpInteger, 44, (outs GPR:$rd),
                  (ins GPR:$rdold, GPR:$rs, uimm5:$lowest, uimm5:$highest),
                  "ins", "$rd, $rs, $lowest, $highest", [], Bitwise,
                  "bits lowest..highest of rd = low bits of rs (lowest <= highest)"> {
  bits<5> rd;
  bits<5> rs;
  bits<5> lowest;
  bits<5> highest;
  let Constraints = "$rd = $rdold";
  let a = rd;
  let b = rs;
  let c = lowest;
  let d = highest;
}

def MOVN : FormatConditionalMove<45, GPR, "movn",
    [(set (i32 GPR:$rd),
          (select (i32 GPR:$rt), (i32 GPR:$rs), (i32 GPR:$rdold)))],
    "if rt != 0: rd = rs">;
def MOVZ : FormatConditionalMove<46, GPR, "movz", [], "if rt == 0: rd = rs">;

//===----------------------------------------------------------------------===//
// Float arithmetic
//===----------------------------------------------------------------------===//

class FloatRRR<bits<6> funct, string mnemonic, SDPatternOperator node,
               TPLatencyClass latencyClass, string action>
    : FormatRRR<OpFloat, funct, FPR, FPR, FPR, mnemonic,
                [(set (f32 FPR:$rd), (node (f32 FPR:$rs), (f32 FPR:$rt)))],
                latencyClass, action>;

class FloatRR<bits<6> funct, string mnemonic, SDPatternOperator node,
              TPLatencyClass latencyClass, string action>
    : FormatRR<OpFloat, funct, FPR, FPR, mnemonic,
               [(set (f32 FPR:$rd), (node (f32 FPR:$rs)))], latencyClass,
               action>;

let isCommutable = 1 in {
def ADD_S : FloatRRR<1, "add_s", any_fadd, FpAdd, "rd = rs + rt">;
def MUL_S : FloatRRR<3, "mul_s", any_fmul, FpMul, "rd = rs * rt">;
def MIN_S : FloatRRR<8, "min_s", fminimumnum, FpMin,
                     "rd = the smaller; a number wins over a NaN, -0 < +0">;
def MAX_S : FloatRRR<9, "max_s", fmaximumnum, FpMin,
                     "rd = the larger; a number wins over a NaN, -0 < +0">;
}
def SUB_S : FloatRRR<2, "sub_s", any_fsub, FpAdd, "rd = rs - rt">;
def DIV_S : FloatRRR<4, "div_s", any_fdiv, FpInv, "rd = rs / rt">;
def RCP_S : FloatRR<5, "rcp_s", TPRcp, FpInv, "rd = 1 / rs">;
def SQRT_S : FloatRR<6, "sqrt_s", any_fsqrt, FpInv, "rd = square root of rs">;
def RSQRT_S : FloatRR<7, "rsqrt_s", TPRsqrt, FpInv,
                      "rd = 1 / square root of rs, both in double, rounded once">;
let Predicates = [Predicate<"Subtarget->hasTrigonometry()">] in {
def SIN_S : FloatRR<10, "sin_s", TPSin, FpTrig, "rd = sine of rs, within 1 ulp">;
def COS_S : FloatRR<11, "cos_s", TPCos, FpTrig,
                    "rd = cosine of rs, within 1 ulp">;
}

// The sum is the register that the result replaces. An addend that is still
// needed costs a mov_s; signs are neg_s.
let Predicates = [Predicate<"Subtarget->hasFMA()">] in
def MADD_S : FormatAccumulate<19, "madd_s",
    [(set (f32 FPR:$rd),
          (any_fma (f32 FPR:$rs), (f32 FPR:$rt), (f32 FPR:$rdold)))],
    FpMulAdd, "rd = rs * rt + rd, rounded once">;

def ABS_S : FloatRR<12, "abs_s", fabs, Bitwise, "rd = rs without its sign">;
def NEG_S : FloatRR<13, "neg_s", fneg, Bitwise, "rd = rs with its sign flipped">;
def MOV_S : FormatRR<OpFloat, 14, FPR, FPR, "mov_s", [], Bitwise, "rd = rs">;
def MFC1 : FormatRR<OpFloat, 15, GPR, FPR, "mfc1",
                    [(set (i32 GPR:$rd), (bitconvert (f32 FPR:$rs)))], Bitwise,
                    "integer rd = the bits of float rs">;
let isReMaterializable = 1, isAsCheapAsAMove = 1 in
def MTC1 : FormatRR<OpFloat, 16, FPR, GPR, "mtc1",
                    [(set (f32 FPR:$rd), (bitconvert (i32 GPR:$rs)))], Bitwise,
                    "float rd = the bits of integer rs">;

def MOVN_S : FormatConditionalMove<17, FPR, "movn_s",
    [(set (f32 FPR:$rd),
          (select (i32 GPR:$rt), (f32 FPR:$rs), (f32 FPR:$rdold)))],
    "if rt != 0: rd = rs">;
def MOVZ_S : FormatConditionalMove<18, FPR, "movz_s", [], "if rt == 0: rd = rs">;

//===----------------------------------------------------------------------===//
// Float compares: integer rd = 1 or 0
//===----------------------------------------------------------------------===//

class FloatCompare<bits<6> funct, string mnemonic, SDPatternOperator condition,
                   string action>
    : FormatRRR<OpFloat, funct, GPR, FPR, FPR, mnemonic,
                [(set (i32 GPR:$rd), (condition (f32 FPR:$rs), (f32 FPR:$rt)))],
                FpCmp, action>;

let isCommutable = 1 in {
def C_UN_S : FloatCompare<32, "c_un_s", setuo, "rd = rs or rt is NaN">;
def C_OR_S : FloatCompare<33, "c_or_s", seto, "rd = neither is NaN">;
def C_EQ_S : FloatCompare<34, "c_eq_s", setoeq, "rd = rs == rt">;
def C_UNE_S : FloatCompare<35, "c_une_s", setune,
                           "rd = rs != rt, or one is NaN">;
def C_UEQ_S : FloatCompare<36, "c_ueq_s", setueq,
                           "rd = rs == rt, or one is NaN">;
def C_ONE_S : FloatCompare<37, "c_one_s", setone, "rd = rs < rt or rs > rt">;
}
def C_OLT_S : FloatCompare<38, "c_olt_s", setolt, "rd = rs < rt">;
def C_OLE_S : FloatCompare<39, "c_ole_s", setole, "rd = rs <= rt">;
def C_ULT_S : FloatCompare<40, "c_ult_s", setult, "rd = rs < rt, or one is NaN">;
def C_ULE_S : FloatCompare<41, "c_ule_s", setule,
                           "rd = rs <= rt, or one is NaN">;

//===----------------------------------------------------------------------===//
// Conversions. To integer they saturate; NaN gives 0.
//===----------------------------------------------------------------------===//

class FloatToInt<bits<6> funct, string mnemonic, SDPatternOperator node,
                 string action>
    : FormatRR<OpFloat, funct, GPR, FPR, mnemonic,
               [(set (i32 GPR:$rd), (node (f32 FPR:$rs)))], Convert, action>;

class IntToFloat<bits<6> funct, string mnemonic, SDPatternOperator node,
                 string action>
    : FormatRR<OpFloat, funct, FPR, GPR, mnemonic,
               [(set (f32 FPR:$rd), (node (i32 GPR:$rs)))], Convert, action>;

def CVT_S_W : IntToFloat<48, "cvt_s_w", any_sint_to_fp,
                         "float rd = signed integer rs, rounded to nearest even">;
def CVT_S_WU : IntToFloat<49, "cvt_s_wu", any_uint_to_fp,
                          "float rd = unsigned integer rs, rounded to nearest even">;
def TRUNC_W_S : FloatToInt<50, "trunc_w_s", TPTruncW,
                           "signed integer rd = rs rounded towards zero">;
def TRUNC_WU_S : FormatRR<OpFloat, 51, GPR, FPR, "trunc_wu_s", [], Convert,
                          "unsigned integer rd = rs rounded towards zero">;
def ROUND_W_S : FloatToInt<52, "round_w_s", TPRoundW,
                           "signed integer rd = rs rounded to nearest even">;
def FLOOR_W_S : FloatToInt<53, "floor_w_s", TPFloorW,
                           "signed integer rd = rs rounded down">;
def CEIL_W_S : FloatToInt<54, "ceil_w_s", TPCeilW,
                          "signed integer rd = rs rounded up">;
def TRUNC_S : FloatRR<55, "trunc_s", any_ftrunc, Convert,
                      "float rd = rs rounded towards zero to an integer">;
def ROUND_S : FloatRR<56, "round_s", any_froundeven, Convert,
                      "float rd = rs rounded to the nearest even integer">;
def FLOOR_S : FloatRR<57, "floor_s", any_ffloor, Convert,
                      "float rd = rs rounded down to an integer">;
def CEIL_S : FloatRR<58, "ceil_s", any_fceil, Convert,
                     "float rd = rs rounded up to an integer">;

//===----------------------------------------------------------------------===//
// Loads and stores. A misaligned or out-of-range address traps.
//===----------------------------------------------------------------------===//

def LB : FormatLoad<32, GPR, "lb", "rd = sign-extended byte at rs + imm">;
def LBU : FormatLoad<33, GPR, "lbu", "rd = zero-extended byte at rs + imm">;
def LH : FormatLoad<34, GPR, "lh", "rd = sign-extended half at rs + imm">;
def LHU : FormatLoad<35, GPR, "lhu", "rd = zero-extended half at rs + imm">;
def LW : FormatLoad<36, GPR, "lw", "rd = word at rs + imm">;
def LWC1 : FormatLoad<37, FPR, "lwc1", "float rd = word at rs + imm">;
def SB : FormatStore<40, GPR, "sb", "byte at rs + imm = value">;
def SH : FormatStore<41, GPR, "sh", "half at rs + imm = value">;
def SW : FormatStore<42, GPR, "sw", "word at rs + imm = value">;
def SWC1 : FormatStore<43, FPR, "swc1", "word at rs + imm = float value">;

def LBX : FormatLoadIndexed<0, GPR, "lbx", "rd = sign-extended byte at rs + rt">;
def LBUX : FormatLoadIndexed<1, GPR, "lbux", "rd = zero-extended byte at rs + rt">;
def LHX : FormatLoadIndexed<2, GPR, "lhx", "rd = sign-extended half at rs + rt">;
def LHUX : FormatLoadIndexed<3, GPR, "lhux", "rd = zero-extended half at rs + rt">;
def LWX : FormatLoadIndexed<4, GPR, "lwx", "rd = word at rs + rt">;
def LWXC1 : FormatLoadIndexed<5, FPR, "lwxc1", "float rd = word at rs + rt">;
def SBX : FormatStoreIndexed<8, GPR, "sbx", "byte at rs + rt = value">;
def SHX : FormatStoreIndexed<9, GPR, "shx", "half at rs + rt = value">;
def SWX : FormatStoreIndexed<10, GPR, "swx", "word at rs + rt = value">;
def SWXC1 : FormatStoreIndexed<11, FPR, "swxc1", "word at rs + rt = float value">;

//===----------------------------------------------------------------------===//
// Atomics on a word of memory: rd = old value, then the word is changed
//===----------------------------------------------------------------------===//

class AtomicFetch<bits<6> funct, string mnemonic, SDPatternOperator node,
                  string action>
    : FormatAtomic<funct, mnemonic,
                   [(set (i32 GPR:$rd), (node (i32 GPR:$rs), (i32 GPR:$rt)))],
                   action>;

def ATOM_ADD : AtomicFetch<0, "atom_add", atomic_load_add_i32,
                           "rd = word at rs; word += rt">;
def ATOM_AND : AtomicFetch<1, "atom_and", atomic_load_and_i32,
                           "rd = word at rs; word &= rt">;
def ATOM_OR : AtomicFetch<2, "atom_or", atomic_load_or_i32,
                          "rd = word at rs; word |= rt">;
def ATOM_XOR : AtomicFetch<3, "atom_xor", atomic_load_xor_i32,
                           "rd = word at rs; word ^= rt">;
def ATOM_MIN : AtomicFetch<4, "atom_min", atomic_load_min_i32,
                           "rd = word at rs; word = signed minimum with rt">;
def ATOM_MAX : AtomicFetch<5, "atom_max", atomic_load_max_i32,
                           "rd = word at rs; word = signed maximum with rt">;
def ATOM_MINU : AtomicFetch<6, "atom_minu", atomic_load_umin_i32,
                            "rd = word at rs; word = unsigned minimum with rt">;
def ATOM_MAXU : AtomicFetch<7, "atom_maxu", atomic_load_umax_i32,
                            "rd = word at rs; word = unsigned maximum with rt">;
def ATOM_SWAP : AtomicFetch<8, "atom_swap", atomic_swap_i32,
                            "rd = word at rs; word = rt">;
def ATOM_CAS : FormatR<OpAtomic, 9, (outs GPR:$rd),
                       (ins GPR:$rdold, GPR:$rt, GPR:$rs), "atom_cas",
                       "$rd, $rt, (${rs})",
                       [(set (i32 GPR:$rd),
                             (atomic_cmp_swap_i32 (i32 GPR:$rs),
                                                  (i32 GPR:$rdold),
                                                  (i32 GPR:$rt)))],
                       Atomic,
                       "if word at rs == rd: word = rt; rd = the old word"> {
  bits<5> rd;
  bits<5> rs;
  bits<5> rt;
  let Constraints = "$rd = $rdold";
  let mayLoad = 1;
  let mayStore = 1;
  let a = rd;
  let b = rs;
  let c = rt;
}

// A stream is a ring of words behind a descriptor of four words in global
// memory: {words popped, words pushed, capacity (a power of two), reserved}.
let hasSideEffects = 1 in {
def STREAM_PUSH : FormatAtomic<16, "stream_push",
    [(set (i32 GPR:$rd), (TPStreamPush (i32 GPR:$rs), (i32 GPR:$rt)))],
    "append rt to the stream at rs; rd = 1, or 0 if the stream is full">;
def STREAM_POP : FormatR<OpAtomic, 17, (outs GPR:$rd), (ins GPR:$rs),
                         "stream_pop", "$rd, (${rs})",
                         [(set (i32 GPR:$rd), (TPStreamPop (i32 GPR:$rs)))],
                         Atomic,
                         "rd = oldest word of the stream at rs, or -1 if empty"> {
  bits<5> rd;
  bits<5> rs;
  let mayLoad = 1;
  let mayStore = 1;
  let a = rd;
  let b = rs;
}
}

//===----------------------------------------------------------------------===//
// Branches and jumps. There are no delay slots.
//===----------------------------------------------------------------------===//

def BEQ : FormatBranch<48, "beq", seteq, "branch if rs == rt">;
def BNE : FormatBranch<49, "bne", setne, "branch if rs != rt">;
def BLT : FormatBranch<50, "blt", setlt, "branch if rs < rt, signed">;
def BGE : FormatBranch<51, "bge", setge, "branch if rs >= rt, signed">;
def BLTU : FormatBranch<52, "bltu", setult, "branch if rs < rt, unsigned">;
def BGEU : FormatBranch<53, "bgeu", setuge, "branch if rs >= rt, unsigned">;

def BLTZAL : FormatBranchLink<54, "bltzal",
    "if rs < 0: r31 = address of the next instruction, branch">;
def BGEZAL : FormatBranchLink<55, "bgezal",
    "if rs >= 0: r31 = address of the next instruction, branch">;

let isBranch = 1, isTerminator = 1, isBarrier = 1 in {
def J : FormatJ<56, (ins jmptarget:$target), "j", [(br bb:$target)], "jump">;
let isIndirectBranch = 1 in
def JR : FormatControlR<OpControl, 1, "jr", [(brind (i32 GPR:$rs))], Branch,
                        "jump to the address in rs">;
}

let isCall = 1, Defs = [R31] in {
def JAL : FormatJ<57, (ins calltarget:$target), "jal", [],
                  "r31 = address of the next instruction, jump">;
def JALR : FormatControlR<OpControl, 2, "jalr", [(TPCall (i32 GPR:$rs))],
                          Branch,
                          "r31 = address of the next instruction, jump to rs">;
}

//===----------------------------------------------------------------------===//
// Control
//===----------------------------------------------------------------------===//

def BARRIER : FormatControl<3, "barrier", [(TPBarrier)],
    "wait until every thread that has not halted is here">;
def SYNC : FormatControl<4, "sync", [(TPSync)],
    "wait until this thread's stores are visible to all">;
def SLEEP : FormatControlR<OpControl, 5, "sleep", [(TPSleep (i32 GPR:$rs))],
                           Control, "do nothing for rs cycles"> {
  let hasSideEffects = 1;
}
let isTerminator = 1, isBarrier = 1, hasSideEffects = 1 in
def HALT : FormatControlR<OpControl, 6, "halt", [], Control,
                          "end this thread with status rs">;

def TEQ : FormatTrap<8, "teq", "trap if rs == rt">;
def TNE : FormatTrap<9, "tne", "trap if rs != rt">;
def TLT : FormatTrap<10, "tlt", "trap if rs < rt, signed">;
def TGE : FormatTrap<11, "tge", "trap if rs >= rt, signed">;
def TLTU : FormatTrap<12, "tltu", "trap if rs < rt, unsigned">;
def TGEU : FormatTrap<13, "tgeu", "trap if rs >= rt, unsigned">;

class ReadSpecial<list<dag> pattern>
    : FormatR<OpControl, 16, (outs GPR:$rd), (ins sreg:$special), "mfsr",
              "$rd, $special", pattern, Control, "rd = special register"> {
  bits<5> rd;
  bits<5> special;
  let a = rd;
  let c = special;
}
let isReMaterializable = 1, isAsCheapAsAMove = 1 in
def MFSR : ReadSpecial<[(set (i32 GPR:$rd), (TPReadConstant timm:$special))]>;
// For the code generator: a counter's read stays where it is.
let isCodeGenOnly = 1, hasSideEffects = 1 in
def MFSR_COUNTER
    : ReadSpecial<[(set (i32 GPR:$rd), (TPReadCounter timm:$special))]>;

class Break<list<dag> pattern>
    : FormatControlI<58, "break", pattern, "trap with code imm">;
def BREAK : Break<[(TPBreak timm:$imm)]>;
// For the code generator: the values of a failed check are in registers.
let isCodeGenOnly = 1, Uses = [R4, R5, R6, R7, R8, R9] in
def BREAK_FP_CHECK : Break<[(TPFpCheckFailed timm:$imm)]>;
def PROF : FormatProfile<59, (ins), "prof", "$imm", [(TPProf timm:$imm)],
                         "profile marker imm; takes no time">;
def PROFV : FormatProfile<61, (ins GPR:$rs), "profv", "$imm, $rs",
                          [(TPProfV timm:$imm, (i32 GPR:$rs))],
                          "profile marker imm with value rs; takes no time"> {
  bits<5> rs;
  let b = rs;
}
let Uses = [R4, R5, R6], Defs = [R2] in
def HOSTCALL : FormatControlI<60, "hostcall", [(TPHostCall timm:$imm)],
    "service imm of the host: arguments in r4, r5, r6, result in r2">;

//===----------------------------------------------------------------------===//
// Pseudo instructions of the code generator
//===----------------------------------------------------------------------===//

let Defs = [R29], Uses = [R29], hasSideEffects = 1 in {
def ADJCALLSTACKDOWN
    : TPPseudo<(outs), (ins i32imm:$bytes, i32imm:$before),
               [(callseq_start timm:$bytes, timm:$before)]>;
def ADJCALLSTACKUP
    : TPPseudo<(outs), (ins i32imm:$bytes, i32imm:$after),
               [(callseq_end timm:$bytes, timm:$after)]>;
}

// jr r31.
let isReturn = 1, isTerminator = 1, isBarrier = 1, SchedRW = [Branch] in
def RET : TPPseudo<(outs), (ins), [(TPRet)]>;

// j or jr that leaves the function.
let isCall = 1, isTerminator = 1, isReturn = 1, isBarrier = 1, Uses = [R29],
    SchedRW = [Branch] in {
def TAIL_J : TPPseudo<(outs), (ins calltarget:$target), []>;
def TAIL_JR
    : TPPseudo<(outs), (ins GPRTail:$rs), [(TPTailCall (i32 GPRTail:$rs))]>;
}

// A halt whose place among the blocks is left to the code generator (the call
// of a function that does not return need not end its block).
let hasSideEffects = 1, SchedRW = [Control] in
def HALT_CALL : TPPseudo<(outs), (ins GPR:$rs), [(TPHalt (i32 GPR:$rs))]>;

//===----------------------------------------------------------------------===//
// Assembler aliases
//===----------------------------------------------------------------------===//

def : InstAlias<"nop", (ADDI R0, R0, 0)>;
def : InstAlias<"move $rd, $rs", (ADDI GPR:$rd, GPR:$rs, 0)>;
def : InstAlias<"not $rd, $rs", (NOR GPR:$rd, GPR:$rs, R0)>;
def : InstAlias<"neg $rd, $rs", (SUB GPR:$rd, R0, GPR:$rs)>;
def : InstAlias<"beqz $rs, $target", (BEQ GPR:$rs, R0, brtarget:$target), 0>;
def : InstAlias<"bnez $rs, $target", (BNE GPR:$rs, R0, brtarget:$target), 0>;
def : InstAlias<"ret", (JR R31)>;
foreach load = [LB, LBU, LH, LHU, LW] in
  def : InstAlias<load.Mnemonic#" $rd, (${rs})", (load GPR:$rd, GPR:$rs, 0), 0>;
foreach store = [SB, SH, SW] in
  def : InstAlias<store.Mnemonic#" $value, (${rs})",
                  (store GPR:$value, GPR:$rs, 0), 0>;
def : InstAlias<"lwc1 $rd, (${rs})", (LWC1 FPR:$rd, GPR:$rs, 0), 0>;
def : InstAlias<"swc1 $value, (${rs})", (SWC1 FPR:$value, GPR:$rs, 0), 0>;

//===----------------------------------------------------------------------===//
// Assembler macros
//===----------------------------------------------------------------------===//

def LI : TPMacro<(outs GPR:$rd), (ins imm32:$imm), "li", "$rd, $imm",
                 "rd = imm: addi, ori or lui, or lui and ori">;
def LA : TPMacro<(outs GPR:$rd), (ins symbol:$symbol), "la", "$rd, $symbol",
                 "rd = address of symbol: lui %hi(symbol), addi %lo(symbol)">;

defm : RemapAllTargetPseudoPointerOperands<GPR>;
