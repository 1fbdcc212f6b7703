; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i64 @add(i64 %a, i64 %b) {
; CHECK-LABEL: add:
; CHECK: move r12, r4
; CHECK-NEXT: add r4, r12, r6
; CHECK-NEXT: add r13, r5, r7
; CHECK-NEXT: sltu r12, r4, r12
; CHECK-NEXT: add r5, r13, r12
; CHECK-NEXT: ret
  %r = add i64 %a, %b
  ret i64 %r
}
define i64 @sub(i64 %a, i64 %b) {
; CHECK-LABEL: sub:
; CHECK: sltu r12, r4, r6
; CHECK-NEXT: sub r13, r5, r7
; CHECK-NEXT: sub r5, r13, r12
; CHECK-NEXT: sub r4, r4, r6
; CHECK-NEXT: ret
  %r = sub i64 %a, %b
  ret i64 %r
}
define i64 @mul(i64 %a, i64 %b) {
; CHECK-LABEL: mul:
; CHECK: mul r12, r4, r7
; CHECK-NEXT: mulhu r13, r4, r6
; CHECK-NEXT: add r12, r13, r12
; CHECK-NEXT: mul r13, r5, r6
; CHECK-NEXT: add r5, r12, r13
; CHECK-NEXT: mul r4, r4, r6
; CHECK-NEXT: ret
  %r = mul i64 %a, %b
  ret i64 %r
}
define i64 @mul_wide(i32 %a, i32 %b) {
; CHECK-LABEL: mul_wide:
; CHECK: move r12, r4
; CHECK-NEXT: mul r4, r12, r5
; CHECK-NEXT: mulh r5, r12, r5
; CHECK-NEXT: ret
  %c = sext i32 %a to i64
  %d = sext i32 %b to i64
  %r = mul i64 %c, %d
  ret i64 %r
}
define i64 @shl(i64 %a, i64 %s) {
; CHECK-LABEL: shl:
; CHECK: not r13, r6
; CHECK-NEXT: srl r14, r4, 1
; CHECK-NEXT: sllv r12, r5, r6
; CHECK-NEXT: srlv r13, r14, r13
; CHECK-NEXT: or r5, r12, r13
; CHECK-NEXT: sllv r4, r4, r6
; CHECK-NEXT: ext r12, r6, 5, 5
; CHECK-NEXT: movn r5, r4, r12
; CHECK-NEXT: movn r4, r0, r12
; CHECK-NEXT: ret
  %r = shl i64 %a, %s
  ret i64 %r
}
define i64 @lshr_constant(i64 %a) {
; CHECK-LABEL: lshr_constant:
; CHECK: sll r12, r5, 20
; CHECK-NEXT: srl r13, r4, 12
; CHECK-NEXT: or r4, r13, r12
; CHECK-NEXT: srl r5, r5, 12
; CHECK-NEXT: ret
  %r = lshr i64 %a, 12
  ret i64 %r
}
define i64 @ashr(i64 %a, i64 %s) {
; CHECK-LABEL: ashr:
; CHECK: move r12, r5
; CHECK-NEXT: not r14, r6
; CHECK-NEXT: sll r15, r12, 1
; CHECK-NEXT: srlv r13, r4, r6
; CHECK-NEXT: sllv r14, r15, r14
; CHECK-NEXT: or r4, r14, r13
; CHECK-NEXT: srav r5, r12, r6
; CHECK-NEXT: ext r13, r6, 5, 5
; CHECK-NEXT: sra r12, r12, 31
; CHECK-NEXT: movn r4, r5, r13
; CHECK-NEXT: movn r5, r12, r13
; CHECK-NEXT: ret
  %r = ashr i64 %a, %s
  ret i64 %r
}
define i64 @divide(i64 %a, i64 %b) {
; CHECK-LABEL: divide:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r16, 8(r29)
; CHECK-NEXT: sw r17, 4(r29)
; CHECK-NEXT: move r16, r7
; CHECK-NEXT: move r17, r6
; CHECK-NEXT: jal __divdi3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __udivdi3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __moddi3
; CHECK-NEXT: move r6, r17
; CHECK-NEXT: move r7, r16
; CHECK-NEXT: jal __umoddi3
; CHECK-NEXT: lw r17, 4(r29)
; CHECK-NEXT: lw r16, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %c = sdiv i64 %a, %b
  %d = udiv i64 %c, %b
  %e = srem i64 %d, %b
  %f = urem i64 %e, %b
  ret i64 %f
}
define i1 @less(i64 %a, i64 %b) {
; CHECK-LABEL: less:
; CHECK: xor r12, r5, r7
; CHECK-NEXT: sltu r13, r4, r6
; CHECK-NEXT: slt r4, r5, r7
; CHECK-NEXT: movz r4, r13, r12
; CHECK-NEXT: ret
  %r = icmp slt i64 %a, %b
  ret i1 %r
}
define i1 @equal(i64 %a, i64 %b) {
; CHECK-LABEL: equal:
; CHECK: xor r12, r5, r7
; CHECK-NEXT: xor r13, r4, r6
; CHECK-NEXT: or r12, r13, r12
; CHECK-NEXT: sltiu r4, r12, 1
; CHECK-NEXT: ret
  %r = icmp eq i64 %a, %b
  ret i1 %r
}
define i64 @load_store(ptr %p, ptr %q) {
; CHECK-LABEL: load_store:
; CHECK: move r13, r4
; CHECK-NEXT: move r12, r5
; CHECK-NEXT: lw r4, 0(r13)
; CHECK-NEXT: lw r5, 4(r13)
; CHECK-NEXT: sw r4, 0(r12)
; CHECK-NEXT: sw r5, 4(r12)
; CHECK-NEXT: ret
  %v = load i64, ptr %p
  store i64 %v, ptr %q
  ret i64 %v
}
define i64 @from_float(float %x) {
; CHECK-LABEL: from_float:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __fixsfdi
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = fptosi float %x to i64
  ret i64 %r
}
define float @to_float(i64 %x) {
; CHECK-LABEL: to_float:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal __floatundisf
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = uitofp i64 %x to float
  ret float %r
}
define i64 @select(i1 %c, i64 %a, i64 %b) {
; CHECK-LABEL: select:
; CHECK: andi r12, r4, 1
; CHECK-NEXT: movn r7, r5, r12
; CHECK-NEXT: movn r8, r6, r12
; CHECK-NEXT: move r4, r7
; CHECK-NEXT: move r5, r8
; CHECK-NEXT: ret
  %r = select i1 %c, i64 %a, i64 %b
  ret i64 %r
}
