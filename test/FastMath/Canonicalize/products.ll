; Products of several factors.
; RUN: %canonicalize %s | FileCheck %s
; RUN: %canonicalize %without %s | FileCheck --check-prefix=OFF %s

; CHECK-LABEL: @fourth_power(
; CHECK-NEXT: [[SQUARE:%.*]] = fmul float %x, %x
; CHECK-NEXT: [[FOURTH:%.*]] = fmul float [[SQUARE]], [[SQUARE]]
; CHECK-NEXT: ret float [[FOURTH]]
; OFF-LABEL: @fourth_power(
; OFF-COUNT-3: fmul fast
define float @fourth_power(float %x) {
  %a = fmul fast float %x, %x
  %b = fmul fast float %a, %x
  %c = fmul fast float %b, %x
  ret float %c
}

; Loads of one variable are the same value.
; CHECK-LABEL: @loaded(
; CHECK: [[X:%.*]] = load double, ptr %v
; CHECK-NEXT: [[SQUARE:%.*]] = fmul double [[X]], [[X]]
; CHECK-NEXT: fmul double [[SQUARE]], [[SQUARE]]
; CHECK-NEXT: ret
define double @loaded(double %x) {
  %v = alloca double
  store double %x, ptr %v
  %1 = load double, ptr %v
  %2 = load double, ptr %v
  %a = fmul reassoc double %1, %2
  %3 = load double, ptr %v
  %b = fmul reassoc double %a, %3
  %4 = load double, ptr %v
  %c = fmul reassoc double %b, %4
  ret double %c
}

; But not across a write, nor if volatile or atomic.
; CHECK-LABEL: @written(
; CHECK-COUNT-3: fmul nnan ninf float
define float @written(ptr %v, ptr %w) {
  %1 = load float, ptr %v
  store float 1.0, ptr %w
  %2 = load float, ptr %v
  %a = fmul fast float %1, %2
  store float 2.0, ptr %w
  %3 = load float, ptr %v
  %b = fmul fast float %a, %3
  store float 2.0, ptr %w
  %4 = load float, ptr %v
  %c = fmul fast float %b, %4
  ret float %c
}
; CHECK-LABEL: @volatile(
; CHECK-COUNT-4: load volatile
; CHECK: ret
define float @volatile(ptr %v) {
  %1 = load volatile float, ptr %v
  %2 = load volatile float, ptr %v
  %a = fmul fast float %1, %2
  %3 = load volatile float, ptr %v
  %b = fmul fast float %a, %3
  %4 = load volatile float, ptr %v
  %c = fmul fast float %b, %4
  ret float %c
}

; CHECK-LABEL: @vector(
; CHECK-COUNT-2: fmul <4 x float>
; CHECK-NOT: fmul
define <4 x float> @vector(<4 x float> %x) {
  %a = fmul fast <4 x float> %x, %x
  %b = fmul fast <4 x float> %a, %x
  %c = fmul fast <4 x float> %b, %x
  ret <4 x float> %c
}

; Constants are merged, but not to a subnormal or an infinity.
; CHECK-LABEL: @constants(
; CHECK-NEXT: fmul float %x, 6.000000e+00
; CHECK-NEXT: ret
define float @constants(float %x) {
  %a = fmul fast float %x, 2.0
  %b = fmul fast float 3.0, %a
  ret float %b
}
; CHECK-LABEL: @underflow(
; CHECK-COUNT-2: fmul nnan ninf float
define float @underflow(float %x) {
  %a = fmul fast float %x, 0x3AF0000000000000
  %b = fmul fast float %a, 0x3AF0000000000000
  ret float %b
}
; CHECK-LABEL: @overflow(
; CHECK-COUNT-2: fmul nnan ninf float
define float @overflow(float %x) {
  %a = fmul fast float %x, 0x4530000000000000
  %b = fmul fast float %a, 0x4530000000000000
  ret float %b
}

; Signs meet at the end.
; CHECK-LABEL: @signs(
; CHECK-NEXT: [[X:%.*]] = fmul float %x, %x
; CHECK-NEXT: fmul float [[X]], %y
; CHECK-NEXT: ret
define float @signs(float %x, float %y) {
  %nx = fneg fast float %x
  %ny = fneg fast float %y
  %a = fmul fast float %nx, %x
  %b = fmul fast float %a, %ny
  ret float %b
}

; Without the flag, or where a factor is used elsewhere, nothing moves.
; CHECK-LABEL: @strict(
; CHECK-COUNT-3: fmul float
define float @strict(float %x) {
  %a = fmul float %x, %x
  %b = fmul float %a, %x
  %c = fmul float %b, %x
  ret float %c
}
; CHECK-LABEL: @shared(
; CHECK: [[A:%.*]] = fmul nnan ninf float %x, %y
; CHECK: fmul nnan ninf float [[A]], %x
define float @shared(float %x, float %y, ptr %p) {
  %a = fmul fast float %x, %y
  store float %a, ptr %p
  %b = fmul fast float %a, %x
  ret float %b
}
; CHECK-LABEL: @half(
; CHECK-COUNT-3: fmul nnan ninf half
define half @half(half %x) {
  %a = fmul fast half %x, %x
  %b = fmul fast half %a, %x
  %c = fmul fast half %b, %x
  ret half %c
}

; a * k + b * k
; CHECK-LABEL: @factored(
; CHECK-NEXT: [[SUM:%.*]] = fadd float %a, %b
; CHECK-NEXT: fmul float [[SUM]], %k
; CHECK-NEXT: ret
; OFF-LABEL: @factored(
; OFF-COUNT-2: fmul fast
define float @factored(float %a, float %b, float %k) {
  %l = fmul fast float %a, %k
  %r = fmul fast float %k, %b
  %s = fadd fast float %l, %r
  ret float %s
}
; The factor of an exact zero has a sign: not without nsz.
; CHECK-LABEL: @signed_zero(
; CHECK-COUNT-2: fmul float
; CHECK: fsub
define float @signed_zero(float %a, float %b, float %k) {
  %l = fmul reassoc float %a, %k
  %r = fmul reassoc float %k, %b
  %s = fsub reassoc float %l, %r
  ret float %s
}
; Nothing is cancelled: an infinity stays one.
; CHECK-LABEL: @cancelled(
; CHECK-NEXT: fadd nnan ninf float
; CHECK-NEXT: fsub nnan ninf float
define float @cancelled(float %a, float %b) {
  %s = fadd fast float %a, %b
  %d = fsub fast float %s, %a
  ret float %d
}
; Sums keep their order.
; CHECK-LABEL: @sum(
; CHECK-NEXT: [[AB:%.*]] = fadd nnan ninf float %a, %b
; CHECK-NEXT: [[CD:%.*]] = fadd nnan ninf float %c, %d
; CHECK-NEXT: fadd nnan ninf float [[AB]], [[CD]]
define float @sum(float %a, float %b, float %c, float %d) {
  %ab = fadd fast float %a, %b
  %cd = fadd fast float %c, %d
  %s = fadd fast float %ab, %cd
  ret float %s
}
