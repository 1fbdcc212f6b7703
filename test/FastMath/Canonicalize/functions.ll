; Powers with literal exponents, library functions, minimum and maximum.
; RUN: %canonicalize %s | FileCheck %s
; RUN: %canonicalize %without %s | FileCheck --check-prefix=OFF %s

; CHECK-LABEL: @cube(
; CHECK-NEXT: [[SQUARE:%.*]] = fmul float %x, %x
; CHECK-NEXT: fmul float %x, [[SQUARE]]
; CHECK-NEXT: ret
; OFF-LABEL: @cube(
; OFF-NEXT: call fast float @llvm.pow.f32
define float @cube(float %x) {
  %p = call fast float @llvm.pow.f32(float %x, float 3.0)
  ret float %p
}
; CHECK-LABEL: @half_power(
; CHECK: [[ROOT:%.*]] = call float @llvm.sqrt.f32(float %x)
; CHECK: [[ABS:%.*]] = call float @llvm.fabs.f32(float [[ROOT]])
; CHECK: [[INF:%.*]] = fcmp oeq float %x, 0xFFF0000000000000
; CHECK: select i1 [[INF]], float 0x7FF0000000000000, float [[ABS]]
define float @half_power(float %x) {
  %p = call float @powf(float %x, float 0.5)
  ret float %p
}
; CHECK-LABEL: @three_halves(
; CHECK: [[ROOT:%.*]] = call float @llvm.sqrt.f32(float %x)
; CHECK-NEXT: fmul float %x, [[ROOT]]
define float @three_halves(float %x) {
  %p = call fast float @llvm.pow.f32(float %x, float 1.5)
  ret float %p
}
; Squares are exact enough without flags, cubes are not.
; CHECK-LABEL: @strict_square(
; CHECK-NEXT: fmul double %x, %x
define double @strict_square(double %x) {
  %p = call double @llvm.pow.f64(double %x, double 2.0)
  ret double %p
}
; CHECK-LABEL: @strict_cube(
; CHECK-NEXT: call double @pow(double %x, double 3.000000e+00) [[OPAQUE:#[0-9]+]]
define double @strict_cube(double %x) {
  %p = call double @llvm.pow.f64(double %x, double 3.0)
  ret double %p
}
; CHECK-LABEL: @general_power(
; CHECK-NEXT: call {{.*}}float @powf(float %x, float %y) [[OPAQUE]]
define float @general_power(float %x, float %y) {
  %p = call fast float @llvm.pow.f32(float %x, float %y)
  ret float %p
}
; CHECK-LABEL: @integer_powers(
; CHECK-NEXT: [[SQUARE:%.*]] = fmul float %x, %x
; CHECK-NEXT: [[CUBE:%.*]] = fmul float %x, [[SQUARE]]
; CHECK-NEXT: fdiv float 1.000000e+00, [[CUBE]]
; CHECK-NEXT: call float @__powisf2(float %x, i32 %n) [[OPAQUE]]
define float @integer_powers(float %x, i32 %n) {
  %a = call float @llvm.powi.f32.i32(float %x, i32 -3)
  %b = call float @llvm.powi.f32.i32(float %x, i32 %n)
  %s = fadd float %a, %b
  ret float %s
}

; The optimizer would evaluate these with the host's library.
; CHECK-LABEL: @sine(
; CHECK-NEXT: call float @sinf(float 1.000000e+00) [[OPAQUE]]
; OFF-LABEL: @sine(
; OFF-NEXT: call float @llvm.sin.f32
define float @sine() {
  %s = call float @llvm.sin.f32(float 1.0)
  ret float %s
}
; CHECK-LABEL: @exponential(
; CHECK-NEXT: call double @exp(double %x) [[CALL:#[0-9]+]]
define double @exponential(double %x) {
  %s = call double @exp(double %x)
  ret double %s
}
; CHECK-LABEL: @logarithms(
; CHECK-COUNT-2: call float @logf
define <2 x float> @logarithms(<2 x float> %x) {
  %s = call <2 x float> @llvm.log.v2f32(<2 x float> %x)
  ret <2 x float> %s
}
; These have one right answer.
; CHECK-LABEL: @exact(
; CHECK: call float @llvm.sqrt.f32
; CHECK: call float @llvm.floor.f32
define float @exact(float %x) {
  %r = call float @llvm.sqrt.f32(float %x)
  %s = call float @llvm.floor.f32(float %r)
  ret float %s
}
; Which zero is the minimum of both is settled.
; CHECK-LABEL: @clamp(
; CHECK-NEXT: [[LOW:%.*]] = call float @llvm.maximumnum.f32(float %x, float 0.000000e+00)
; CHECK-NEXT: call float @llvm.minimumnum.f32(float [[LOW]], float 1.000000e+00)
; OFF-LABEL: @clamp(
; OFF-NEXT: call nsz float @llvm.maxnum.f32
define float @clamp(float %x) {
  %l = call nsz float @llvm.maxnum.f32(float %x, float 0.0)
  %h = call float @fminf(float %l, float 1.0)
  ret float %h
}

; CHECK-DAG: attributes [[OPAQUE]] = { nobuiltin nounwind willreturn memory(none) }
; CHECK-DAG: attributes [[CALL]] = { nobuiltin }

declare float @llvm.pow.f32(float, float)
declare double @llvm.pow.f64(double, double)
declare float @powf(float, float)
declare double @exp(double)
declare float @fminf(float, float)
declare float @llvm.sqrt.f32(float)
declare float @llvm.floor.f32(float)
declare float @llvm.maxnum.f32(float, float)
