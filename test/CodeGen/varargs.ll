; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare i32 @printf(ptr, ...)
declare void @llvm.va_start(ptr)
declare void @llvm.va_end(ptr)
declare void @llvm.va_copy(ptr, ptr)
declare i32 @consume(ptr)

define i32 @caller(ptr %format, i32 %x, double %d) {
; CHECK-LABEL: caller:
; CHECK: addi r29, r29, -40
; CHECK-NEXT: sw r31, 36(r29)
; CHECK-NEXT: addi r12, r0, 1
; CHECK-NEXT: sw r12, 24(r29)
; CHECK-NEXT: addi r12, r0, 5
; CHECK-NEXT: sw r0, 28(r29)
; CHECK-NEXT: sw r12, 16(r29)
; CHECK-NEXT: sw r7, 12(r29)
; CHECK-NEXT: sw r6, 8(r29)
; CHECK-NEXT: sw r5, 0(r29)
; CHECK-NEXT: jal printf
; CHECK-NEXT: lw r31, 36(r29)
; CHECK-NEXT: addi r29, r29, 40
; CHECK-NEXT: ret
  %r = call i32 (ptr, ...) @printf(ptr %format, i32 %x, double %d, i32 5, i64 1)
  ret i32 %r
}
define double @callee(i32 %n, ...) {
; CHECK-LABEL: callee:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: addi r12, r29, 8
; CHECK-NEXT: addi r12, r12, 11
; CHECK-NEXT: addi r13, r0, -8
; CHECK-NEXT: and r12, r12, r13
; CHECK-NEXT: ori r13, r12, 4
; CHECK-NEXT: sw r13, 4(r29)
; CHECK-NEXT: addi r13, r12, 8
; CHECK-NEXT: lw r4, 0(r12)
; CHECK-NEXT: sw r13, 4(r29)
; CHECK-NEXT: lw r5, 4(r12)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %list = alloca ptr
  call void @llvm.va_start(ptr %list)
  %i = va_arg ptr %list, i32
  %d = va_arg ptr %list, double
  call void @llvm.va_end(ptr %list)
  ret double %d
}
define i32 @many_named(i32, i32, i32, i32, i32, i32, i32, i32, i32 %ninth, ...) {
; CHECK-LABEL: many_named:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: lw r4, 12(r29)
; CHECK-NEXT: addi r12, r29, 12
; CHECK-NEXT: addi r12, r12, 4
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %list = alloca ptr
  call void @llvm.va_start(ptr %list)
  %i = va_arg ptr %list, i32
  ret i32 %i
}
define i32 @copy(i32 %n, ...) {
; CHECK-LABEL: copy:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: addi r12, r29, 16
; CHECK-NEXT: addi r4, r29, 4
; CHECK-NEXT: sw r12, 8(r29)
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: jal consume
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %list = alloca ptr
  %list2 = alloca ptr
  call void @llvm.va_start(ptr %list)
  call void @llvm.va_copy(ptr %list2, ptr %list)
  %r = call i32 @consume(ptr %list2)
  ret i32 %r
}
