//===- TPCallingConv.td - The TP's calling convention ------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Integer arguments in r4..r11 and float arguments in f4..f11, counted apart;
// the others on the stack in words. Results in r4, r5 and f4, f5, where a caller
// that passes them on wants them. 64-bit values are two words, the low one
// first. A struct passed by value is a pointer to a copy that the caller has
// made. Arguments of a variadic function behind its named ones are all on the
// stack.
//
//===----------------------------------------------------------------------===//

def CC_TP : CallingConv<[
  CCIfType<[i1, i8, i16], CCPromoteToType<i32>>,
  CCIfType<[i32], CCAssignToReg<[R4, R5, R6, R7, R8, R9, R10, R11]>>,
  CCIfType<[f32], CCAssignToReg<[F4, F5, F6, F7, F8, F9, F10, F11]>>,
  CCIfType<[i32, f32], CCAssignToStack<4, 4>>
]>;

// The unnamed arguments of a variadic function. A value that is aligned to
// eight bytes starts at a multiple of eight, where va_arg looks for it.
def CC_TP_Variadic : CallingConv<[
  CCIfType<[i1, i8, i16], CCPromoteToType<i32>>,
  CCIfType<[i32], CCIf<"ArgFlags.isSplit() && ArgFlags.getNonZeroOrigAlign() >= 8",
                       CCAssignToStack<4, 8>>>,
  CCIfType<[i32, f32], CCAssignToStack<4, 4>>
]>;

def RetCC_TP : CallingConv<[
  CCIfType<[i1, i8, i16], CCPromoteToType<i32>>,
  CCIfType<[i32], CCAssignToReg<[R4, R5]>>,
  CCIfType<[f32], CCAssignToReg<[F4, F5]>>
]>;

def CSR_TP : CalleeSavedRegs<(add R31, R30, (sequence "R%u", 16, 23),
                                  (sequence "F%u", 20, 31))>;
