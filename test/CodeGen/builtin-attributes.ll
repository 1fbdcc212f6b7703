; The declarations get what TPBuiltins.def promises of memory; a function with a
; body or another signature is the user's own.
; RUN: %llc_tp -O2 -stop-after=tp-builtin-attributes < %s | FileCheck %s --check-prefix=IR
; RUN: %llc_tp -O2 < %s | FileCheck %s

; IR: declare float @tp_rcp(float) [[CONST:#[0-9]+]]
; IR: declare i32 @tp_cycle() [[INACCESSIBLE:#[0-9]+]]
; IR: declare void @tp_halt(i32) [[HALT:#[0-9]+]]
; IR: attributes [[CONST]] = { nounwind speculatable willreturn memory(none) }
; IR: attributes [[INACCESSIBLE]] = { nounwind willreturn memory(inaccessiblemem: readwrite) }
; IR: attributes [[HALT]] = { noreturn nounwind }
declare float @tp_rcp(float)
declare i32 @tp_cycle()
declare void @tp_halt(i32)
declare i32 @tp_thread_id(i32)

define float @tp_rsqrt(float %x) {
  ret float %x
}

; CHECK-LABEL: own:
; CHECK: jal tp_rsqrt
; CHECK: jal tp_thread_id
define float @own(float %x) {
  %r = call float @tp_rsqrt(float %x)
  %i = call i32 @tp_thread_id(i32 1)
  %f = sitofp i32 %i to float
  %s = fadd float %r, %f
  ret float %s
}
