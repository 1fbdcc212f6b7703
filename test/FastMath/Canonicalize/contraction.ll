; Fused multiply-adds, where the target has them.
; RUN: sed 's/FEATURE/+fma/' %s | %canonicalize | FileCheck --check-prefixes=CHECK,FMA %s
; RUN: sed 's/FEATURE/-fma/' %s | %canonicalize | FileCheck --check-prefixes=CHECK,NONE %s
; RUN: sed 's/FEATURE/+fma/' %s | %canonicalize %without | FileCheck --check-prefix=OFF %s

target triple = "x86_64-unknown-linux-gnu"

; CHECK-LABEL: @muladd(
; FMA-NEXT: call float @llvm.fma.f32(float %a, float %b, float %c)
; NONE-NEXT: [[P:%.*]] = fmul float %a, %b
; NONE-NEXT: fadd float [[P]], %c
; CHECK-NEXT: ret
; OFF-LABEL: @muladd(
; OFF-NEXT: call float @llvm.fmuladd.f32
define float @muladd(float %a, float %b, float %c) #0 {
  %r = call float @llvm.fmuladd.f32(float %a, float %b, float %c)
  ret float %r
}
; c - a * b
; CHECK-LABEL: @negated(
; FMA-NEXT: [[N:%.*]] = fneg float %a
; FMA-NEXT: call float @llvm.fma.f32(float [[N]], float %b, float %c)
; NONE-NEXT: [[P:%.*]] = fmul float %a, %b
; NONE-NEXT: fsub float %c, [[P]]
; CHECK-NEXT: ret
define float @negated(float %a, float %b, float %c) #0 {
  %n = fneg float %a
  %r = call float @llvm.fmuladd.f32(float %n, float %b, float %c)
  ret float %r
}
; Of two products, the right one.
; CHECK-LABEL: @dot(
; CHECK-NEXT: [[L:%.*]] = fmul double %a, %b
; FMA-NEXT: call double @llvm.fma.f64(double %c, double %d, double [[L]])
define double @dot(double %a, double %b, double %c, double %d) #0 {
  %l = fmul contract double %a, %b
  %r = fmul contract double %c, %d
  %s = fadd contract double %l, %r
  ret double %s
}
; a * b - c * d, in all its forms, stays two products and a difference.
; CHECK-LABEL: @cross(
; CHECK-NOT: fma
; CHECK: fsub
define float @cross(float %a, float %b, float %c, float %d) #0 {
  %l = fmul contract float %a, %b
  %r = fmul contract float %c, %d
  %s = fsub contract float %l, %r
  ret float %s
}
; CHECK-LABEL: @cross_muladd(
; CHECK-NOT: fma
; CHECK: fsub
define float @cross_muladd(float %a, float %b, float %c, float %d) #0 {
  %r = fmul float %c, %d
  %n = fneg float %r
  %s = call float @llvm.fmuladd.f32(float %a, float %b, float %n)
  ret float %s
}
; CHECK-LABEL: @cross_negative_factor(
; CHECK-NOT: fma
; CHECK: fadd
define float @cross_negative_factor(float %a, float %b, float %c, float %d) #0 {
  %n = fneg float %c
  %l = fmul contract float %a, %b
  %r = fmul contract float %n, %d
  %s = fadd contract float %l, %r
  ret float %s
}
; CHECK-LABEL: @discriminant(
; CHECK-NOT: fma
; CHECK: fadd
define float @discriminant(float %a, float %b, float %c) #0 {
  %l = fmul contract float %b, %b
  %k = fmul contract float -4.0, %a
  %r = fmul contract float %k, %c
  %s = fadd contract float %l, %r
  ret float %s
}
; CHECK-LABEL: @cross_by_variable(
; CHECK-NOT: fma
; CHECK: fsub
define float @cross_by_variable(float %a, float %b, float %c, float %d) #0 {
  %v = alloca float
  %l = fmul contract float %a, %b
  store float %l, ptr %v
  %1 = load float, ptr %v
  %r = fmul contract float %c, %d
  %s = fsub contract float %1, %r
  ret float %s
}
; CHECK-LABEL: @four_products(
; CHECK-NOT: fma
; CHECK: ret
define float @four_products(float %a, float %b, float %c, float %d) #0 {
  %ab = fmul contract float %a, %b
  %cd = fmul contract float %c, %d
  %ac = fmul contract float %a, %c
  %bd = fmul contract float %b, %d
  %1 = fsub contract float %ab, %cd
  %2 = fadd contract float %1, %ac
  %3 = fsub contract float %2, %bd
  ret float %3
}
; Not without the flag on both.
; CHECK-LABEL: @not_allowed(
; CHECK-NOT: fma
; CHECK: ret
define float @not_allowed(float %a, float %b, float %c) #0 {
  %p = fmul float %a, %b
  %s = fadd contract float %p, %c
  ret float %s
}
attributes #0 = { "target-features"="+sse2,FEATURE" }

declare float @llvm.fmuladd.f32(float, float, float)
