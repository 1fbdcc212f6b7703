; A fused multiply-add is the chip feature "fma": one instruction with it, a
; function of the library without it.
; RUN: %llc_tp -O2 -mattr=+fma -verify-machineinstrs < %s | FileCheck --check-prefixes=CHECK,FMA %s
; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck --check-prefixes=CHECK,LIBRARY %s
; RUN: %llc_tp -O2 -mattr=+fma -tp-fp-canonicalize=0 < %s | FileCheck --check-prefix=UNDECIDED %s
; RUN: %llc_tp -O0 -mattr=+fma -verify-machineinstrs < %s | FileCheck --check-prefix=O0 %s

define float @fused(float %a, float %b, float %c) {
; CHECK-LABEL: fused:
; FMA: madd_s f6, f4, f5
; FMA-NEXT: mov_s f4, f6
; FMA-NEXT: ret
; LIBRARY: jal fmaf
; O0-LABEL: fused:
; O0: madd_s
  %r = call float @llvm.fma.f32(float %a, float %b, float %c)
  ret float %r
}
; Signs are instructions of their own.
define float @negated(float %a, float %b, float %c) {
; CHECK-LABEL: negated:
; FMA: neg_s [[PRODUCT:f[0-9]+]], f4
; FMA: neg_s [[SUM:f[0-9]+]], f6
; FMA: madd_s [[SUM]], [[PRODUCT]], f5
; FMA: neg_s f4,
; LIBRARY: jal fmaf
  %x = fneg float %a
  %y = fneg float %c
  %z = call float @llvm.fma.f32(float %x, float %b, float %y)
  %r = fneg float %z
  ret float %r
}
; The addend is used again: the instruction works on a copy.
define float @addend_is_kept(float %a, float %b, float %c) {
; CHECK-LABEL: addend_is_kept:
; FMA: mov_s [[COPY:f[0-9]+]], f6
; FMA: madd_s [[COPY]], f4, f5
; FMA: mul_s f4, [[COPY]], f6
  %x = call float @llvm.fma.f32(float %a, float %b, float %c)
  %r = fmul float %x, %c
  ret float %r
}
; The front end's a * b + c: the canonicalizer decides whether it is fused, and
; code generation leaves it alone. Without the canonicalizer it is fused where
; that is an instruction.
define float @muladd(float %a, float %b, float %c) {
; CHECK-LABEL: muladd:
; CHECK: mul_s [[PRODUCT:f[0-9]+]], f4, f5
; CHECK: add_s f4, [[PRODUCT]], f6
; UNDECIDED-LABEL: muladd:
; UNDECIDED: madd_s f6, f4, f5
; UNDECIDED-NEXT: mov_s f4, f6
  %r = call float @llvm.fmuladd.f32(float %a, float %b, float %c)
  ret float %r
}
; Without leave to contract, a product and a sum stay apart.
define float @apart(float %a, float %b, float %c) {
; CHECK-LABEL: apart:
; CHECK: mul_s [[PRODUCT:f[0-9]+]], f4, f5
; CHECK: add_s f4, [[PRODUCT]], f6
  %x = fmul float %a, %b
  %r = fadd float %x, %c
  ret float %r
}
; Doubles are software on every chip.
define double @wide(double %a, double %b, double %c) {
; CHECK-LABEL: wide:
; CHECK: jal fma{{$}}
  %r = call double @llvm.fma.f64(double %a, double %b, double %c)
  ret double %r
}
define float @strict(float %a, float %b, float %c) strictfp {
; CHECK-LABEL: strict:
; FMA: madd_s f6, f4, f5
; FMA-NEXT: mov_s f4, f6
  %r = call float @llvm.experimental.constrained.fma.f32(float %a, float %b, float %c, metadata !"round.tonearest", metadata !"fpexcept.strict") strictfp
  ret float %r
}
