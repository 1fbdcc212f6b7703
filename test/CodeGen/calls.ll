; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare i32 @many(i32, i32, i32, i32, i32, i32, i32, i32, i32, float, i64)
declare float @floats(float, i32, float, double)
@pointer = global ptr null

define i32 @stack_arguments(i32 %x) {
; CHECK-LABEL: stack_arguments:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: addi r13, r0, 1
; CHECK-NEXT: sw r13, 8(r29)
; CHECK-NEXT: addi r13, r0, 2
; CHECK-NEXT: sw r13, 4(r29)
; CHECK-NEXT: lui r13, 16256
; CHECK-NEXT: move r12, r4
; CHECK-NEXT: mtc1 f4, r13
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
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r4, r4, 1
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %r = call i32 @many(i32 1, i32 2, i32 3, i32 4, i32 5, i32 6, i32 7, i32 8, i32 %x, float 1.0, i64 4294967298)
  %s = add i32 %r, 1
  ret i32 %s
}

define float @mixed(float %a, i32 %i, float %b, double %d) {
; CHECK-LABEL: mixed:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: swc1 f20, 0(r29)
; CHECK-NEXT: mov_s f20, f4
; CHECK-NEXT: mov_s f4, f5
; CHECK-NEXT: mov_s f5, f20
; CHECK-NEXT: jal floats
; CHECK-NEXT: add_s f4, f4, f20
; CHECK-NEXT: lwc1 f20, 0(r29)
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %r = call float @floats(float %b, i32 %i, float %a, double %d)
  %s = fadd float %r, %a
  ret float %s
}

define i32 @incoming(i32 %a, i32 %b, i32 %c, i32 %d, i32 %e, i32 %f, i32 %g, i32 %h, i32 %i, i64 %j) {
; CHECK-LABEL: incoming:
; CHECK: lw r12, 4(r29)
; CHECK-NEXT: lw r13, 0(r29)
; CHECK-NEXT: add r4, r13, r12
; CHECK-NEXT: ret
  %t = trunc i64 %j to i32
  %r = add i32 %i, %t
  ret i32 %r
}

define i32 @indirect(i32 %x) {
; CHECK-LABEL: indirect:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: lui r12, %hi(pointer)
; CHECK-NEXT: lw r12, %lo(pointer)(r12)
; CHECK-NEXT: jalr r12
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r4, r4, 1
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %f = load ptr, ptr @pointer
  %r = call i32 %f(i32 %x)
  %s = add i32 %r, 1
  ret i32 %s
}

define i32 @virtual(ptr %object) {
; CHECK-LABEL: virtual:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: lw r12, 0(r4)
; CHECK-NEXT: lw r12, 8(r12)
; CHECK-NEXT: jalr r12
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r4, r4, 1
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %table = load ptr, ptr %object
  %slot = getelementptr ptr, ptr %table, i32 2
  %f = load ptr, ptr %slot
  %r = call i32 %f(ptr %object)
  %s = add i32 %r, 1
  ret i32 %s
}

define i64 @returns_two_words(i64 %x) {
; CHECK-LABEL: returns_two_words:
; CHECK: addi r4, r4, 1
; CHECK-NEXT: sltiu r12, r4, 1
; CHECK-NEXT: add r5, r5, r12
; CHECK-NEXT: ret
  %r = add i64 %x, 1
  ret i64 %r
}

define signext i8 @narrow(i8 signext %a, i16 zeroext %b) {
; CHECK-LABEL: narrow:
; CHECK: add r12, r4, r5
; CHECK-NEXT: seb r4, r12
; CHECK-NEXT: ret
  %t = trunc i16 %b to i8
  %r = add i8 %a, %t
  ret i8 %r
}

declare signext i8 @narrow_callee(i8 signext, i16 zeroext)
define i32 @call_narrow(i32 %x) {
; CHECK-LABEL: call_narrow:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: move r12, r4
; CHECK-NEXT: seb r4, r12
; CHECK-NEXT: andi r5, r12, 65535
; CHECK-NEXT: jal narrow_callee
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r4, r4, 1
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %a = trunc i32 %x to i8
  %b = trunc i32 %x to i16
  %r = call signext i8 @narrow_callee(i8 signext %a, i16 zeroext %b)
  %s = sext i8 %r to i32
  %t = add i32 %s, 1
  ret i32 %t
}
