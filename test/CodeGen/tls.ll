; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

@counter = thread_local global i32 0
@table = thread_local local_unnamed_addr global [16 x float] zeroinitializer, align 4
@external = external thread_local global i32

define i32 @increment() {
; CHECK-LABEL: increment:
; CHECK: lui r12, %hi(counter)
; CHECK-NEXT: lw r13, %lo(counter)(r12)
; CHECK-NEXT: addi r4, r13, 1
; CHECK-NEXT: sw r4, %lo(counter)(r12)
; CHECK-NEXT: ret
  %p = call ptr @llvm.threadlocal.address.p0(ptr @counter)
  %v = load i32, ptr %p
  %w = add i32 %v, 1
  store i32 %w, ptr %p
  ret i32 %w
}
define float @element(i32 %i) {
; CHECK-LABEL: element:
; CHECK: lui r12, %hi(table)
; CHECK-NEXT: addi r12, r12, %lo(table)
; CHECK-NEXT: sll r13, r4, 2
; CHECK-NEXT: lwxc1 f4, r13(r12)
; CHECK-NEXT: ret
  %p = call ptr @llvm.threadlocal.address.p0(ptr @table)
  %q = getelementptr float, ptr %p, i32 %i
  %v = load float, ptr %q
  ret float %v
}
define ptr @address() {
; CHECK-LABEL: address:
; CHECK: lui r12, %hi(external)
; CHECK-NEXT: addi r4, r12, %lo(external)
; CHECK-NEXT: ret
  %p = call ptr @llvm.threadlocal.address.p0(ptr @external)
  ret ptr %p
}
declare ptr @llvm.threadlocal.address.p0(ptr)
