; RUN: %llc_tp -O2 -verify-machineinstrs -stop-before=greedy < %s | FileCheck %s

; What comes from global memory is dear to spill; what comes from the stack or
; a thread_local object is not.
@here = thread_local global i32 0

; CHECK-LABEL: name: loads
; CHECK-DAG: :gprloaded = LW {{.*}} from %ir.p)
; CHECK-DAG: :fprloaded = LWC1 {{.*}} from %ir.q)
; CHECK-DAG: :gpr = LW {{.*}} from @here)
; CHECK-DAG: :gpr = LW {{.*}} from %ir.local)
define i32 @loads(ptr %p, ptr %q) {
  %local = alloca i32
  store volatile i32 1, ptr %local
  %a = load i32, ptr %p
  %b = load float, ptr %q
  %c = load i32, ptr @here
  %d = load volatile i32, ptr %local
  %e = fptosi float %b to i32
  %f = add i32 %a, %c
  %g = add i32 %d, %e
  %h = add i32 %f, %g
  ret i32 %h
}
