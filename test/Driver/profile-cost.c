// Messages to the observer weigh nothing where the optimizer decides by size:
// the loop is unrolled with them as without.
//
// RUN: tpcc -O2 -S %s -o - | FileCheck %s
// RUN: tpcc -O2 -S -DMESSAGES %s -o - | FileCheck %s
// RUN: tpcc -O2 -S -DMESSAGES %s -o - | FileCheck %s --check-prefix=MESSAGES

// CHECK-LABEL: sum:
// CHECK-NOT: {{bne|beq}}
// CHECK: ret
// MESSAGES-COUNT-320: profv
unsigned sum(const unsigned *P) {
  unsigned Sum = 0;
  for (int I = 0; I != 40; ++I) {
    Sum = (Sum ^ P[I]) * 3;
#ifdef MESSAGES
    __builtin_tp_profv(1, Sum);
    __builtin_tp_profv(2, Sum);
    __builtin_tp_profv(3, Sum);
    __builtin_tp_profv(4, Sum);
    __builtin_tp_profv(5, Sum);
    __builtin_tp_profv(6, Sum);
    __builtin_tp_profv(7, Sum);
    __builtin_tp_profv(8, Sum);
#endif
  }
  return Sum;
}
