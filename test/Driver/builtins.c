// Builtins become calls of the functions that the code generator knows, with
// what the optimizer may assume of them.
//
// RUN: tpcc -O1 -S -emit-llvm %s -o - | FileCheck %s
// RUN: tpcc -O1 -S -emit-llvm %s -o - | FileCheck --check-prefix=EFFECT %s
// RUN: tpcc -O0 -S -emit-llvm %s -o - | FileCheck --check-prefix=O0 %s
// RUN: tpcc -O2 -S %s -o - | FileCheck --check-prefix=ASM %s
// RUN: not tpcc -fsyntax-only -DBAD %s 2>&1 | FileCheck --check-prefix=BAD %s

// Equal calls without effects merge, and unused ones vanish.
// CHECK-LABEL: define {{.*}} @once(
// CHECK: call float @tp_rsqrt(float
// CHECK-NOT: call
// CHECK: ret
float once(float X) {
  (void)__builtin_tp_cos(X);
  return __builtin_tp_rsqrt(X) + __builtin_tp_rsqrt(X);
}

// A clock does not merge, but lets memory accesses pass.
// CHECK-LABEL: define {{.*}} @clock(
// CHECK: call i32 @tp_cycle()
// CHECK: call i32 @tp_cycle()
// CHECK-NOT: load
// CHECK: ret
unsigned clock(int *P) {
  *P = 7;
  unsigned Begin = __builtin_tp_cycle();
  int Known = *P;
  return __builtin_tp_cycle() - Begin + Known;
}

// A barrier lets nothing pass.
// CHECK-LABEL: define {{.*}} @exchange(
// CHECK: store i32 7
// CHECK: call void @tp_barrier()
// CHECK: load
int exchange(int *P) {
  *P = 7;
  __builtin_tp_barrier();
  return *P;
}

// EFFECT-DAG: declare {{.*}}float @tp_rsqrt(float noundef) {{.*}}#[[CONST:[0-9]+]]
// EFFECT-DAG: declare {{.*}}i32 @tp_cycle() {{.*}}#[[INACCESSIBLE:[0-9]+]]
// EFFECT-DAG: attributes #[[CONST]] = {{.*}}speculatable willreturn memory(none)
// EFFECT-DAG: attributes #[[INACCESSIBLE]] = {{.*}}memory(inaccessiblemem: readwrite)

// Messages do not merge, and let memory accesses pass.
// CHECK-LABEL: define {{.*}} @messages(
// CHECK: call void @tp_profv(i32 {{.*}}256, i32
// CHECK: call void @tp_profv(i32 {{.*}}256, i32
// CHECK-NOT: load
// CHECK: ret
int messages(int *P, unsigned Value) {
  *P = 7;
  __builtin_tp_profv(256, Value);
  __builtin_tp_profv(256, Value);
  return *P;
}

// O0: call float @tp_rsqrt(
// O0: call void @tp_barrier(

// ASM-LABEL: once:
// ASM: rsqrt_s
// ASM-NOT: rsqrt_s
// ASM-LABEL: exchange:
// ASM: barrier

#ifdef BAD
// BAD: error: {{.*}}argument to '__builtin_tp_prof' must be a constant integer
void bad(unsigned Phase) { __builtin_tp_prof(Phase); }
// BAD: error: {{.*}}argument to '__builtin_tp_profv' must be a constant integer
void badMarker(unsigned Marker) { __builtin_tp_profv(Marker, 1); }
// BAD: error: use of unknown builtin '__builtin_tp_teleport'
void worse(void) { __builtin_tp_teleport(); }
#endif
