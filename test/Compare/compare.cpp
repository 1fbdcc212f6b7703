// What changed between two runs: by reason, function, line and instruction.

// RUN: tpcc -O2 -g %s -o %t.elf
// RUN: tpcc -O2 -g %s -DSLOW -o %t.slow.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --stats %t.json --per-pc
// RUN: tpsim --chip 4x32 --quiet %t.slow.elf --stats %t.slow.json --per-pc
// RUN: tpsim --compare %t.json %t.slow.json --compare-output %t.change.json \
// RUN:   | FileCheck %s
// CHECK:      before {{.*}}.json: 4x32, 4 TMs x 32 TPs, finished
// CHECK-NEXT: after {{.*}}.slow.{{(p\.)?}}json: 4x32
// CHECK:      instructions {{.*}} +
// CHECK:      thread-cycles before after change
// CHECK:      issued
// CHECK:      data
// CHECK:      all
// CHECK:      by function
// CHECK-NEXT: part(float)
// CHECK-NEXT: data +
// CHECK:      (all)
// CHECK:      by line
// CHECK-NEXT: {{.*}}compare.cpp:[[@LINE+44]] part(float)
// CHECK-NEXT: data +
// CHECK:      (all)
// CHECK:      rcp_s 0 {{.*}}1,280 +1,280 new

// All parts add up, and are those of the files.
// RUN: %python %S/Inputs/check_comparison.py %t.json %t.slow.json %t.change.json
// RUN: %python %S/../Simulator/Inputs/check_schema.py \
// RUN:   %source_dir/docs/comparison.schema.json %t.change.json

// Profiles say the same.
// RUN: tpsim --chip 4x32 --quiet %t.elf --profile=%t.p.json
// RUN: tpsim --chip 4x32 --quiet %t.slow.elf --profile=%t.slow.p.json
// RUN: tpsim --compare %t.p.json %t.slow.p.json | FileCheck %s
// RUN: tpsim --compare %t.json %t.p.json | FileCheck %s --check-prefix=MIXED
// MIXED: all {{[0-9,]+}} {{[0-9,]+}} 0
// MIXED: no lines: both files must be profiles, or statistics with --per-pc

// A run is like itself; JSON on standard output is alone there.
// RUN: tpsim --compare %t.json %t.json --compare-output=- > %t.same.json
// RUN: %python %S/Inputs/check_comparison.py %t.json %t.json %t.same.json

// Few rows: what is left out is one row.
// RUN: tpsim --compare %t.json %t.slow.json --compare-rows 1 \
// RUN:   | FileCheck %s --check-prefix=FEW
// FEW: by function
// FEW: {{[0-9]+}} others)
// FEW: instructions before after change
// FEW-NEXT: {{[a-z_]+}} {{.*}} +
// FEW-NEXT: ({{[0-9]+}} others) {{[0-9,]+}} {{[0-9,]+}} +
// FEW-NEXT: all

// Without timing there are instructions only.
// RUN: tpsim --functional --quiet %t.elf --stats %t.f.json --per-pc
// RUN: tpsim --functional --quiet %t.slow.elf --stats %t.fs.json --per-pc
// RUN: tpsim --compare %t.f.json %t.fs.json | FileCheck %s --check-prefix=FUNCTIONAL
// FUNCTIONAL-NOT: thread-cycles
// FUNCTIONAL: by line

volatile float Sink;

static __attribute__((noinline)) float part(float Value) {
#ifdef SLOW
  for (int I = 0; I != 10; ++I)
    Value = 1.0f / (Value + 1);
#endif
  return Value;
}

int main() {
  Sink = part(float(__builtin_tp_thread_id()));
  return 0;
}
