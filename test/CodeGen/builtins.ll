; RUN: %llc_tp -O2 -verify-machineinstrs < %s | FileCheck %s
; RUN: %llc_tp -O0 -verify-machineinstrs -filetype=obj -o %t.o < %s

declare float @tp_rcp(float)
declare float @tp_rsqrt(float)
declare float @tp_sin(float)
declare float @tp_cos(float)
declare i32 @tp_trunc_w(float)
declare i32 @tp_round_w(float)
declare i32 @tp_floor_w(float)
declare i32 @tp_ceil_w(float)
declare i32 @tp_thread_id()
declare i32 @tp_tp_id()
declare i32 @tp_tm_id()
declare i32 @tp_thread_count()
declare i32 @tp_tp_count()
declare i32 @tp_tm_count()
declare i32 @tp_local_store_bytes()
declare i32 @tp_cycle()
declare i32 @tp_cycle_high()
declare i32 @tp_instret()
declare i32 @tp_instret_high()
declare void @tp_prof(i32)
declare void @tp_sleep(i32)
declare void @tp_barrier()
declare void @tp_sync()
declare void @tp_halt(i32) noreturn
declare void @tp_trap_break(i32) noreturn
declare i32 @tp_hostcall(i32, i32, i32, i32)
declare i32 @tp_stream_push(ptr, i32)
declare i32 @tp_stream_pop(ptr)

define float @math(float %x) {
; CHECK-LABEL: math:
; CHECK: rcp_s f12, f4
; CHECK-NEXT: rsqrt_s f12, f12
; CHECK-NEXT: sin_s f12, f12
; CHECK-NEXT: cos_s f4, f12
; CHECK-NEXT: ret
  %a = call float @tp_rcp(float %x)
  %b = call float @tp_rsqrt(float %a)
  %c = call float @tp_sin(float %b)
  %d = tail call float @tp_cos(float %c)
  ret float %d
}
define i32 @conversions(float %x) {
; CHECK-LABEL: conversions:
; CHECK: trunc_w_s r12, f4
; CHECK-NEXT: round_w_s r15, f4
; CHECK-NEXT: floor_w_s r13, f4
; CHECK-NEXT: ceil_w_s r14, f4
; CHECK-NEXT: add r12, r12, r15
; CHECK-NEXT: add r13, r13, r14
; CHECK-NEXT: add r4, r12, r13
; CHECK-NEXT: ret
  %a = call i32 @tp_trunc_w(float %x)
  %b = call i32 @tp_round_w(float %x)
  %c = call i32 @tp_floor_w(float %x)
  %d = call i32 @tp_ceil_w(float %x)
  %e = add i32 %a, %b
  %f = add i32 %c, %d
  %g = add i32 %e, %f
  ret i32 %g
}
define i32 @identity() {
; CHECK-LABEL: identity:
; CHECK: mfsr r25, thread
; CHECK-NEXT: mfsr r26, tp
; CHECK-NEXT: mfsr r24, tm
; CHECK-NEXT: xor r25, r25, r26
; CHECK-NEXT: mfsr r15, nthread
; CHECK-NEXT: xor r24, r25, r24
; CHECK-NEXT: mfsr r14, ntp
; CHECK-NEXT: xor r15, r24, r15
; CHECK-NEXT: mfsr r13, ntm
; CHECK-NEXT: xor r14, r15, r14
; CHECK-NEXT: mfsr r12, lssize
; CHECK-NEXT: xor r13, r14, r13
; CHECK-NEXT: xor r4, r13, r12
; CHECK-NEXT: ret
  %a = call i32 @tp_thread_id()
  %b = call i32 @tp_tp_id()
  %c = call i32 @tp_tm_id()
  %d = call i32 @tp_thread_count()
  %e = call i32 @tp_tp_count()
  %f = call i32 @tp_tm_count()
  %g = call i32 @tp_local_store_bytes()
  %h = xor i32 %a, %b
  %i = xor i32 %h, %c
  %j = xor i32 %i, %d
  %k = xor i32 %j, %e
  %l = xor i32 %k, %f
  %m = xor i32 %l, %g
  ret i32 %m
}
; The same counter read twice is two reads.
define i32 @elapsed() {
; CHECK-LABEL: elapsed:
; CHECK: mfsr r12, cycle
; CHECK-NEXT: sleep r12
; CHECK-NEXT: mfsr r13, cycle
; CHECK-NEXT: sub r4, r13, r12
; CHECK-NEXT: ret
  %a = call i32 @tp_cycle()
  call void @tp_sleep(i32 %a)
  %b = call i32 @tp_cycle()
  %c = sub i32 %b, %a
  ret i32 %c
}
define i32 @counters() {
; CHECK-LABEL: counters:
; CHECK: mfsr r13, cycleh
; CHECK-NEXT: mfsr r14, instret
; CHECK-NEXT: mfsr r12, instreth
; CHECK-NEXT: add r13, r13, r14
; CHECK-NEXT: add r4, r13, r12
; CHECK-NEXT: ret
  %a = call i32 @tp_cycle_high()
  %b = call i32 @tp_instret()
  %c = call i32 @tp_instret_high()
  %d = add i32 %a, %b
  %e = add i32 %d, %c
  ret i32 %e
}
; A constant register read twice is one read, and an unused one is none.
define i32 @merged() {
; CHECK-LABEL: merged:
; CHECK: mfsr r12, thread
; CHECK-NEXT: add r4, r12, r12
; CHECK-NEXT: ret
  %a = call i32 @tp_thread_id()
  %b = call i32 @tp_thread_id()
  %c = call i32 @tp_tm_id()
  %d = add i32 %a, %b
  ret i32 %d
}
define void @synchronization() {
; CHECK-LABEL: synchronization:
; CHECK: prof 3
; CHECK-NEXT: barrier
; CHECK-NEXT: sync
; CHECK-NEXT: ret
  call void @tp_prof(i32 3)
  call void @tp_barrier()
  call void @tp_sync()
  ret void
}
define i32 @halting(i32 %status) {
; CHECK-LABEL: halting:
; CHECK: halt r4
  call void @tp_halt(i32 %status)
  unreachable
}
define void @breaking() {
; CHECK-LABEL: breaking:
; CHECK: break 7
  call void @tp_trap_break(i32 7)
  unreachable
}
define i32 @host(i32 %a, i32 %b, i32 %c) {
; CHECK-LABEL: host:
; CHECK: move r12, r6
; CHECK-NEXT: move r6, r4
; CHECK-NEXT: move r4, r12
; CHECK-NEXT: hostcall 0
; CHECK-NEXT: move r4, r2
; CHECK-NEXT: ret
  %r = call i32 @tp_hostcall(i32 0, i32 %c, i32 %b, i32 %a)
  ret i32 %r
}
define i32 @streams(ptr %s, i32 %v) {
; CHECK-LABEL: streams:
; CHECK: stream_push r12, r5, (r4)
; CHECK-NEXT: stream_pop r13, (r4)
; CHECK-NEXT: add r4, r12, r13
; CHECK-NEXT: ret
  %a = call i32 @tp_stream_push(ptr %s, i32 %v)
  %b = call i32 @tp_stream_pop(ptr %s)
  %c = add i32 %a, %b
  ret i32 %c
}
