; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i32 @condition(i1 %c, i32 %a, i32 %b) {
; CHECK-LABEL: condition:
; CHECK: move r2, r6
; CHECK-NEXT: andi r12, r4, 1
; CHECK-NEXT: movn r2, r5, r12
; CHECK-NEXT: ret
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define float @condition_float(i1 %c, float %a, float %b) {
; CHECK-LABEL: condition_float:
; CHECK: mov_s f0, f5
; CHECK-NEXT: andi r12, r4, 1
; CHECK-NEXT: movn_s f0, f4, r12
; CHECK-NEXT: ret
  %r = select i1 %c, float %a, float %b
  ret float %r
}
define i32 @equal(i32 %x, i32 %y, i32 %a, i32 %b) {
; CHECK-LABEL: equal:
; CHECK: move r2, r7
; CHECK-NEXT: xor r12, r4, r5
; CHECK-NEXT: movz r2, r6, r12
; CHECK-NEXT: ret
  %c = icmp eq i32 %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define i32 @zero(i32 %x, i32 %a, i32 %b) {
; CHECK-LABEL: zero:
; CHECK: move r2, r6
; CHECK-NEXT: movz r2, r5, r4
; CHECK-NEXT: ret
  %c = icmp eq i32 %x, 0
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define i32 @greater_equal(i32 %x, i32 %y, i32 %a, i32 %b) {
; CHECK-LABEL: greater_equal:
; CHECK: move r2, r7
; CHECK-NEXT: slt r12, r4, r5
; CHECK-NEXT: movz r2, r6, r12
; CHECK-NEXT: ret
  %c = icmp sge i32 %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
define float @float_condition(float %x, float %y, float %a, float %b) {
; CHECK-LABEL: float_condition:
; CHECK: mov_s f0, f7
; CHECK-NEXT: c_olt_s r12, f5, f4
; CHECK-NEXT: movn_s f0, f6, r12
; CHECK-NEXT: ret
  %c = fcmp ogt float %x, %y
  %r = select i1 %c, float %a, float %b
  ret float %r
}
define i32 @float_chooses_int(float %x, float %y, i32 %a, i32 %b) {
; CHECK-LABEL: float_chooses_int:
; CHECK: move r2, r5
; CHECK-NEXT: c_ule_s r12, f4, f5
; CHECK-NEXT: movn r2, r4, r12
; CHECK-NEXT: ret
  %c = fcmp ule float %x, %y
  %r = select i1 %c, i32 %a, i32 %b
  ret i32 %r
}
