// Debug data of a linked program: consistent, and with inlined frames.
//
// RUN: tpcc -O2 -g %s -o %t.elf
// RUN: llvm-dwarfdump --verify %t.elf
// RUN: llvm-dwarfdump --name=inner %t.elf | FileCheck %s
// RUN: tpcc -O0 -gdwarf-4 %s -o %t.elf && llvm-dwarfdump --verify %t.elf
// RUN: tpcc -O2 -g -fno-lto -ffunction-sections %s -o %t.elf && llvm-dwarfdump --verify %t.elf
// RUN: tpcc -O2 -g -nostdlib -DBARE %s -o %t.elf
// RUN: tp-objdump -d %t.elf | grep -w sw | sed -e 's/^ */0x/' -e 's/:.*//' | llvm-symbolizer --obj=%t.elf | FileCheck --check-prefix=FRAMES %s

// CHECK: DW_TAG_subprogram
// CHECK: DW_AT_name ("inner")

static inline __attribute__((always_inline)) void inner(volatile int *P) {
  *P = 1;
}
static inline __attribute__((always_inline)) void outer(volatile int *P) {
  inner(P);
}

// FRAMES: inner(int volatile*)
// FRAMES-NEXT: debug-info.cpp:[[#@LINE - 7]]
// FRAMES-NEXT: outer(int volatile*)
// FRAMES-NEXT: debug-info.cpp:[[#@LINE - 6]]
// FRAMES-NEXT: _start
#ifdef BARE
extern "C" void _start() {
  outer(reinterpret_cast<int *>(0x20000));
  __builtin_tp_halt(0);
}
#else
__attribute__((noinline)) void unused() {}
int Target;
int main() {
  outer(&Target);
  return Target - 1;
}
#endif
