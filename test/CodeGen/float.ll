; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

define float @arithmetic(float %a, float %b) {
; CHECK-LABEL: arithmetic:
; CHECK: add_s f12, f4, f5
; CHECK-NEXT: sub_s f12, f12, f5
; CHECK-NEXT: mul_s f12, f12, f5
; CHECK-NEXT: div_s f12, f12, f5
; CHECK-NEXT: sqrt_s f4, f12
; CHECK-NEXT: ret
  %c = fadd float %a, %b
  %d = fsub float %c, %b
  %e = fmul float %d, %b
  %f = fdiv float %e, %b
  %g = call float @llvm.sqrt.f32(float %f)
  ret float %g
}
; Multiplication and addition round apart: there is no fused instruction.
define float @no_contraction(float %a, float %b, float %c) {
; CHECK-LABEL: no_contraction:
; CHECK: mul_s f12, f4, f5
; CHECK-NEXT: add_s f4, f12, f6
; CHECK-NEXT: ret
  %d = fmul contract float %a, %b
  %e = fadd contract float %d, %c
  ret float %e
}
define float @fused(float %a, float %b, float %c) {
; CHECK-LABEL: fused:
; CHECK: addi r29, r29, -8
; CHECK-NEXT: sw r31, 4(r29)
; CHECK-NEXT: swc1 f20, 0(r29)
; CHECK-NEXT: mov_s f20, f4
; CHECK-NEXT: jal fmaf
; CHECK-NEXT: add_s f4, f4, f20
; CHECK-NEXT: lwc1 f20, 0(r29)
; CHECK-NEXT: lw r31, 4(r29)
; CHECK-NEXT: addi r29, r29, 8
; CHECK-NEXT: ret
  %d = call float @llvm.fma.f32(float %a, float %b, float %c)
  %e = fadd float %d, %a
  ret float %e
}
define float @muladd(float %a, float %b, float %c) {
; CHECK-LABEL: muladd:
; CHECK: mul_s f12, f4, f5
; CHECK-NEXT: add_s f4, f12, f6
; CHECK-NEXT: ret
  %d = call float @llvm.fmuladd.f32(float %a, float %b, float %c)
  ret float %d
}
define float @sign(float %a, float %b) {
; CHECK-LABEL: sign:
; CHECK: abs_s f12, f4
; CHECK-NEXT: sub_s f4, f5, f12
; CHECK-NEXT: ret
  %c = call float @llvm.fabs.f32(float %a)
  %d = fneg float %c
  %e = fadd float %d, %b
  ret float %e
}
define float @copysign(float %a, float %b) {
; CHECK-LABEL: copysign:
; CHECK: mfc1 r13, f4
; CHECK-NEXT: mfc1 r12, f5
; CHECK-NEXT: ins r12, r13, 0, 30
; CHECK-NEXT: mtc1 f4, r12
; CHECK-NEXT: ret
  %c = call float @llvm.copysign.f32(float %a, float %b)
  ret float %c
}
define float @rounding(float %a) {
; CHECK-LABEL: rounding:
; CHECK: floor_s f12, f4
; CHECK-NEXT: ceil_s f12, f12
; CHECK-NEXT: round_s f12, f12
; CHECK-NEXT: round_s f12, f12
; CHECK-NEXT: round_s f4, f12
; CHECK-NEXT: ret
  %b = call float @llvm.floor.f32(float %a)
  %c = call float @llvm.ceil.f32(float %b)
  %d = call float @llvm.trunc.f32(float %c)
  %e = call float @llvm.rint.f32(float %d)
  %f = call float @llvm.nearbyint.f32(float %e)
  %g = call float @llvm.roundeven.f32(float %f)
  ret float %g
}
define float @extremes(float %a, float %b) {
; CHECK-LABEL: extremes:
; CHECK: min_s f12, f4, f5
; CHECK-NEXT: max_s f12, f12, f5
; CHECK-NEXT: min_s f12, f12, f5
; CHECK-NEXT: max_s f4, f12, f5
; CHECK-NEXT: ret
  %c = call float @llvm.minnum.f32(float %a, float %b)
  %d = call float @llvm.maxnum.f32(float %c, float %b)
  %e = call float @llvm.minimumnum.f32(float %d, float %b)
  %f = call float @llvm.maximumnum.f32(float %e, float %b)
  ret float %f
}
define float @minimum(float %a, float %b) {
; CHECK-LABEL: minimum:
; CHECK: mov_s f12, f4
; CHECK-NEXT: lui r15, 32704
; CHECK-NEXT: c_un_s r13, f12, f5
; CHECK-NEXT: min_s f4, f12, f5
; CHECK-NEXT: mtc1 f13, r15
; CHECK-NEXT: mfc1 r14, f12
; CHECK-NEXT: movn_s f4, f13, r13
; CHECK-NEXT: lui r13, 32768
; CHECK-NEXT: mfc1 r12, f5
; CHECK-NEXT: xor r14, r14, r13
; CHECK-NEXT: mov_s f13, f4
; CHECK-NEXT: movz_s f13, f12, r14
; CHECK-NEXT: xor r12, r12, r13
; CHECK-NEXT: mtc1 f12, r0
; CHECK-NEXT: movz_s f13, f5, r12
; CHECK-NEXT: c_eq_s r12, f4, f12
; CHECK-NEXT: movn_s f4, f13, r12
; CHECK-NEXT: ret
  %c = call float @llvm.minimum.f32(float %a, float %b)
  ret float %c
}
define i32 @to_int(float %a) {
; CHECK-LABEL: to_int:
; CHECK: trunc_w_s r14, f4
; CHECK-NEXT: trunc_wu_s r13, f4
; CHECK-NEXT: xor r15, r14, r13
; CHECK-NEXT: xor r14, r15, r14
; CHECK-NEXT: round_w_s r12, f4
; CHECK-NEXT: xor r13, r14, r13
; CHECK-NEXT: xor r4, r13, r12
; CHECK-NEXT: ret
  %b = fptosi float %a to i32
  %c = fptoui float %a to i32
  %d = call i32 @llvm.fptosi.sat.i32.f32(float %a)
  %e = call i32 @llvm.fptoui.sat.i32.f32(float %a)
  %f = call i32 @llvm.lrint.i32.f32(float %a)
  %g = xor i32 %b, %c
  %h = xor i32 %g, %d
  %i = xor i32 %h, %e
  %j = xor i32 %i, %f
  ret i32 %j
}
define i8 @to_byte(float %a) {
; CHECK-LABEL: to_byte:
; CHECK: lui r12, 49920
; CHECK-NEXT: mtc1 f12, r12
; CHECK-NEXT: lui r12, 17150
; CHECK-NEXT: max_s f12, f4, f12
; CHECK-NEXT: mtc1 f13, r12
; CHECK-NEXT: min_s f12, f12, f13
; CHECK-NEXT: trunc_w_s r4, f12
; CHECK-NEXT: c_un_s r12, f4, f4
; CHECK-NEXT: movn r4, r0, r12
; CHECK-NEXT: ret
  %b = call i8 @llvm.fptosi.sat.i8.f32(float %a)
  ret i8 %b
}
define float @from_int(i32 %a) {
; CHECK-LABEL: from_int:
; CHECK: cvt_s_w f12, r4
; CHECK-NEXT: cvt_s_wu f13, r4
; CHECK-NEXT: add_s f4, f12, f13
; CHECK-NEXT: ret
  %b = sitofp i32 %a to float
  %c = uitofp i32 %a to float
  %d = fadd float %b, %c
  ret float %d
}
define i32 @bits(float %a) {
; CHECK-LABEL: bits:
; CHECK: mfc1 r4, f4
; CHECK-NEXT: ret
  %b = bitcast float %a to i32
  ret i32 %b
}
define float @from_bits(i32 %a) {
; CHECK-LABEL: from_bits:
; CHECK: mtc1 f4, r4
; CHECK-NEXT: ret
  %b = bitcast i32 %a to float
  ret float %b
}
define float @library(float %a, float %b) {
; CHECK-LABEL: library:
; CHECK: addi r29, r29, -16
; CHECK-NEXT: sw r31, 12(r29)
; CHECK-NEXT: swc1 f20, 8(r29)
; CHECK-NEXT: swc1 f21, 4(r29)
; CHECK-NEXT: mov_s f21, f5
; CHECK-NEXT: mov_s f20, f4
; CHECK-NEXT: jal fmodf
; CHECK-NEXT: jal sinf
; CHECK-NEXT: mov_s f5, f21
; CHECK-NEXT: jal powf
; CHECK-NEXT: jal roundf
; CHECK-NEXT: add_s f4, f4, f20
; CHECK-NEXT: lwc1 f21, 4(r29)
; CHECK-NEXT: lwc1 f20, 8(r29)
; CHECK-NEXT: lw r31, 12(r29)
; CHECK-NEXT: addi r29, r29, 16
; CHECK-NEXT: ret
  %c = frem float %a, %b
  %d = call float @llvm.sin.f32(float %c)
  %e = call float @llvm.pow.f32(float %d, float %b)
  %f = call float @llvm.round.f32(float %e)
  %g = fadd float %f, %a
  ret float %g
}
define float @canonical(float %a) {
; CHECK-LABEL: canonical:
; CHECK: lui r12, 16256
; CHECK-NEXT: mtc1 f12, r12
; CHECK-NEXT: mul_s f4, f4, f12
; CHECK-NEXT: ret
  %b = call float @llvm.canonicalize.f32(float %a)
  ret float %b
}
define i1 @is_nan(float %a) {
; CHECK-LABEL: is_nan:
; CHECK: c_un_s r4, f4, f4
; CHECK-NEXT: ret
  %b = call i1 @llvm.is.fpclass.f32(float %a, i32 3)
  ret i1 %b
}
define float @strict(float %a, float %b) strictfp {
; CHECK-LABEL: strict:
; CHECK: add_s f12, f4, f5
; CHECK-NEXT: c_olt_s r12, f12, f5
; CHECK-NEXT: movn_s f5, f12, r12
; CHECK-NEXT: mov_s f4, f5
; CHECK-NEXT: ret
  %c = call float @llvm.experimental.constrained.fadd.f32(float %a, float %b, metadata !"round.tonearest", metadata !"fpexcept.strict") strictfp
  %d = call i1 @llvm.experimental.constrained.fcmp.f32(float %c, float %b, metadata !"olt", metadata !"fpexcept.strict") strictfp
  %e = select i1 %d, float %c, float %b
  ret float %e
}
