; What remains of the flags: nnan and ninf as the user asked.
; RUN: %canonicalize %s | FileCheck %s
; RUN: %canonicalize %without %s | FileCheck --check-prefix=OFF %s

source_filename = "kernel.cpp"

; CHECK-LABEL: define float @flags(float %x, float %y)
; CHECK-SAME: [[FUNCTION:#[0-9]+]]
; CHECK-NEXT: fadd nnan ninf float
; CHECK-NEXT: fsub float
; CHECK-NEXT: fneg nnan float
; CHECK-NEXT: fcmp nnan ninf olt float
; CHECK-NEXT: select nnan ninf i1
; CHECK-NEXT: call nnan ninf float @callee(float {{%.*}}){{$}}
; OFF-LABEL: define nofpclass(nan inf) float @flags(
; OFF-NEXT: fadd fast float
; OFF-NEXT: fsub reassoc nsz arcp contract afn float
define nofpclass(nan inf) float @flags(float nofpclass(nan inf) %x, float %y) #0 {
  %a = fadd fast float %x, %y
  %b = fsub reassoc nsz arcp contract afn float %a, %y, !fpmath !0
  %c = fneg nnan nsz float %b
  %d = fcmp fast olt float %c, %x
  %e = select fast i1 %d, float %c, float %x
  %f = call fast nofpclass(nan inf) float @callee(float nofpclass(nan inf) %e)
  ret float %f
}
; CHECK: declare float @callee(float)
declare nofpclass(nan inf) float @callee(float nofpclass(nan inf))

; A function that minds the floating-point environment is left alone.
; CHECK-LABEL: @environment(
; CHECK: @llvm.experimental.constrained.fdiv.f32
; CHECK: fdiv fast float
define float @environment(float %x, float %y) #1 {
  %q = call float @llvm.experimental.constrained.fdiv.f32(float %x, float %y, metadata !"round.dynamic", metadata !"fpexcept.strict") #1
  %r = fdiv fast float %q, %y
  ret float %r
}

; Once is enough: what the pass has seen, it leaves alone at link time.
; CHECK-LABEL: @seen(
; CHECK: fdiv arcp float
define float @seen(float %x, float %y) #2 {
  %r = fdiv arcp float %x, %y
  ret float %r
}

; CHECK: attributes [[FUNCTION]] = { "no-nans-fp-math"="true" "tp-fp-canonical" }
; The linker reads whether a unit relies on finite math.
; CHECK: !tp.floating_point = !{[[UNIT:![0-9]+]]}
; CHECK: [[UNIT]] = !{!"kernel.cpp", i1 true
; OFF: !tp.floating_point = !{[[UNIT:![0-9]+]]}
; OFF: [[UNIT]] = !{!"kernel.cpp", i1 true
attributes #0 = { "no-signed-zeros-fp-math"="true" "approx-func-fp-math"="true" "unsafe-fp-math"="true" "no-nans-fp-math"="true" "reciprocal-estimates"="all" }
attributes #1 = { strictfp }
attributes #2 = { "tp-fp-canonical" }
!0 = !{float 2.5}

declare float @llvm.experimental.constrained.fdiv.f32(float, float, metadata, metadata)
