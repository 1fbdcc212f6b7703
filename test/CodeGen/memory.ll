; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

@array = global [10 x i32] zeroinitializer, align 4
define i32 @offsets(ptr %p) {
; CHECK-LABEL: offsets:
; CHECK: lb r12, 32767(r4)
; CHECK-NEXT: lhu r13, -32768(r4)
; CHECK-NEXT: add r4, r12, r13
; CHECK-NEXT: ret
  %q = getelementptr i8, ptr %p, i32 32767
  %a = load i8, ptr %q
  %b = sext i8 %a to i32
  %r = getelementptr i8, ptr %p, i32 -32768
  %c = load i16, ptr %r
  %d = zext i16 %c to i32
  %e = add i32 %b, %d
  ret i32 %e
}
define i32 @indexed(ptr %p, i32 %i) {
; CHECK-LABEL: indexed:
; CHECK: sll r12, r5, 2
; CHECK-NEXT: lwx r13, r12(r4)
; CHECK-NEXT: sll r12, r5, 1
; CHECK-NEXT: lhx r14, r12(r4)
; CHECK-NEXT: lbux r12, r5(r4)
; CHECK-NEXT: add r13, r13, r14
; CHECK-NEXT: add r4, r13, r12
; CHECK-NEXT: ret
  %q = getelementptr i32, ptr %p, i32 %i
  %a = load i32, ptr %q
  %r = getelementptr i16, ptr %p, i32 %i
  %b = load i16, ptr %r
  %c = sext i16 %b to i32
  %s = getelementptr i8, ptr %p, i32 %i
  %d = load i8, ptr %s
  %e = zext i8 %d to i32
  %f = add i32 %a, %c
  %g = add i32 %f, %e
  ret i32 %g
}
define void @indexed_stores(ptr %p, i32 %i, float %f) {
; CHECK-LABEL: indexed_stores:
; CHECK: sll r12, r5, 2
; CHECK-NEXT: swxc1 f4, r12(r4)
; CHECK-NEXT: sbx r0, r5(r4)
; CHECK-NEXT: ret
  %q = getelementptr float, ptr %p, i32 %i
  store float %f, ptr %q
  %s = getelementptr i8, ptr %p, i32 %i
  store i8 0, ptr %s
  ret void
}
define i32 @global_element() {
; CHECK-LABEL: global_element:
; CHECK: lui r12, %hi(array+12)
; CHECK-NEXT: lw r4, %lo(array+12)(r12)
; CHECK-NEXT: ret
  %v = load i32, ptr getelementptr ([10 x i32], ptr @array, i32 0, i32 3)
  ret i32 %v
}
define ptr @global_address() {
; CHECK-LABEL: global_address:
; CHECK: lui r12, %hi(array)
; CHECK-NEXT: addi r4, r12, %lo(array)
; CHECK-NEXT: ret
  ret ptr @array
}
define i32 @unaligned(ptr %p) {
; CHECK-LABEL: unaligned:
; CHECK: lhu r13, 2(r4)
; CHECK-NEXT: lhu r12, 0(r4)
; CHECK-NEXT: sll r13, r13, 16
; CHECK-NEXT: or r4, r13, r12
; CHECK-NEXT: ret
  %v = load i32, ptr %p, align 2
  ret i32 %v
}
define void @copy_large(ptr %p, ptr %q) {
; CHECK-LABEL: copy_large:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: addi r6, r0, 1000
; CHECK-NEXT: jal memcpy
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  call void @llvm.memcpy.p0.p0.i32(ptr align 4 %p, ptr align 4 %q, i32 1000, i1 false)
  ret void
}
define void @set(ptr %p) {
; CHECK-LABEL: set:
; CHECK: sw r0, 12(r4)
; CHECK-NEXT: sw r0, 8(r4)
; CHECK-NEXT: sw r0, 4(r4)
; CHECK-NEXT: sw r0, 0(r4)
; CHECK-NEXT: ret
  call void @llvm.memset.p0.i32(ptr align 4 %p, i8 0, i32 16, i1 false)
  ret void
}
