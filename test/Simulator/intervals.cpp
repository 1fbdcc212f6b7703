// Series of intervals add up to the run, with and without caches and DRAM, and
// do not depend on the host.

// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --stats %t.json --interval 300 --interval-output %t.csv
// RUN: tpsim --chip 4x32 --quiet --host-threads 3 %t.elf --stats %t.3.json --interval 300 --interval-output %t.trace.json
// RUN: cmp %t.json %t.3.json
// RUN: %python %S/Inputs/check_intervals.py 300 %t.csv %t.trace.json %t.json

// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --stats %t.l2.json --interval 1000 --interval-output %t.l2.csv
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet --host-threads 2 %t.elf --interval 1000 --interval-output %t.l2.trace.json
// RUN: %python %S/Inputs/check_intervals.py 1000 %t.l2.csv %t.l2.trace.json %t.l2.json
// RUN: FileCheck %s --check-prefix=TRACE < %t.l2.trace.json
// TRACE: "name":"process_name","ph":"M","pid":0,"args":{"name":"trax-32x32"}
// TRACE: {"name":"L1 hits (%)","ph":"C","pid":0,"ts":0,"args":{"hits":{{[0-9.]+}}}}
// TRACE: {"name":"DRAM (GB/s)","ph":"C","pid":0,"ts":0,"args":{"read":{{[0-9.]+}},"written":{{[0-9.]+}}}}

// The run is the same without them.
// RUN: tpsim --chip trax-32x32 --set tm.count=2 --quiet %t.elf --stats %t.plain.json
// RUN: cmp %t.l2.json %t.plain.json

// RUN: not tpsim --chip 1x1 %t.elf --interval 300 2>&1 | FileCheck %s --check-prefix=ALONE
// RUN: not tpsim --chip 1x1 %t.elf --interval-output %t.csv 2>&1 | FileCheck %s --check-prefix=ALONE
// ALONE: tpsim: error: --interval and --interval-output need each other: cycles of an interval, and the file to write
// RUN: not tpsim --chip 1x1 %t.elf --interval 0 --interval-output %t.csv 2>&1 | FileCheck %s --check-prefix=LENGTH
// LENGTH: tpsim: error: --interval '0': expected a whole number from 1
// RUN: not tpsim --chip 1x1 %t.elf --interval 5 --interval-output %t.txt 2>&1 | FileCheck %s --check-prefix=FORMAT
// FORMAT: tpsim: error: --interval-output '{{.*}}.txt': expected a file that ends in .csv or .json
// RUN: not tpsim --chip 1x1 %t.elf --interval 5 --interval-output %t.no-folder/x.csv 2>&1 | FileCheck %s --check-prefix=NO-FOLDER
// NO-FOLDER: tpsim: error: cannot write {{.*}}x.csv: No such file or directory
// RUN: not tpsim --chip 1x1 %t.elf --functional --interval 5 --interval-output %t.csv 2>&1 | FileCheck %s --check-prefix=FUNCTIONAL
// FUNCTIONAL: tpsim: error: --functional and --interval exclude each other

unsigned Values[1 << 14];

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  unsigned Sum = Thread;
  for (unsigned I = 0; I != 40 + Thread % 9; ++I)
    Sum = Sum * 5 + Values[(Sum ^ I * 64) % (1 << 14)];
  Values[Thread] = Sum;
  __builtin_tp_sync();
  __builtin_tp_barrier();
  if (Thread % 8 == 0)
    __builtin_tp_sleep(500);
  __atomic_fetch_add(&Values[0], Sum, __ATOMIC_SEQ_CST);
  return 0;
}
