// Atomics up to 32 bits are instructions; wider ones call the runtime.
//
// RUN: tpcc -O2 -S -emit-llvm -Wno-atomic-alignment %s -o - | FileCheck %s
// RUN: tpcc -O2 -S -Wno-atomic-alignment %s -o - | FileCheck --check-prefix=ASM %s

// CHECK-LABEL: @word(
// CHECK: atomicrmw add ptr {{.*}} seq_cst
int word(_Atomic int *P) { return __c11_atomic_fetch_add(P, 1, __ATOMIC_SEQ_CST); }
// CHECK-LABEL: @byte(
// CHECK: atomicrmw or ptr {{.*}} i8
char byte(_Atomic char *P) { return __c11_atomic_fetch_or(P, 1, __ATOMIC_RELAXED); }
// CHECK-LABEL: @smaller(
// CHECK: atomicrmw min ptr
int smaller(_Atomic int *P) { return __c11_atomic_fetch_min(P, 1, __ATOMIC_SEQ_CST); }
// CHECK-LABEL: @wide(
// CHECK: atomicrmw add ptr {{.*}} i64
// ASM-LABEL: wide:
// ASM: jal __atomic_fetch_add_8
long long wide(_Atomic long long *P) { return __c11_atomic_fetch_add(P, 1, __ATOMIC_SEQ_CST); }
