; std::sqrt(float) is a function of its own, not yet inlined when the pass runs;
; a literal power and a reciprocal root are recognized through it.
; RUN: %canonicalize %s | FileCheck %s
; RUN: %canonicalize %without %s | FileCheck --check-prefix=OFF %s

; CHECK-LABEL: define float @normalize(
; CHECK-NEXT: fpext float %x to double
; CHECK-NEXT: call double @llvm.sqrt.f64
; CHECK-NEXT: fdiv double 1.0
; CHECK-NEXT: fptrunc
; CHECK-NEXT: ret
; OFF-LABEL: define float @normalize(
; OFF-NEXT: call fast float @_ZSt4sqrtf
define float @normalize(float %x) {
  %s = call fast float @_ZSt4sqrtf(float %x)
  %q = fdiv fast float 1.0, %s
  ret float %q
}
; The call's own flags count.
; CHECK-LABEL: define float @exact(
; CHECK-NEXT: call float @llvm.sqrt.f32
; CHECK-NEXT: fdiv
define float @exact(float %x) {
  %s = call float @_ZSt4sqrtf(float %x)
  %q = fdiv fast float 1.0, %s
  ret float %q
}
; std::pow(float, int) converts its arguments.
; CHECK-LABEL: define double @cube(
; CHECK-NEXT: [[X:%.*]] = fpext {{.*}}float %x to double
; CHECK-NEXT: [[SQUARE:%.*]] = fmul double [[X]], [[X]]
; CHECK-NEXT: fmul double [[X]], [[SQUARE]]
; CHECK-NEXT: ret
define double @cube(float %x) {
  %p = call fast double @_ZSt3powIfiE(float %x, i32 3)
  ret double %p
}
; Where exceptions may pass: an invoke has no flags of its own.
; CHECK-LABEL: define double @unwinding(
; CHECK-NEXT: [[X:%.*]] = fpext {{.*}}float %x to double
; CHECK-NEXT: [[SQUARE:%.*]] = fmul double [[X]], [[X]]
; CHECK-NEXT: fmul double [[X]], [[SQUARE]]
; CHECK-NEXT: br label
define double @unwinding(float %x) personality ptr @personality {
  %p = invoke double @_ZSt3powIfiE(float %x, i32 3) to label %normal unwind label %pad
normal:
  ret double %p
pad:
  %l = landingpad { ptr, i32 } cleanup
  resume { ptr, i32 } %l
}
; Not a mere wrapper: it has a side effect, may be replaced, or calls itself.
; CHECK-LABEL: define float @others(
; CHECK-NEXT: call float @counted
; CHECK-NEXT: call float @replaceable
; CHECK-NEXT: call float @endless
; CHECK-NEXT: call float @uninitialized
define float @others(float %x) {
  %a = call float @counted(float %x)
  %b = call float @replaceable(float %a)
  %c = call float @endless(float %b)
  %d = call float @uninitialized(float %c)
  ret float %d
}

define linkonce_odr float @_ZSt4sqrtf(float %0) {
  %2 = alloca float
  store float %0, ptr %2
  %3 = load float, ptr %2
  %4 = call fast float @llvm.sqrt.f32(float %3)
  ret float %4
}
define linkonce_odr double @_ZSt3powIfiE(float %0, i32 %1) {
  %3 = alloca float
  %4 = alloca i32
  store float %0, ptr %3
  store i32 %1, ptr %4
  %5 = load float, ptr %3
  %6 = fpext fast float %5 to double
  %7 = load i32, ptr %4
  %8 = sitofp i32 %7 to double
  %9 = call fast double @_ZSt3powdd(double %6, double %8)
  ret double %9
}
define linkonce_odr double @_ZSt3powdd(double %0, double %1) {
  %3 = call fast double @pow(double %0, double %1)
  ret double %3
}
@count = global i32 0
define float @counted(float %0) {
  store i32 1, ptr @count
  %2 = call fast float @llvm.sqrt.f32(float %0)
  ret float %2
}
define weak float @replaceable(float %0) {
  %2 = call fast float @llvm.sqrt.f32(float %0)
  ret float %2
}
define float @endless(float %0) {
  %2 = call float @endless(float %0)
  ret float %2
}
define float @uninitialized(float %0) {
  %2 = alloca float
  %3 = load float, ptr %2
  %4 = call fast float @llvm.sqrt.f32(float %3)
  ret float %4
}

declare i32 @personality(...)
declare double @pow(double, double)
declare float @llvm.sqrt.f32(float)
