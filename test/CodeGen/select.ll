; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @condition(i1 %c, i32 %a, i32 %b) {
; CHECK-LABEL: condition:
; CHECK: andi r12, r4, 1
; CHECK-NEXT: movn r6, r5, r12
; CHECK-NEXT: move r4, r6
; CHECK-NEXT: ret
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define float @condition_float(i1 %c, float %a, float %b) {
; CHECK-LABEL: condition_float:
; CHECK: andi r12, r4, 1
; CHECK-NEXT: movn_s f5, f4, r12
; CHECK-NEXT: mov_s f4, f5
; CHECK-NEXT: ret
  %r = select i1 %c, float %a, float %b
  ret float %r
}
define i32 @equal(i32 %x, i32 %y, i32 %a, i32 %b) {
; CHECK-LABEL: equal:
; CHECK: xor r12, r4, r5
; CHECK-NEXT: movz r7, r6, r12
; CHECK-NEXT: move r4, r7
; CHECK-NEXT: ret
  %c = icmp eq i32 %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define i32 @zero(i32 %x, i32 %a, i32 %b) {
; CHECK-LABEL: zero:
; CHECK: movz r6, r5, r4
; CHECK-NEXT: move r4, r6
; CHECK-NEXT: ret
  %c = icmp eq i32 %x, 0
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define i32 @greater_equal(i32 %x, i32 %y, i32 %a, i32 %b) {
; CHECK-LABEL: greater_equal:
; CHECK: slt r12, r4, r5
; CHECK-NEXT: movz r7, r6, r12
; CHECK-NEXT: move r4, r7
; CHECK-NEXT: ret
  %c = icmp sge i32 %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define float @float_condition(float %x, float %y, float %a, float %b) {
; CHECK-LABEL: float_condition:
; CHECK: c_olt_s r12, f5, f4
; CHECK-NEXT: movn_s f7, f6, r12
; CHECK-NEXT: mov_s f4, f7
; CHECK-NEXT: ret
  %c = fcmp ogt float %x, %y
  %r = select i1 %c, float %a, float %b
  ret float %r
}
define i32 @float_chooses_int(float %x, float %y, i32 %a, i32 %b) {
; CHECK-LABEL: float_chooses_int:
; CHECK: c_ule_s r12, f4, f5
; CHECK-NEXT: movn r5, r4, r12
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: ret
  %c = fcmp ule float %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}

; Zero is what is moved: r0 needs no copy.
define i32 @or_zero(i32 %c, i32 %a) {
; CHECK-LABEL: or_zero:
; CHECK: movz r5, r0, r4
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: ret
  %t = icmp ne i32 %c, 0
  %r = select i1 %t, i32 %a, i32 0
  ret i32 %r
}
define i32 @positive_part(i32 %a) {
; CHECK-LABEL: positive_part:
; CHECK: slti r12, r4, 1
; CHECK-NEXT: movn r4, r0, r12
; CHECK-NEXT: mul r4, r4, r4
; CHECK-NEXT: ret
  %r = call i32 @llvm.smax.i32(i32 %a, i32 0)
  %d = mul i32 %r, %r
  ret i32 %d
}
declare i32 @llvm.smax.i32(i32, i32)

; Compares with a constant: one instruction, and the other move where it is of
; the opposite condition.
define i32 @above_constant(i32 %c, i32 %a, i32 %b) {
; CHECK-LABEL: above_constant:
; CHECK: slti r12, r4, 100
; CHECK-NEXT: movz r6, r5, r12
; CHECK-NEXT: move r4, r6
; CHECK-NEXT: ret
  %t = icmp sgt i32 %c, 99
  %r = select i1 %t, i32 %a, i32 %b
  ret i32 %r
}
define float @above_unsigned_constant(i32 %c, float %a, float %b) {
; CHECK-LABEL: above_unsigned_constant:
; CHECK: sltiu r12, r4, 100
; CHECK-NEXT: movz_s f5, f4, r12
; CHECK-NEXT: mov_s f4, f5
; CHECK-NEXT: ret
  %t = icmp ugt i32 %c, 99
  %r = select i1 %t, float %a, float %b
  ret float %r
}
define i32 @equal_constant(i32 %c, i32 %a, i32 %b) {
; CHECK-LABEL: equal_constant:
; CHECK: xori r12, r4, 7
; CHECK-NEXT: movz r6, r5, r12
; CHECK-NEXT: move r4, r6
; CHECK-NEXT: ret
  %t = icmp eq i32 %c, 7
  %r = select i1 %t, i32 %a, i32 %b
  ret i32 %r
}
; The next number is not one of 16 bits.
define i32 @above_largest(i32 %c, i32 %a, i32 %b) {
; CHECK-LABEL: above_largest:
; CHECK: addi r12, r0, 32767
; CHECK-NEXT: slt r12, r12, r4
; CHECK-NEXT: movn r6, r5, r12
; CHECK-NEXT: move r4, r6
; CHECK-NEXT: ret
  %t = icmp sgt i32 %c, 32767
  %r = select i1 %t, i32 %a, i32 %b
  ret i32 %r
}
; Constants by arithmetic.
define i32 @sixteen_or_zero(float %x) {
; CHECK-LABEL: sixteen_or_zero:
; CHECK: mtc1 f12, r0
; CHECK-NEXT: c_olt_s r12, f4, f12
; CHECK-NEXT: sll r4, r12, 4
; CHECK-NEXT: ret
  %t = fcmp olt float %x, 0.0
  %r = select i1 %t, i32 16, i32 0
  ret i32 %r
}
define i1 @either_differs(i32 %a, i32 %b, i32 %c) {
; CHECK-LABEL: either_differs:
; CHECK: xor r12, r4, r5
; CHECK-NEXT: not r13, r6
; CHECK-NEXT: or r12, r12, r13
; CHECK-NEXT: sltu r4, r0, r12
; CHECK-NEXT: ret
  %x = icmp ne i32 %a, %b
  %y = icmp ne i32 %c, -1
  %r = or i1 %x, %y
  ret i1 %r
}
