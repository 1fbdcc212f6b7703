//===- TPInstrPatterns.td - Selection of what is not one instruction ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

//===----------------------------------------------------------------------===//
// Constants and addresses
//===----------------------------------------------------------------------===//

def LowHalf : SDNodeXForm<imm, [{
  return CurDAG->getTargetConstant(N->getZExtValue() & 0xffff, SDLoc(N),
                                   MVT::i32);
}]>;
def HighHalf : SDNodeXForm<imm, [{
  return CurDAG->getTargetConstant((N->getZExtValue() >> 16) & 0xffff,
                                   SDLoc(N), MVT::i32);
}]>;
def highHalfOnly : ImmLeaf<i32, [{ return (Imm & 0xffff) == 0; }]>;

def : Pat<(i32 simm16:$i), (ADDI (i32 R0), simm16:$i)>;
def : Pat<(i32 uimm16:$i), (ORI (i32 R0), uimm16:$i)>;
def : Pat<(i32 highHalfOnly:$i), (LUI (HighHalf imm:$i))>;
def : Pat<(i32 imm:$i), (ORI (LUI (HighHalf imm:$i)), (LowHalf imm:$i))>;

foreach symbol = [tglobaladdr, tglobaltlsaddr, tconstpool, tjumptable,
                  tblockaddress, texternalsym] in {
  def : Pat<(TPHi symbol:$s), (LUI symbol:$s)>;
  def : Pat<(TPLo symbol:$s), (ADDI (i32 R0), symbol:$s)>;
  def : Pat<(add (i32 GPR:$high), (TPLo symbol:$s)), (ADDI GPR:$high, symbol:$s)>;
}

def : Pat<(TPCall (i32 tglobaladdr:$callee)), (JAL tglobaladdr:$callee)>;
def : Pat<(TPCall (i32 texternalsym:$callee)), (JAL texternalsym:$callee)>;
def : Pat<(TPTailCall (i32 tglobaladdr:$callee)), (TAIL_J tglobaladdr:$callee)>;
def : Pat<(TPTailCall (i32 texternalsym:$callee)), (TAIL_J texternalsym:$callee)>;

//===----------------------------------------------------------------------===//
// Memory
//===----------------------------------------------------------------------===//

multiclass LoadPatterns<SDPatternOperator node, ValueType type,
                        Instruction offset, Instruction indexed> {
  def : Pat<(type (node (AddrRI (i32 GPR:$base), (i32 simm16:$offset)))),
            (offset GPR:$base, simm16:$offset)>;
  let AddedComplexity = 1 in
  def : Pat<(type (node (AddrRR (i32 GPR:$base), (i32 GPR:$index)))),
            (indexed GPR:$base, GPR:$index)>;
}

multiclass StorePatterns<SDPatternOperator node, ValueType type,
                         RegisterClass valueClass, Instruction offset,
                         Instruction indexed> {
  def : Pat<(node (type valueClass:$value),
                  (AddrRI (i32 GPR:$base), (i32 simm16:$offset))),
            (offset valueClass:$value, GPR:$base, simm16:$offset)>;
  let AddedComplexity = 1 in
  def : Pat<(node (type valueClass:$value),
                  (AddrRR (i32 GPR:$base), (i32 GPR:$index))),
            (indexed valueClass:$value, GPR:$base, GPR:$index)>;
}

defm : LoadPatterns<load, i32, LW, LWX>;
defm : LoadPatterns<load, f32, LWC1, LWXC1>;
defm : LoadPatterns<sextloadi8, i32, LB, LBX>;
defm : LoadPatterns<zextloadi8, i32, LBU, LBUX>;
defm : LoadPatterns<extloadi8, i32, LBU, LBUX>;
defm : LoadPatterns<sextloadi16, i32, LH, LHX>;
defm : LoadPatterns<zextloadi16, i32, LHU, LHUX>;
defm : LoadPatterns<extloadi16, i32, LHU, LHUX>;
defm : StorePatterns<store, i32, GPR, SW, SWX>;
defm : StorePatterns<store, f32, FPR, SWC1, SWXC1>;
defm : StorePatterns<truncstorei8, i32, GPR, SB, SBX>;
defm : StorePatterns<truncstorei16, i32, GPR, SH, SHX>;

// Aligned loads and stores of up to a word are atomic as they are.
class AtomicLoadPattern<SDPatternOperator node, Instruction instruction,
                        ValueType type = i32>
    : Pat<(type (node (AddrRI (i32 GPR:$base), (i32 simm16:$offset)))),
          (instruction GPR:$base, simm16:$offset)>;
class AtomicStorePattern<SDPatternOperator node, Instruction instruction>
    : Pat<(node (i32 GPR:$value),
                (AddrRI (i32 GPR:$base), (i32 simm16:$offset))),
          (instruction GPR:$value, GPR:$base, simm16:$offset)>;

def atomic_load_f32 : PatFrag<(ops node:$address),
                              (atomic_load node:$address)> {
  let IsAtomic = true;
  let MemoryVT = f32;
}

def : AtomicLoadPattern<atomic_load_azext_8, LBU>;
def : AtomicLoadPattern<atomic_load_sext_8, LB>;
def : AtomicLoadPattern<atomic_load_azext_16, LHU>;
def : AtomicLoadPattern<atomic_load_sext_16, LH>;
def : AtomicLoadPattern<atomic_load_nonext_32, LW>;
def : AtomicLoadPattern<atomic_load_f32, LWC1, f32>;
def : AtomicStorePattern<atomic_store_8, SB>;
def : AtomicStorePattern<atomic_store_16, SH>;
def : AtomicStorePattern<atomic_store_32, SW>;

// Atomic subtraction adds the negative; the hardware has no such instruction.
def : Pat<(i32 (atomic_load_sub_i32 (i32 GPR:$rs), (i32 GPR:$rt))),
          (ATOM_ADD (SUB (i32 R0), GPR:$rt), GPR:$rs)>;

//===----------------------------------------------------------------------===//
// Logic
//===----------------------------------------------------------------------===//

def : Pat<(i32 (not (i32 GPR:$a))), (NOR GPR:$a, (i32 R0))>;

//===----------------------------------------------------------------------===//
// Shifts use the low five bits of the amount
//===----------------------------------------------------------------------===//

def lowFiveBits : ImmLeaf<i32, [{ return (Imm & 31) == 31; }]>;

class MaskedShift<SDPatternOperator node, Instruction instruction>
    : Pat<(i32 (node (i32 GPR:$a), (and (i32 GPR:$b), lowFiveBits))),
          (instruction GPR:$a, GPR:$b)>;

def : MaskedShift<shl, SLLV>;
def : MaskedShift<srl, SRLV>;
def : MaskedShift<sra, SRAV>;
def : MaskedShift<rotr, ROTRV>;
// 31 - b, the other half of a shift of two words.
class ComplementShift<SDPatternOperator node, Instruction instruction>
    : Pat<(i32 (node (i32 GPR:$a), (and (not (i32 GPR:$b)), lowFiveBits))),
          (instruction GPR:$a, (NOR GPR:$b, (i32 R0)))>;

def : ComplementShift<shl, SLLV>;
def : ComplementShift<srl, SRLV>;

//===----------------------------------------------------------------------===//
// Integer compares
//===----------------------------------------------------------------------===//

def NegatedSImm16 : SDNodeXForm<imm, [{
  return CurDAG->getSignedTargetConstant(-N->getSExtValue(), SDLoc(N),
                                         MVT::i32);
}]>;
def nonzeroSImm16 : ImmLeaf<i32, [{
  return Imm != 0 && isInt<16>(Imm) && isInt<16>(-Imm);
}]>;

def nonzeroUImm16 : ImmLeaf<i32, [{ return Imm != 0 && isUInt<16>(Imm); }]>;
// x > b is !(x < b + 1), unless b + 1 overflows.
def incrementable : ImmLeaf<i32, [{
  return isInt<16>(Imm) && isInt<16>(Imm + 1);
}]>;
def incrementableUnsigned : ImmLeaf<i32, [{
  return Imm != -1 && isInt<16>(Imm) && isInt<16>(Imm + 1);
}]>;
def Incremented : SDNodeXForm<imm, [{
  return CurDAG->getSignedTargetConstant(N->getSExtValue() + 1, SDLoc(N),
                                         MVT::i32);
}]>;

def : Pat<(i32 (seteq (i32 GPR:$a), 0)), (SLTIU GPR:$a, 1)>;
def : Pat<(i32 (setne (i32 GPR:$a), 0)), (SLTU (i32 R0), GPR:$a)>;
def : Pat<(i32 (setgt (i32 GPR:$a), incrementable:$b)),
          (XORI (SLTI $a, (Incremented imm:$b)), 1)>;
def : Pat<(i32 (setugt (i32 GPR:$a), incrementableUnsigned:$b)),
          (XORI (SLTIU $a, (Incremented imm:$b)), 1)>;
def : Pat<(i32 (seteq (i32 GPR:$a), nonzeroSImm16:$b)),
          (SLTIU (ADDI GPR:$a, (NegatedSImm16 imm:$b)), 1)>;
def : Pat<(i32 (setne (i32 GPR:$a), nonzeroSImm16:$b)),
          (SLTU (i32 R0), (ADDI GPR:$a, (NegatedSImm16 imm:$b)))>;
def : Pat<(i32 (seteq (i32 GPR:$a), (i32 GPR:$b))), (SLTIU (XOR $a, $b), 1)>;
def : Pat<(i32 (setne (i32 GPR:$a), (i32 GPR:$b))),
          (SLTU (i32 R0), (XOR $a, $b))>;
def : Pat<(i32 (setgt (i32 GPR:$a), (i32 GPR:$b))), (SLT $b, $a)>;
def : Pat<(i32 (setugt (i32 GPR:$a), (i32 GPR:$b))), (SLTU $b, $a)>;
def : Pat<(i32 (setge (i32 GPR:$a), (i32 GPR:$b))), (XORI (SLT $a, $b), 1)>;
def : Pat<(i32 (setuge (i32 GPR:$a), (i32 GPR:$b))), (XORI (SLTU $a, $b), 1)>;
def : Pat<(i32 (setle (i32 GPR:$a), (i32 GPR:$b))), (XORI (SLT $b, $a), 1)>;
def : Pat<(i32 (setule (i32 GPR:$a), (i32 GPR:$b))), (XORI (SLTU $b, $a), 1)>;
def : Pat<(i32 (setge (i32 GPR:$a), simm16:$b)), (XORI (SLTI $a, simm16:$b), 1)>;
def : Pat<(i32 (setuge (i32 GPR:$a), simm16:$b)),
          (XORI (SLTIU $a, simm16:$b), 1)>;

//===----------------------------------------------------------------------===//
// Float compares whose order does not matter (no NaN expected)
//===----------------------------------------------------------------------===//

def : Pat<(i32 (seteq (f32 FPR:$a), (f32 FPR:$b))), (C_EQ_S $a, $b)>;
def : Pat<(i32 (setne (f32 FPR:$a), (f32 FPR:$b))), (C_UNE_S $a, $b)>;
def : Pat<(i32 (setlt (f32 FPR:$a), (f32 FPR:$b))), (C_OLT_S $a, $b)>;
def : Pat<(i32 (setle (f32 FPR:$a), (f32 FPR:$b))), (C_OLE_S $a, $b)>;

// No compare raises an exception, so the strict ones are the others.
class StrictComparePattern<SDPatternOperator node, CondCode condition,
                           Instruction instruction>
    : Pat<(i32 (node (f32 FPR:$a), (f32 FPR:$b), condition)),
          (instruction $a, $b)>;

foreach node = [strict_fsetcc, strict_fsetccs] in {
  def : StrictComparePattern<node, SETUO, C_UN_S>;
  def : StrictComparePattern<node, SETO, C_OR_S>;
  def : StrictComparePattern<node, SETOEQ, C_EQ_S>;
  def : StrictComparePattern<node, SETEQ, C_EQ_S>;
  def : StrictComparePattern<node, SETUNE, C_UNE_S>;
  def : StrictComparePattern<node, SETNE, C_UNE_S>;
  def : StrictComparePattern<node, SETUEQ, C_UEQ_S>;
  def : StrictComparePattern<node, SETONE, C_ONE_S>;
  def : StrictComparePattern<node, SETOLT, C_OLT_S>;
  def : StrictComparePattern<node, SETLT, C_OLT_S>;
  def : StrictComparePattern<node, SETOLE, C_OLE_S>;
  def : StrictComparePattern<node, SETLE, C_OLE_S>;
  def : StrictComparePattern<node, SETULT, C_ULT_S>;
  def : StrictComparePattern<node, SETULE, C_ULE_S>;
}

//===----------------------------------------------------------------------===//
// Selects
//===----------------------------------------------------------------------===//

// A compare that costs a select nothing, or one instruction: what the
// conditional move looks at, and whether the compare holds where that is zero.
class SelectTest<dag condition, dag value, bit holdsForZero> {
  dag Condition = condition;
  dag Value = value;
  bit HoldsForZero = holdsForZero;
}

defvar SelectTests = [
  SelectTest<(seteq (i32 GPR:$a), 0), (ops GPR:$a), true>,
  SelectTest<(setne (i32 GPR:$a), 0), (ops GPR:$a), false>,
  SelectTest<(seteq (i32 GPR:$a), (i32 GPR:$b)), (ops (XOR $a, $b)), true>,
  SelectTest<(setne (i32 GPR:$a), (i32 GPR:$b)), (ops (XOR $a, $b)), false>,
  SelectTest<(setge (i32 GPR:$a), (i32 GPR:$b)), (ops (SLT $a, $b)), true>,
  SelectTest<(setle (i32 GPR:$a), (i32 GPR:$b)), (ops (SLT $b, $a)), true>,
  SelectTest<(setuge (i32 GPR:$a), (i32 GPR:$b)), (ops (SLTU $a, $b)), true>,
  SelectTest<(setule (i32 GPR:$a), (i32 GPR:$b)), (ops (SLTU $b, $a)), true>,
  SelectTest<(seteq (i32 GPR:$a), nonzeroUImm16:$b), (ops (XORI $a, (LowHalf imm:$b))), true>,
  SelectTest<(setne (i32 GPR:$a), nonzeroUImm16:$b), (ops (XORI $a, (LowHalf imm:$b))), false>,
  SelectTest<(setge (i32 GPR:$a), simm16:$b), (ops (SLTI $a, simm16:$b)), true>,
  SelectTest<(setuge (i32 GPR:$a), simm16:$b), (ops (SLTIU $a, simm16:$b)), true>,
  SelectTest<(setgt (i32 GPR:$a), incrementable:$b),
             (ops (SLTI $a, (Incremented imm:$b))), true>,
  SelectTest<(setugt (i32 GPR:$a), incrementableUnsigned:$b),
             (ops (SLTIU $a, (Incremented imm:$b))), true>
];

multiclass SelectPatterns<ValueType type, RegisterClass valueClass,
                          Instruction ifNonzero, Instruction ifZero> {
  foreach test = SelectTests in {
    defvar move = !if(test.HoldsForZero, ifZero, ifNonzero);
    def : Pat<(type (select (i32 test.Condition), (type valueClass:$t),
                            (type valueClass:$f))),
              !con((move valueClass:$f, valueClass:$t),
                   !setdagop(test.Value, move))>;
  }
}

defm : SelectPatterns<i32, GPR, MOVN, MOVZ>;
defm : SelectPatterns<f32, FPR, MOVN_S, MOVZ_S>;

// Moving r0 saves to copy it to the result before.
let AddedComplexity = 10 in {
  foreach test = SelectTests in {
    defvar move = !if(test.HoldsForZero, MOVN, MOVZ);
    def : Pat<(i32 (select (i32 test.Condition), (i32 GPR:$t), 0)),
              !con((move GPR:$t, (i32 R0)), !setdagop(test.Value, move))>;
  }
  def : Pat<(i32 (select (i32 GPR:$condition), (i32 GPR:$t), 0)),
            (MOVZ GPR:$t, (i32 R0), GPR:$condition)>;
}

//===----------------------------------------------------------------------===//
// Conditional branches
//===----------------------------------------------------------------------===//

def : Pat<(brcond (i32 (setgt (i32 GPR:$a), (i32 GPR:$b))), bb:$t),
          (BLT $b, $a, bb:$t)>;
def : Pat<(brcond (i32 (setle (i32 GPR:$a), (i32 GPR:$b))), bb:$t),
          (BGE $b, $a, bb:$t)>;
def : Pat<(brcond (i32 (setugt (i32 GPR:$a), (i32 GPR:$b))), bb:$t),
          (BLTU $b, $a, bb:$t)>;
def : Pat<(brcond (i32 (setule (i32 GPR:$a), (i32 GPR:$b))), bb:$t),
          (BGEU $b, $a, bb:$t)>;
def : Pat<(brcond (i32 (setgt (i32 GPR:$a), -1)), bb:$t),
          (BGE $a, (i32 R0), bb:$t)>;
def : Pat<(brcond (i32 (setlt (i32 GPR:$a), 1)), bb:$t),
          (BGE (i32 R0), $a, bb:$t)>;
def : Pat<(brcond (i32 GPR:$condition), bb:$t),
          (BNE GPR:$condition, (i32 R0), bb:$t)>;

//===----------------------------------------------------------------------===//
// Conversions
//===----------------------------------------------------------------------===//

def : Pat<(i32 (any_fp_to_sint (f32 FPR:$a))), (TRUNC_W_S $a)>;
def : Pat<(i32 (any_fp_to_uint (f32 FPR:$a))), (TRUNC_WU_S $a)>;
def : Pat<(i32 (fp_to_sint_sat (f32 FPR:$a), i32)), (TRUNC_W_S $a)>;
def : Pat<(i32 (fp_to_uint_sat (f32 FPR:$a), i32)), (TRUNC_WU_S $a)>;
def : Pat<(i32 (any_lrint (f32 FPR:$a))), (ROUND_W_S $a)>;
def : Pat<(f32 (any_frint (f32 FPR:$a))), (ROUND_S $a)>;
def : Pat<(f32 (any_fnearbyint (f32 FPR:$a))), (ROUND_S $a)>;

// The reciprocal is rounded like the quotient.
def fpOne : FPImmLeaf<f32, [{ return Imm.isExactlyValue(1.0); }]>;
def : Pat<(f32 (any_fdiv fpOne, (f32 FPR:$a))), (RCP_S $a)>;

// The C library's minimum and maximum leave the sign of zero and signalling
// NaNs open; the TP's instructions decide them.
def : Pat<(f32 (any_fminnum (f32 FPR:$a), (f32 FPR:$b))), (MIN_S $a, $b)>;
def : Pat<(f32 (any_fmaxnum (f32 FPR:$a), (f32 FPR:$b))), (MAX_S $a, $b)>;

//===----------------------------------------------------------------------===//
// Traps
//===----------------------------------------------------------------------===//

def : Pat<(trap), (BREAK 0)>;
def : Pat<(debugtrap), (BREAK 1)>;
