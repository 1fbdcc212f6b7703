// The JSON's sums agree, whatever a program does and however it ends, and the
// simulation is the same for any number of host threads and in every run.

// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip report-512x8 --quiet --host-threads 1 %t.elf --stats %t.1.json > %t.1.out
// RUN: %python %S/Inputs/check_statistics.py %t.1.json
// RUN: %python %S/Inputs/check_schema.py %statistics_schema %t.1.json
// RUN: FileCheck %s < %t.1.json

// CHECK:      "format_version": 2,
// CHECK-NEXT: "mode": "cycle",
// CHECK-NEXT: "run": {
// CHECK-NEXT:   "outcome": "finished",
// CHECK-NEXT:   "exit_status": 0,
// CHECK-NEXT:   "cycles": {{[0-9]+}},
// CHECK:      "chip": {
// CHECK:        "tm_count": 512,
// CHECK:      "thread_cycles": {
// CHECK:        "lost": {
// CHECK-NEXT:     "data": {{[1-9][0-9]*}},
// CHECK-NEXT:     "memory": {{[1-9][0-9]*}},
// CHECK-NEXT:     "l1": 0,
// CHECK-NEXT:     "l2": 0,
// CHECK-NEXT:     "dram": 0,
// CHECK-NEXT:     "store_buffer": 0,
// CHECK-NEXT:     "unit_conflict": {{[1-9][0-9]*}},
// CHECK-NEXT:     "icache_conflict": {{[1-9][0-9]*}},
// CHECK-NEXT:     "icache_miss": 0,
// CHECK-NEXT:     "branch": {{[0-9]+}},
// CHECK-NEXT:     "barrier": {{[1-9][0-9]*}},
// CHECK-NEXT:     "sync": {{[1-9][0-9]*}},
// CHECK-NEXT:     "sleep": {{[1-9][0-9]*}},
// CHECK-NEXT:     "finished": {{[1-9][0-9]*}}
// CHECK:      "instructions_by_opcode": {
// CHECK:        "div_s": {
// CHECK-NEXT:     "executed": {{[1-9][0-9]*}},
// CHECK-NEXT:     "data_stall_cycles": {{[1-9][0-9]*}},
// CHECK-NEXT:     "unit_conflict_cycles": {{[0-9]+}}
// CHECK:      "units": {
// CHECK:        "FPINV": {
// CHECK-NEXT:     "count_per_tm": 1,
// CHECK:          "utilisation": 0.
// CHECK:      "markers": {
// CHECK-NEXT:   "3": 4096
// CHECK:      "threads": {
// CHECK-NEXT:   "instructions": [

// RUN: tpsim --chip report-512x8 --quiet --host-threads 1 %t.elf --stats %t.again.json > %t.again.out
// RUN: tpsim --chip report-512x8 --quiet --host-threads 2 %t.elf --stats %t.2.json > %t.2.out
// RUN: tpsim --chip report-512x8 --quiet --host-threads 3 %t.elf --stats %t.3.json > %t.3.out
// RUN: cmp %t.1.json %t.again.json
// RUN: cmp %t.1.json %t.2.json
// RUN: cmp %t.1.json %t.3.json
// RUN: cmp %t.1.out %t.again.out
// RUN: cmp %t.1.out %t.2.out
// RUN: cmp %t.1.out %t.3.out

// Also when the run is cut off, at any cycle.
// RUN: %python %S/Inputs/expect_status.py 1 tpsim --chip 4x32 --quiet --max-cycles 777 %t.elf --stats %t.cut.json 2> %t.cut.err
// RUN: FileCheck %s --check-prefix=CUT < %t.cut.err
// CUT: tpsim: error: stopped after 777 cycles (--max-cycles)
// RUN: %python %S/Inputs/check_statistics.py %t.cut.json
// RUN: FileCheck %s --check-prefix=CUT-JSON < %t.cut.json
// CUT-JSON: "outcome": "cycle_limit"
// CUT-JSON: "cycles": 777,
// RUN: not tpsim --chip 4x32 --quiet --max-cycles 777 --host-threads 3 %t.elf --stats %t.cut3.json
// RUN: cmp %t.cut.json %t.cut3.json

// A limit just behind the end of an arbitration window, in which nothing issues.
// RUN: not tpsim --chip report-512x8 --quiet --max-cycles 65 %t.elf --stats %t.65.json
// RUN: %python %S/Inputs/check_statistics.py %t.65.json

// With caches and DRAM, for any number of host threads.
// RUN: tpsim --chip trax-32x32 --set tm.count=4 --quiet --host-threads 1 %t.elf --stats %t.l2.json > %t.l2.out
// RUN: tpsim --chip trax-32x32 --set tm.count=4 --quiet --host-threads 3 %t.elf --stats %t.l2-3.json > %t.l2-3.out
// RUN: cmp %t.l2.json %t.l2-3.json
// RUN: %python %S/Inputs/check_statistics.py %t.l2.json
// RUN: not tpsim --chip trax-32x32 --set tm.count=4 --set l1=none --set arbitration_window_cycles=32 --quiet --max-cycles 1500 %t.elf --stats %t.l2-cut.json
// RUN: %python %S/Inputs/check_statistics.py %t.l2-cut.json
// RUN: tpsim --quiet --chip 4x32 --functional %t.elf --stats %t.functional.json > %t.functional.out
// RUN: %python %S/Inputs/check_schema.py %statistics_schema %t.cut.json %t.l2.json %t.l2-cut.json %t.functional.json
// RUN: FileCheck %s --check-prefix=LEVELS < %t.l2.json
// LEVELS:      "memory": {
// LEVELS:        "l1": {
// LEVELS-NEXT:     "caches": 4,
// LEVELS-NEXT:     "loads": {{[1-9][0-9]*}},
// LEVELS:        "crossbar": {
// LEVELS:          "share_of_peak": 0.0
// LEVELS:        "l2": {
// LEVELS:        "dram": {
// LEVELS-NEXT:     "reads": {{[1-9][0-9]*}},
// LEVELS:          "read_latency_histogram": [0,
// LEVELS:          "channels": [
// LEVELS:      "energy": {
// LEVELS-NEXT:   "joules": {{[1-9].*}},
// LEVELS-NEXT:   "watts": {{[1-9].*}},
// LEVELS:        "parts": {
// LEVELS-NEXT:     "FPADD": {
// LEVELS-NEXT:       "operations": {{[1-9][0-9]*}},
// LEVELS:            "assumption": false
// LEVELS:          "local_store": {
// LEVELS:            "assumption": true

// The table shows the same run.
// RUN: tpsim --chip 1x1 %t.elf 2>&1 >/dev/null | FileCheck %s --check-prefix=TABLE
// TABLE: 1x1: 1 TMs x 1 TPs at 1 GHz
// TABLE: cycles
// TABLE: instructions
// TABLE: issued {{.*}} %
// TABLE: FPADD
// TABLE: total
// TABLE: simulated in {{.*}} million thread-instructions/s

// `--stats -` writes to standard output, behind what the program prints.
// RUN: tpsim --chip 1x1 --quiet %t.elf --stats - | FileCheck %s --check-prefix=DASH
// DASH: thread 0: {{.*}}
// DASH-NEXT: {{^[{]$}}
// DASH: "format_version"

// RUN: not tpsim --chip 1x1 --quiet %t.elf --stats %t.no-folder/x.json 2>&1 | FileCheck %s --check-prefix=NO-FOLDER
// NO-FOLDER: tpsim: error: cannot write {{.*}}no-folder/x.json: No such file or directory

#include <stdio.h>

unsigned Counter;
float Values[4096];

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  float Sum = Thread + 1.0f;
  for (unsigned I = 0; I != 20 + Thread % 7; ++I)
    Sum = Sum / (Values[(Thread + I * 64) % 4096] + 1.5f) + I;
  __builtin_tp_prof(3);
  Values[Thread] = Sum;
  __atomic_fetch_add(&Counter, 1, __ATOMIC_SEQ_CST);
  __builtin_tp_sync();
  __builtin_tp_barrier();
  if (Thread % 64 == 0) {
    __builtin_tp_sleep(100);
    printf("thread %u: %u threads, %d\n", Thread, Counter, (int)(Sum * 1000));
  }
  return 0;
}
