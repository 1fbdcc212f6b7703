; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare i32 @callee(i32)
declare i32 @nine(i32, i32, i32, i32, i32, i32, i32, i32, i32)
declare i32 @variadic(i32, ...)
define i32 @direct(i32 %x) {
; CHECK-LABEL: direct:
; CHECK: j callee
  %r = tail call i32 @callee(i32 %x)
  ret i32 %r
}
define i32 @indirect(ptr %f, i32 %x) {
; CHECK-LABEL: indirect:
; CHECK: move r12, r4
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: jr r12
  %r = tail call i32 %f(i32 %x)
  ret i32 %r
}
; The target must not be in a register that the epilogue restores.
define i32 @indirect_with_frame(ptr %f, i32 %x) {
; CHECK-LABEL: indirect_with_frame:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: sw r4, 0(r29)
; CHECK-NEXT: move r4, r5
; CHECK-NEXT: jal callee
; CHECK-NEXT: lw r12, 0(r29)
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: jr r12
  %y = call i32 @callee(i32 %x)
  %r = tail call i32 %f(i32 %y)
  ret i32 %r
}
define i32 @stack_arguments(i32 %x) {
; CHECK-LABEL: stack_arguments:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: move r5, r4
; CHECK-NEXT: move r6, r4
; CHECK-NEXT: move r7, r4
; CHECK-NEXT: move r8, r4
; CHECK-NEXT: move r9, r4
; CHECK-NEXT: move r10, r4
; CHECK-NEXT: move r11, r4
; CHECK-NEXT: sw r4, 0(r29)
; CHECK-NEXT: jal nine
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = tail call i32 @nine(i32 %x, i32 %x, i32 %x, i32 %x, i32 %x, i32 %x, i32 %x, i32 %x, i32 %x)
  ret i32 %r
}
define i32 @varargs(i32 %x) {
; CHECK-LABEL: varargs:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: jal variadic
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = tail call i32 (i32, ...) @variadic(i32 %x)
  ret i32 %r
}
define i32 @must(i32 %x) {
; CHECK-LABEL: must:
; CHECK: j callee
  %r = musttail call i32 @callee(i32 %x)
  ret i32 %r
}
define void @not_tail() {
; CHECK-LABEL: not_tail:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: addi r4, r0, 1
; CHECK-NEXT: jal callee
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = call i32 @callee(i32 1)
  ret void
}
define i32 @must_exchange(i32 %a, i32 %b, i32 %c, i32 %d, i32 %e, i32 %f, i32 %g, i32 %h, i32 %i, i32 %j) {
; CHECK-LABEL: must_exchange:
; CHECK: lw r12, 0(r29)
; CHECK-NEXT: lw r13, 4(r29)
; CHECK-NEXT: sw r13, 0(r29)
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: j must_exchange
  %r = musttail call i32 @must_exchange(i32 %a, i32 %b, i32 %c, i32 %d, i32 %e, i32 %f, i32 %g, i32 %h, i32 %j, i32 %i)
  ret i32 %r
}
define i32 @must_pass_struct(ptr byval([5 x i32]) %a, ptr byval([5 x i32]) %b) {
; CHECK-LABEL: must_pass_struct:
; CHECK: addi r29, r29, -24
; CHECK-NEXT: lw r24, 16(r5)
; CHECK-NEXT: lw r15, 12(r5)
; CHECK-NEXT: lw r14, 8(r5)
; CHECK-NEXT: lw r13, 4(r5)
; CHECK-NEXT: lw r12, 0(r5)
; CHECK-NEXT: sw r24, 20(r29)
; CHECK-NEXT: sw r15, 16(r29)
; CHECK-NEXT: sw r14, 12(r29)
; CHECK-NEXT: sw r13, 8(r29)
; CHECK-NEXT: sw r12, 4(r29)
; CHECK-NEXT: lw r12, 4(r29)
; CHECK-NEXT: lw r13, 8(r29)
; CHECK-NEXT: lw r14, 12(r29)
; CHECK-NEXT: lw r15, 16(r29)
; CHECK-NEXT: lw r24, 20(r29)
; CHECK-NEXT: sw r24, 16(r4)
; CHECK-NEXT: sw r15, 12(r4)
; CHECK-NEXT: sw r14, 8(r4)
; CHECK-NEXT: sw r13, 4(r4)
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: addi r29, r29, 24
; CHECK-NEXT: j must_pass_struct
  %r = musttail call i32 @must_pass_struct(ptr byval([5 x i32]) %b, ptr byval([5 x i32]) %b)
  ret i32 %r
}
define void @must_pass_variadic(ptr %this, ...) {
; CHECK-LABEL: must_pass_variadic:
; CHECK: lw r12, 0(r4)
; CHECK-NEXT: jr r12
  %function = load ptr, ptr %this
  musttail call void (ptr, ...) %function(ptr %this, ...)
  ret void
}
