; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

; A global load starts before independent work; its user comes last.
define i32 @hoist(ptr %p, i32 %a, i32 %b) {
; CHECK-LABEL: hoist:
; CHECK: lw r13, 0(r4)
; CHECK-NEXT: mul r12, r5, r6
; CHECK-NEXT: add r12, r12, r5
; CHECK-NEXT: mul r12, r12, r6
; CHECK-NEXT: add r4, r13, r12
; CHECK-NEXT: ret
  %c = mul i32 %a, %b
  %d = add i32 %c, %a
  %e = mul i32 %d, %b
  %v = load i32, ptr %p
  %r = add i32 %v, %e
  ret i32 %r
}
; Both loads of a chain of additions start before the first addition.
define float @two_loads(ptr %p, ptr %q, float %x) {
; CHECK-LABEL: two_loads:
; CHECK: lwc1 f12, 0(r4)
; CHECK-NEXT: lwc1 f13, 0(r5)
; CHECK-NEXT: add_s f12, f12, f4
; CHECK-NEXT: add_s f4, f12, f13
; CHECK-NEXT: ret
  %a = load float, ptr %p
  %b = fadd float %a, %x
  %c = load float, ptr %q
  %d = fadd float %b, %c
  ret float %d
}
define void @copy(ptr noalias %p, ptr noalias %q) {
; CHECK-LABEL: copy:
; CHECK: lw r27, 28(r5)
; CHECK-NEXT: lw r26, 24(r5)
; CHECK-NEXT: lw r25, 20(r5)
; CHECK-NEXT: lw r24, 16(r5)
; CHECK-NEXT: lw r15, 12(r5)
; CHECK-NEXT: lw r14, 8(r5)
; CHECK-NEXT: lw r13, 4(r5)
; CHECK-NEXT: lw r12, 0(r5)
; CHECK-NEXT: sw r27, 28(r4)
; CHECK-NEXT: sw r26, 24(r4)
; CHECK-NEXT: sw r25, 20(r4)
; CHECK-NEXT: sw r24, 16(r4)
; CHECK-NEXT: sw r15, 12(r4)
; CHECK-NEXT: sw r14, 8(r4)
; CHECK-NEXT: sw r13, 4(r4)
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: ret
  call void @llvm.memcpy.p0.p0.i32(ptr align 4 %p, ptr align 4 %q, i32 32, i1 false)
  ret void
}
; A division does not keep loads from moving over it.
define i32 @over_division(ptr %p, i32 %a, i32 %b) {
; CHECK-LABEL: over_division:
; CHECK: lw r13, 0(r4)
; CHECK-NEXT: div r12, r5, r6
; CHECK-NEXT: add r12, r13, r12
; CHECK-NEXT: addi r4, r12, 1
; CHECK-NEXT: ret
  %d = sdiv i32 %a, %b
  %v = load i32, ptr %p
  %w = add i32 %v, 1
  %r = add i32 %w, %d
  ret i32 %r
}
