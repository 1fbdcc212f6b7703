// Counts and losses by instruction, with their places in the source.

// RUN: tpcc -O1 -g %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --stats %t.json --per-pc
// RUN: %python %S/Inputs/check_statistics.py %t.json
// RUN: %python %S/Inputs/check_schema.py %statistics_schema %t.json
// RUN: FileCheck %s < %t.json
// CHECK:      "instructions_by_pc": [
// CHECK:        "pc": "0x000{{[0-9a-f]+}}",
// CHECK:          "opcode": "mul",
// CHECK-NEXT:   "executed": 128,
// CHECK-NEXT:   "lost": {
// CHECK-NEXT:     "memory": {{[1-9][0-9]*}}
// CHECK:        "function": "{{.*}}scaled{{.*}}",
// CHECK-NEXT:   "file": "{{.*}}per-pc.cpp",
// CHECK-NEXT:   "line": [[@LINE+22]],
// CHECK-NEXT:   "column": {{[0-9]+}},
// CHECK-NEXT:   "inlined_into": [
// CHECK-NEXT:     {
// CHECK-NEXT:       "function": "main",
// CHECK:            "line": [[@LINE+26]],
// CHECK:        "opcode": "barrier",
// CHECK-NEXT:   "executed": 128,
// CHECK-NEXT:   "lost": {
// CHECK:          "barrier": {{[1-9][0-9]*}}

// Also what a cycle limit cuts off adds up.
// RUN: not tpsim --chip 4x32 --quiet --max-cycles 99 %t.elf --stats %t.cut.json --per-pc
// RUN: %python %S/Inputs/check_statistics.py %t.cut.json

// RUN: tpsim --chip 4x32 --quiet %t.elf --stats %t.without.json
// RUN: FileCheck %s --check-prefix=WITHOUT < %t.without.json
// WITHOUT-NOT: instructions_by_pc
// RUN: not tpsim --chip 4x32 %t.elf --per-pc 2>&1 | FileCheck %s --check-prefix=ALONE
// ALONE: tpsim: error: --per-pc has no meaning without --stats; give the file to write

static inline __attribute__((always_inline)) unsigned scaled(unsigned *Value) {
  return *Value * 7919;
}

unsigned Values[128];

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  Values[Thread] = Thread;
  __builtin_tp_sync();
  Values[Thread] = scaled(&Values[Thread ^ 1]);
  __builtin_tp_barrier();
  return 0;
}
