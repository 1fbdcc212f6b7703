; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare void @use(ptr)
define i32 @over_aligned(i32, i32, i32, i32, i32, i32, i32, i32, i32 %ninth) {
; CHECK-LABEL: over_aligned:
; CHECK: addi r29, r29, -64
; CHECK-NEXT: sw r31, 60(r29)
; CHECK-NEXT: sw r30, 56(r29)
; CHECK-NEXT: sw r16, 52(r29)
; CHECK-NEXT: addi r30, r29, 64
; CHECK-NEXT: addi r1, r0, -64
; CHECK-NEXT: and r29, r29, r1
; CHECK-NEXT: lw r16, 0(r30)
; CHECK-NEXT: move r4, r29
; CHECK-NEXT: jal use
; CHECK-NEXT: lw r12, 0(r29)
; CHECK-NEXT: add r4, r12, r16
; CHECK-NEXT: addi r29, r30, -64
; CHECK-NEXT: lw r16, 52(r29)
; CHECK-NEXT: lw r30, 56(r29)
; CHECK-NEXT: lw r31, 60(r29)
; CHECK-NEXT: addi r29, r29, 64
; CHECK-NEXT: ret
  %a = alloca i32, align 64
  call void @use(ptr %a)
  %v = load i32, ptr %a, align 64
  %r = add i32 %v, %ninth
  ret i32 %r
}
define i32 @over_aligned_and_dynamic(i32 %n) {
; CHECK-LABEL: over_aligned_and_dynamic:
; CHECK: addi r29, r29, -32
; CHECK-NEXT: sw r31, 28(r29)
; CHECK-NEXT: sw r30, 24(r29)
; CHECK-NEXT: sw r16, 20(r29)
; CHECK-NEXT: sw r23, 16(r29)
; CHECK-NEXT: addi r30, r29, 32
; CHECK-NEXT: addi r1, r0, -32
; CHECK-NEXT: and r29, r29, r1
; CHECK-NEXT: addi r12, r4, 7
; CHECK-NEXT: addi r13, r0, -8
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: sub r16, r29, r12
; CHECK-NEXT: move r23, r29
; CHECK-NEXT: move r29, r16
; CHECK-NEXT: move r4, r23
; CHECK-NEXT: jal use
; CHECK-NEXT: move r4, r16
; CHECK-NEXT: jal use
; CHECK-NEXT: lw r4, 0(r23)
; CHECK-NEXT: addi r29, r30, -32
; CHECK-NEXT: lw r23, 16(r29)
; CHECK-NEXT: lw r16, 20(r29)
; CHECK-NEXT: lw r30, 24(r29)
; CHECK-NEXT: lw r31, 28(r29)
; CHECK-NEXT: addi r29, r29, 32
; CHECK-NEXT: ret
  %a = alloca i32, align 32
  %b = alloca i8, i32 %n
  call void @use(ptr %a)
  call void @use(ptr %b)
  %v = load i32, ptr %a, align 32
  ret i32 %v
}
