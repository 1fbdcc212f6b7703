// Instruction caches that miss: slower by what is waited for, and the same on
// any engine, number of host threads, and after a checkpoint.

// DEFINE: %{chip} =
// DEFINE: %{same} = tpsim %{chip} --quiet --engine reference --host-threads 1 %t.elf --stats %t.json && \
// DEFINE:   tpsim %{chip} --quiet --engine jit --host-threads 3 %t.elf --stats %t.jit.json && cmp %t.json %t.jit.json && \
// DEFINE:   not tpsim %{chip} --quiet --max-cycles 2000 --checkpoint %t.ck %t.elf && \
// DEFINE:   tpsim %{chip} --quiet --restore %t.ck %t.elf --stats %t.ck.json && cmp %t.json %t.ck.json && \
// DEFINE:   FileCheck %s --check-prefix=MISSES < %t.json

// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip 4x32 --quiet %t.elf --stats - | FileCheck %s --check-prefix=NEVER
// NEVER: "icache_miss": 0

// REDEFINE: %{chip} = --chip 4x32 --set icache.misses=fixed --set icache.miss_latency_cycles=150 --set icache.bytes=512 --set icache.line_bytes=32
// RUN: %{same}
// REDEFINE: %{chip} = --chip trax-32x32 --set tm.count=2 --set icache.misses=memory --set icache.bytes=512 --set icache.ways=2
// RUN: %{same}
// MISSES: "icache_miss": {{[1-9]}}

// RUN: not tpsim --chip 4x32 --set icache.misses=memory %t.elf 2>&1 | FileCheck %s --check-prefix=NO-MEMORY
// NO-MEMORY: icache.misses

unsigned Results[4096];

// Each step is far longer than a line.
#define STEP(N)                                                                \
  __attribute__((noinline)) unsigned step##N(unsigned X) {                     \
    for (unsigned I = 0; I != 3; ++I)                                          \
      X = (X * 33 + N ^ X >> 7) + (X << 3 | X >> 29) * (X % (N + 3));          \
    return X;                                                                  \
  }
STEP(1) STEP(2) STEP(3) STEP(4) STEP(5) STEP(6)

int main() {
  unsigned Thread = __builtin_tp_thread_id();
  unsigned (*const Steps[])(unsigned) = {step1, step2, step3,
                                         step4, step5, step6};
  unsigned X = Thread;
  for (unsigned I = 0; I != 12; ++I)
    X = Steps[(Thread + I * I) % 6](X);
  Results[Thread] = X;
  return 0;
}
