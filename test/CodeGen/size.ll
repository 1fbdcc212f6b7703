; Functions that are optimized for size: tables instead of compares, and calls
; instead of copies of more than four words.
; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s

define i32 @table(i32 %x, ptr %p) optsize {
; CHECK-LABEL: table:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: addi r12, r0, 4
; CHECK-NEXT: bltu r12, r4, .LBB0_8
; CHECK: lui r13, %hi(.LJTI0_0)
; CHECK-NEXT: sll r12, r4, 2
; CHECK-NEXT: addi r13, r13, %lo(.LJTI0_0)
; CHECK-NEXT: lwx r12, r12(r13)
; CHECK-NEXT: jr r12
; CHECK-NEXT: .LBB0_2:
; CHECK-NEXT: addi r12, r0, 17
; CHECK-NEXT: addi r4, r0, 3
; CHECK-NEXT: j .LBB0_7
; CHECK-NEXT: .LBB0_3:
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: jal g
; CHECK-NEXT: addi r4, r0, 9
; CHECK-NEXT: j .LBB0_9
; CHECK-NEXT: .LBB0_4:
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: jal f
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: j .LBB0_9
; CHECK-NEXT: .LBB0_5:
; CHECK-NEXT: addi r12, r0, 9
; CHECK-NEXT: addi r4, r0, 5
; CHECK-NEXT: j .LBB0_7
; CHECK-NEXT: .LBB0_6:
; CHECK-NEXT: addi r12, r0, 1
; CHECK-NEXT: addi r4, r0, 4
; CHECK-NEXT: .LBB0_7:
; CHECK-NEXT: sw r12, 0(r5)
; CHECK-NEXT: j .LBB0_9
; CHECK-NEXT: .LBB0_8:
; CHECK-NEXT: move r4, r0
; CHECK-NEXT: .LBB0_9:
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  switch i32 %x, label %default [
    i32 0, label %a
    i32 1, label %b
    i32 2, label %c
    i32 3, label %d
    i32 4, label %e
  ]
a:
  store i32 17, ptr %p
  ret i32 3
b:
  store i32 1, ptr %p
  ret i32 4
c:
  call void @f(ptr %p)
  ret i32 1
d:
  store i32 9, ptr %p
  ret i32 5
e:
  call void @g(ptr %p)
  ret i32 9
default:
  ret i32 0
}
declare void @f(ptr)
declare void @g(ptr)

define void @copy(ptr %p, ptr %q) optsize {
; CHECK-LABEL: copy:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: addi r6, r0, 20
; CHECK-NEXT: jal memcpy
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  call void @llvm.memcpy.p0.p0.i32(ptr align 4 %p, ptr align 4 %q, i32 20, i1 false)
  ret void
}
define void @short_copy(ptr %p, ptr %q) optsize {
; CHECK-LABEL: short_copy:
; CHECK: lw r15, 12(r5)
; CHECK-NEXT: lw r14, 8(r5)
; CHECK-NEXT: lw r13, 4(r5)
; CHECK-NEXT: lw r12, 0(r5)
; CHECK-NEXT: sw r15, 12(r4)
; CHECK-NEXT: sw r14, 8(r4)
; CHECK-NEXT: sw r13, 4(r4)
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: ret
  call void @llvm.memcpy.p0.p0.i32(ptr align 4 %p, ptr align 4 %q, i32 16, i1 false)
  ret void
}
