; Reciprocals and reciprocal square roots.
; RUN: %canonicalize %s | FileCheck %s
; RUN: %canonicalize %without %s | FileCheck --check-prefix=OFF %s

target triple = "x86_64-unknown-linux-gnu"

; CHECK-LABEL: @quotient(
; CHECK-NEXT: [[R:%.*]] = fdiv float 1.000000e+00, %y
; CHECK-NEXT: fmul float %x, [[R]]
; OFF-LABEL: @quotient(
; OFF-NEXT: fdiv fast float %x, %y
define float @quotient(float %x, float %y) {
  %q = fdiv fast float %x, %y
  ret float %q
}

; CHECK-LABEL: @twice(
; CHECK-NEXT: [[YZ:%.*]] = fmul double %y, %z
; CHECK-NEXT: [[R:%.*]] = fdiv double 1.000000e+00, [[YZ]]
; CHECK-NEXT: fmul double %x, [[R]]
; CHECK-NEXT: ret
; OFF-LABEL: @twice(
; OFF-COUNT-2: fdiv fast
define double @twice(double %x, double %y, double %z) {
  %a = fdiv fast double %x, %y
  %b = fdiv fast double %a, %z
  ret double %b
}

; A quotient below a fraction line moves above it.
; CHECK-LABEL: @inverted(
; CHECK-NEXT: [[XZ:%.*]] = fmul float %x, %z
; CHECK-NEXT: [[R:%.*]] = fdiv float 1.000000e+00, %y
; CHECK-NEXT: fmul float [[XZ]], [[R]]
; CHECK-NEXT: ret
define float @inverted(float %x, float %y, float %z) {
  %a = fdiv fast float %y, %z
  %b = fdiv fast float %x, %a
  ret float %b
}

; A literal divisor, if its reciprocal is a normal number.
; CHECK-LABEL: @literal(
; CHECK-NEXT: fmul float %x, 0x3FB99999A0000000
; CHECK-NEXT: ret
define float @literal(float %x) {
  %a = fdiv arcp float %x, 10.0
  ret float %a
}
; CHECK-LABEL: @subnormal_reciprocal(
; CHECK-NEXT: fdiv float %x, 0x47E0000000000000
define float @subnormal_reciprocal(float %x) {
  %a = fdiv arcp float %x, 0x47E0000000000000
  ret float %a
}
; CHECK-LABEL: @zero_divisor(
; CHECK-NEXT: fdiv float %x, 0.000000e+00
define float @zero_divisor(float %x) {
  %a = fdiv arcp float %x, 0.0
  ret float %a
}

; A literal factor goes with the reciprocal.
; CHECK-LABEL: @scaled(
; CHECK-NEXT: [[R:%.*]] = fdiv float 1.000000e+00, %e
; CHECK-NEXT: [[S:%.*]] = fmul float 1.600000e+01, [[R]]
; CHECK-NEXT: fmul float %x, [[S]]
define float @scaled(float %x, float %e) {
  %a = fdiv fast float %x, %e
  %b = fmul fast float 16.0, %a
  ret float %b
}

; Without arcp: a division.
; CHECK-LABEL: @exact(
; CHECK-NEXT: fdiv float %x, %y
define float @exact(float %x, float %y) {
  %q = fdiv reassoc nsz contract afn float %x, %y
  ret float %q
}

; CHECK-LABEL: @reciprocal_root(
; CHECK-NEXT: [[WIDE:%.*]] = fpext float %y to double
; CHECK-NEXT: [[ROOT:%.*]] = call double @llvm.sqrt.f64(double [[WIDE]])
; CHECK-NEXT: [[R:%.*]] = fdiv double 1.000000e+00, [[ROOT]]
; CHECK-NEXT: [[NARROW:%.*]] = fptrunc double [[R]] to float
; CHECK-NEXT: fmul float %x, [[NARROW]]
; CHECK-NEXT: ret
; OFF-LABEL: @reciprocal_root(
; OFF: fdiv fast float %x
define float @reciprocal_root(float %x, float %y) {
  %s = call fast float @llvm.sqrt.f32(float %y)
  %q = fdiv fast float %x, %s
  ret float %q
}
; The library's function, if nobody asks for errno.
; CHECK-LABEL: @library_root(
; CHECK: fptrunc
define float @library_root(float %y) {
  %s = call fast float @sqrtf(float %y)
  %q = fdiv fast float 1.0, %s
  ret float %q
}
; CHECK-LABEL: @library_root_errno(
; CHECK-NOT: fptrunc
; CHECK: fdiv float 1.0
define float @library_root_errno(float %y) {
  %s = call arcp afn float @sqrtf(float %y)
  %q = fdiv arcp afn float 1.0, %s
  ret float %q
}
; CHECK-LABEL: @two_roots(
; CHECK: fptrunc <2 x double> {{.*}} to <2 x float>
define <2 x float> @two_roots(<2 x float> %y) {
  %s = call fast <2 x float> @llvm.sqrt.v2f32(<2 x float> %y)
  %q = fdiv fast <2 x float> splat (float 1.0), %s
  ret <2 x float> %q
}
; Either must be approximate; doubles are divided.
; CHECK-LABEL: @exact_root(
; CHECK: call float @llvm.sqrt.f32
; CHECK-NEXT: fdiv {{.*}}float 1.0
define float @exact_root(float %y) {
  %s = call float @llvm.sqrt.f32(float %y)
  %q = fdiv fast float 1.0, %s
  ret float %q
}
; CHECK-LABEL: @double_root(
; CHECK: call {{.*}}double @llvm.sqrt.f64
; CHECK-NEXT: fdiv {{.*}}double 1.0
; CHECK-NEXT: ret
define double @double_root(double %y) {
  %s = call fast double @llvm.sqrt.f64(double %y)
  %q = fdiv fast double 1.0, %s
  ret double %q
}

declare float @llvm.sqrt.f32(float)
declare <2 x float> @llvm.sqrt.v2f32(<2 x float>)
declare double @llvm.sqrt.f64(double)
declare float @sqrtf(float)
