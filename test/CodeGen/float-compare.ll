; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define i1 @oeq(float %a, float %b) {
; CHECK-LABEL: oeq:
; CHECK: c_eq_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp oeq float %a, %b
  ret i1 %r
}
define i1 @ogt(float %a, float %b) {
; CHECK-LABEL: ogt:
; CHECK: c_olt_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp ogt float %a, %b
  ret i1 %r
}
define i1 @oge(float %a, float %b) {
; CHECK-LABEL: oge:
; CHECK: c_ole_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp oge float %a, %b
  ret i1 %r
}
define i1 @olt(float %a, float %b) {
; CHECK-LABEL: olt:
; CHECK: c_olt_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp olt float %a, %b
  ret i1 %r
}
define i1 @ole(float %a, float %b) {
; CHECK-LABEL: ole:
; CHECK: c_ole_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp ole float %a, %b
  ret i1 %r
}
define i1 @one(float %a, float %b) {
; CHECK-LABEL: one:
; CHECK: c_one_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp one float %a, %b
  ret i1 %r
}
define i1 @ord(float %a, float %b) {
; CHECK-LABEL: ord:
; CHECK: c_or_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp ord float %a, %b
  ret i1 %r
}
define i1 @ueq(float %a, float %b) {
; CHECK-LABEL: ueq:
; CHECK: c_ueq_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp ueq float %a, %b
  ret i1 %r
}
define i1 @ugt(float %a, float %b) {
; CHECK-LABEL: ugt:
; CHECK: c_ult_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp ugt float %a, %b
  ret i1 %r
}
define i1 @uge(float %a, float %b) {
; CHECK-LABEL: uge:
; CHECK: c_ule_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp uge float %a, %b
  ret i1 %r
}
define i1 @ult(float %a, float %b) {
; CHECK-LABEL: ult:
; CHECK: c_ult_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp ult float %a, %b
  ret i1 %r
}
define i1 @ule(float %a, float %b) {
; CHECK-LABEL: ule:
; CHECK: c_ule_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp ule float %a, %b
  ret i1 %r
}
define i1 @une(float %a, float %b) {
; CHECK-LABEL: une:
; CHECK: c_une_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp une float %a, %b
  ret i1 %r
}
define i1 @uno(float %a, float %b) {
; CHECK-LABEL: uno:
; CHECK: c_un_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp uno float %a, %b
  ret i1 %r
}
define void @branch_oeq(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_oeq:
; CHECK: c_une_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB14_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB14_2:
; CHECK-NEXT: ret
  %r = fcmp oeq float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ogt(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ogt:
; CHECK: c_ule_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB15_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB15_2:
; CHECK-NEXT: ret
  %r = fcmp ogt float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_oge(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_oge:
; CHECK: c_ult_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB16_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB16_2:
; CHECK-NEXT: ret
  %r = fcmp oge float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_olt(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_olt:
; CHECK: c_ule_s r12, f5, f4
; CHECK-NEXT: bne r12, r0, .LBB17_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB17_2:
; CHECK-NEXT: ret
  %r = fcmp olt float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ole(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ole:
; CHECK: c_ult_s r12, f5, f4
; CHECK-NEXT: bne r12, r0, .LBB18_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB18_2:
; CHECK-NEXT: ret
  %r = fcmp ole float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_one(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_one:
; CHECK: c_ueq_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB19_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB19_2:
; CHECK-NEXT: ret
  %r = fcmp one float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ueq(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ueq:
; CHECK: c_one_s r12, f4, f5
; CHECK-NEXT: beq r12, r0, .LBB20_2
; CHECK: ret
; CHECK-NEXT: .LBB20_2:
; CHECK-NEXT: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: ret
  %r = fcmp ueq float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ugt(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ugt:
; CHECK: c_ole_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB21_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB21_2:
; CHECK-NEXT: ret
  %r = fcmp ugt float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_uge(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_uge:
; CHECK: c_olt_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB22_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB22_2:
; CHECK-NEXT: ret
  %r = fcmp uge float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ult(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ult:
; CHECK: c_ole_s r12, f5, f4
; CHECK-NEXT: bne r12, r0, .LBB23_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB23_2:
; CHECK-NEXT: ret
  %r = fcmp ult float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_ule(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_ule:
; CHECK: c_olt_s r12, f5, f4
; CHECK-NEXT: bne r12, r0, .LBB24_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB24_2:
; CHECK-NEXT: ret
  %r = fcmp ule float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define void @branch_une(float %a, float %b, ptr %p) {
; CHECK-LABEL: branch_une:
; CHECK: c_eq_s r12, f4, f5
; CHECK-NEXT: bne r12, r0, .LBB25_2
; CHECK: addi r12, r0, 1
; CHECK-NEXT: sw r12, 0(r4)
; CHECK-NEXT: .LBB25_2:
; CHECK-NEXT: ret
  %r = fcmp une float %a, %b
  br i1 %r, label %yes, label %no
yes:
  store i32 1, ptr %p
  ret void
no:
  ret void
}
define i1 @fast_eq(float %a, float %b) {
; CHECK-LABEL: fast_eq:
; CHECK: c_eq_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp nnan oeq float %a, %b
  ret i1 %r
}
define i1 @fast_gt(float %a, float %b) {
; CHECK-LABEL: fast_gt:
; CHECK: c_olt_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp nnan ogt float %a, %b
  ret i1 %r
}
define i1 @fast_ge(float %a, float %b) {
; CHECK-LABEL: fast_ge:
; CHECK: c_ole_s r4, f5, f4
; CHECK-NEXT: ret
  %r = fcmp nnan oge float %a, %b
  ret i1 %r
}
define i1 @fast_lt(float %a, float %b) {
; CHECK-LABEL: fast_lt:
; CHECK: c_olt_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp nnan olt float %a, %b
  ret i1 %r
}
define i1 @fast_le(float %a, float %b) {
; CHECK-LABEL: fast_le:
; CHECK: c_ole_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp nnan ole float %a, %b
  ret i1 %r
}
define i1 @fast_ne(float %a, float %b) {
; CHECK-LABEL: fast_ne:
; CHECK: c_une_s r4, f4, f5
; CHECK-NEXT: ret
  %r = fcmp nnan une float %a, %b
  ret i1 %r
}
