// Programs and thread_local objects that do not fit.
//
// RUN: not tpcc -nostdlib -DGLOBAL %s -o %t.elf 2>&1 | FileCheck --check-prefix=GLOBAL %s
// RUN: not tpcc -nostdlib -DLOCAL %s -o %t.elf 2>&1 | FileCheck --check-prefix=LOCAL %s

// GLOBAL: tpcc: error: the program ends at address 0x{{[0-9a-f]+}}, beyond the end of global memory (0xfff00000); make its arrays smaller
// LOCAL: tpcc: error: thread_local objects take {{[0-9]+}} bytes, more than the largest local store has
#ifdef GLOBAL
char One[0x7FFFFFFF], Two[0x7FFFFFFF];
void _start(void) { __builtin_tp_halt(One[__builtin_tp_thread_id()] + Two[__builtin_tp_thread_id()]); }
#else
_Thread_local char Large[0x200000];
void _start(void) { __builtin_tp_halt(Large[__builtin_tp_thread_id()]); }
#endif
