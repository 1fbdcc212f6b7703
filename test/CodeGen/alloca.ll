; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare void @use(ptr)
declare void @many(i32, i32, i32, i32, i32, i32, i32, i32, i32)
declare ptr @llvm.stacksave()
declare void @llvm.stackrestore(ptr)
define i32 @dynamic(i32 %n, i32 %m) {
; CHECK-LABEL: dynamic:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r30, 8(r29)
; CHECK-NEXT: sw r16, 4(r29)
; CHECK-NEXT: addi r30, r29, 16
; CHECK-NEXT: addi r12, r4, 7
; CHECK-NEXT: addi r13, r0, -8
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: sub r4, r29, r12
; CHECK-NEXT: move r16, r5
; CHECK-NEXT: move r29, r4
; CHECK-NEXT: jal use
; CHECK-NEXT: addi r4, r30, -16
; CHECK-NEXT: jal use
; CHECK-NEXT: addi r29, r29, -8
; CHECK-NEXT: addi r12, r0, 9
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: addi r5, r0, 2
; CHECK-NEXT: addi r6, r0, 3
; CHECK-NEXT: addi r7, r0, 4
; CHECK-NEXT: addi r8, r0, 5
; CHECK-NEXT: addi r9, r0, 6
; CHECK-NEXT: addi r10, r0, 7
; CHECK-NEXT: addi r11, r0, 8
; CHECK-NEXT: sw r12, 0(r29)
; CHECK-NEXT: jal many
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: lw r12, -16(r30)
; CHECK-NEXT: add r4, r12, r16
; CHECK-NEXT: addi r29, r30, -16
; CHECK-NEXT: lw r16, 4(r29)
; CHECK-NEXT: lw r30, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %a = alloca i8, i32 %n
  %b = alloca i32
  call void @use(ptr %a)
  call void @use(ptr %b)
  call void @many(i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7, i32 8, i32 9)
  %v = load i32, ptr %b
  %r = add i32 %v, %m
  ret i32 %r
}
define void @save_restore(i32 %n) {
; CHECK-LABEL: save_restore:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: sw r30, 8(r29)
; CHECK-NEXT: sw r16, 4(r29)
; CHECK-NEXT: addi r30, r29, 16
; CHECK-NEXT: sll r12, r4, 2
; CHECK-NEXT: addi r12, r12, 7
; CHECK-NEXT: addi r13, r0, -8
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: sub r4, r29, r12
; CHECK-NEXT: move r16, r29
; CHECK-NEXT: move r29, r4
; CHECK-NEXT: jal use
; CHECK-NEXT: move r29, r16
; CHECK-NEXT: addi r29, r30, -16
; CHECK-NEXT: lw r16, 4(r29)
; CHECK-NEXT: lw r30, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %s = call ptr @llvm.stacksave()
  %a = alloca i32, i32 %n
  call void @use(ptr %a)
  call void @llvm.stackrestore(ptr %s)
  ret void
}
