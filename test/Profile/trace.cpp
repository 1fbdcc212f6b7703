// The trace of a TP has each of its cycles once and adds up to the statistics.

// RUN: tpcc -O1 -g %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --trace-tps 0.3,2.0 --trace-cycles 0:100000 --trace-output %t.json --stats %t.stats.json
// RUN: %python %S/Inputs/check_trace.py %t.json %t.stats.json 0.3 2.0
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --trace-tps 1.31,0.0 --trace-cycles 0:100000 --trace-output %t.l2.json --stats %t.stats.json
// RUN: %python %S/Inputs/check_trace.py %t.l2.json %t.stats.json 1.31 0.0
// RUN: FileCheck %s < %t.l2.json
// RUN: tpsim --chip trax-32x32 --set tm.count=1 --set tm.tps=1 --quiet %t.elf --trace-tps 0.0 --trace-output %t.json --stats %t.stats.json
// RUN: %python %S/Inputs/check_trace.py %t.json %t.stats.json 0.0
// CHECK: {"name":"process_name","ph":"M","pid":1,"tid":31744,"args":{"name":"TM 1"}}
// CHECK: {"name":"thread_name","ph":"M","pid":1,"tid":31744,"args":{"name":"TP 31"}}
// CHECK: {"name":"mfsr {{[^"]*}}","cat":"issue","ph":"X","pid":1,"tid":31744,"ts":{{[0-9]+}},"dur":{{[0-9]+}},"args":{"cycle":{{[0-9]+}},"cycles":1,"pc":"0x{{[0-9a-f]+}}","function":"main","line":"{{[^"]*}}trace.cpp:[[#@LINE+26]]"}}
// CHECK: {"name":"thread_name","ph":"M","pid":1,"tid":31745,"args":{"name":"TP 31 memory 0"}}
// CHECK: "cat":"memory","ph":"X","pid":1,"tid":31745,"ts":{{[0-9]+}},"dur":{{[0-9]+}},"args":{"cycle":{{[0-9]+}},"cycles":{{[0-9]+}},"instruction":"lw{{[^"]*}}","pc":"0x{{[0-9a-f]+}}","function":"main","line":"{{[^"]*}}","address":"0x{{[0-9a-f]+}}"

// One that is named twice is traced once.
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --trace-tps 1.31,0.0,1.31 --trace-cycles 0:100000 --trace-output %t.again.json
// RUN: cmp %t.l2.json %t.again.json

// A range, and a run that is cut and traps.
// RUN: tpsim --chip 4x32 --quiet %t.elf --trace-tps 0.3 --trace-cycles 50:150 --trace-output %t.json
// RUN: %python %S/Inputs/check_trace.py --range 50:150 %t.json 0.3
// RUN: not tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --max-cycles 300 --trace-tps 0.3 --trace-output %t.json --stats %t.stats.json
// RUN: %python %S/Inputs/check_trace.py %t.json %t.stats.json 0.3
// RUN: tpcc -O1 -DTRAP %s -o %t.trap.elf
// RUN: not tpsim --chip 4x32 --quiet %t.trap.elf --trace-tps 0.3 --trace-output %t.json --stats %t.stats.json
// RUN: %python %S/Inputs/check_trace.py %t.json %t.stats.json 0.3

// Tracing changes nothing in the run.
// RUN: tpsim --chip 4x32 --quiet %t.elf --trace-tps 0.3 --trace-output %t.json --stats %t.with.json
// RUN: tpsim --chip 4x32 --quiet %t.elf --stats %t.without.json
// RUN: cmp %t.with.json %t.without.json

unsigned Values[1 << 14];

int main() {
  unsigned Sum =
      __builtin_tp_thread_id();
  unsigned Steps = 8 + Sum % 9;
  for (unsigned I = 0; I != Steps; ++I)
    Sum = Sum * 5 + Values[(Sum ^ I * 64) % (1 << 14)] / 3;
  __builtin_tp_barrier();
#ifdef TRAP
  if (__builtin_tp_thread_id() == 3)
    __builtin_tp_trap_break(7);
#endif
  __builtin_tp_sleep(10);
  __atomic_fetch_add(&Values[0], Sum, __ATOMIC_RELAXED);
  Values[__builtin_tp_thread_id()] = Sum;
  __builtin_tp_sync();
  return 0;
}
