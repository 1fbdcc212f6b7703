// Execution without timing: the same output, memory and counts, no cycles.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: %python %S/../Simulator/Inputs/expect_status.py 3 tpsim --functional --chip 4x32 %t.elf --stats %t.json > %t.out 2> %t.err
// RUN: FileCheck %s --check-prefix=OUT < %t.out
// RUN: FileCheck %s --check-prefix=ERR < %t.err
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// OUT: sum 8128
// OUT-NOT: sum
// ERR: 4x32: 4 TMs x 32 TPs, without timing
// ERR-NEXT: run ended: finished, status 3
// ERR: {{instructions +[1-9]}}
// ERR: executed in {{.*}} million thread-instructions/s
// JSON: "mode": "functional"
// JSON: "outcome": "finished"
// JSON-NEXT: "exit_status": 3
// JSON-NOT: cycles
// JSON: "atom_add": {
// JSON-NEXT: "executed": {{[1-9][0-9]+}}
// JSON: "markers": {
// JSON-NEXT: "7": 128
// JSON-NOT: {{cycles|lost|energy}}

// The image is that of the cycle mode and of the native path tracer.
// RUN: tpcc -O2 -I%source_dir %kernels/pathtracer/PathTracer.cpp -o %t.pt.elf
// DEFINE: %{scene} = --scene %scenes/cornell/cornell.gltf --size 32x32 --depth 2
// RUN: tpsim %t.pt.elf --quiet --functional %{scene} -o %t.functional.png
// RUN: tpsim %t.pt.elf --quiet --chip 4x32 %{scene} -o %t.cycles.png
// RUN: pathtracer-native %{scene} -o %t.native.png
// RUN: cmp %t.functional.png %t.cycles.png
// RUN: cmp %t.functional.png %t.native.png

// Generated code does and counts what the interpreter does.
// DEFINE: %{larger} = --functional --quiet --per-pc --scene %scenes/cornell/cornell.gltf --size 160x160 --depth 2
// RUN: tpsim %t.pt.elf %{larger} -o %t.jit.png --stats %t.jit.json
// RUN: tpsim %t.pt.elf %{larger} -o %t.reference.png --stats %t.reference.json --engine=reference
// RUN: cmp %t.jit.png %t.reference.png
// RUN: cmp %t.jit.json %t.reference.json

// A trap says how far its thread was.
// RUN: tpcc -O1 -DTRAP %s -o %t.trap.elf
// RUN: not tpsim --functional --quiet --chip 4x32 %t.trap.elf 2>&1 | FileCheck %s --check-prefix=TRAP
// TRAP: error: thread 5 (TM 0, TP 5) trapped after {{[0-9]+}} instructions: null dereference

// What needs cycles has no meaning.
// RUN: not tpsim --functional --max-cycles 5 %t.elf 2>&1 | FileCheck %s --check-prefix=LIMIT
// LIMIT: error: --functional and --max-cycles exclude each other: the functional mode has no cycles

#include <stdio.h>

unsigned Sum;

int main() {
  unsigned Thread = __builtin_tp_thread_id();
#ifdef TRAP
  if (Thread == 5)
    *(volatile int *)(4 * Thread) = 1;
#endif
  __atomic_fetch_add(&Sum, Thread, __ATOMIC_RELAXED);
  __builtin_tp_prof(7);
  __builtin_tp_barrier();
  if (Thread == 0)
    printf("sum %u\n", *(volatile unsigned *)&Sum);
  return Thread == 9 ? 3 : 0;
}
