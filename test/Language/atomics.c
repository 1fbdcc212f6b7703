// Atomic objects of 1, 2, 4 and 8 bytes: operators, generic functions, floats,
// pointers, small structs, flags, fences, the old __sync functions.
// RUN: %compare %s %t --native clang
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

static uint64_t Hash = 1;
static void add(uint64_t V) { Hash = (Hash ^ V) * 1099511628211u; }

#define INTEGER(T, NAME)                                                       \
  static _Atomic T NAME##Global = 5;                                           \
  __attribute__((noinline)) static void test##NAME(_Atomic T *P, T V) {        \
    add(atomic_fetch_add(P, V)); add(atomic_fetch_sub(P, 3));                  \
    add(atomic_fetch_or(P, 0x55)); add(atomic_fetch_and(P, ~(T)0x11));         \
    add(atomic_fetch_xor(P, V)); add(atomic_exchange(P, V + 1));               \
    T Expected = V;                                                            \
    add(atomic_compare_exchange_strong(P, &Expected, 77)); add(Expected);      \
    add(atomic_compare_exchange_strong(P, &Expected, 78)); add(Expected);      \
    while (!atomic_compare_exchange_weak_explicit(P, &Expected, Expected + 1,  \
               memory_order_acq_rel, memory_order_relaxed)) {}                 \
    *P += V; *P *= 3; (*P)++; --*P; *P <<= 1; *P /= 2; add(*P);                \
    add(atomic_fetch_add_explicit(P, 1, memory_order_relaxed));                \
    add(atomic_load_explicit(P, memory_order_acquire));                        \
    atomic_store_explicit(P, 9, memory_order_release); add(*P);                \
    T Plain = 7;                                                               \
    add(__atomic_fetch_nand(&Plain, V, __ATOMIC_SEQ_CST)); add(Plain);         \
    add(__atomic_add_fetch(&Plain, V, __ATOMIC_RELAXED));                      \
    add(__atomic_nand_fetch(&Plain, V, __ATOMIC_ACQUIRE));                     \
    add(__sync_fetch_and_add(&Plain, 3)); add(__sync_sub_and_fetch(&Plain, V));\
    add(__sync_bool_compare_and_swap(&Plain, V, V)); add(Plain);               \
    add(__sync_val_compare_and_swap(&Plain, Plain, 4));                        \
    add(__sync_lock_test_and_set(&Plain, 1)); __sync_lock_release(&Plain);     \
    T Out; __atomic_load(&Plain, &Out, __ATOMIC_SEQ_CST); add(Out);            \
    __atomic_exchange(&Plain, &V, &Out, __ATOMIC_SEQ_CST); add(Out);           \
    printf(#NAME " %016llx\n", (unsigned long long)Hash);                      \
  }
INTEGER(int8_t, I8)
INTEGER(uint8_t, U8)
INTEGER(int16_t, I16)
INTEGER(uint16_t, U16)
INTEGER(int32_t, I32)
INTEGER(uint32_t, U32)
INTEGER(int64_t, I64)
INTEGER(uint64_t, U64)

struct Pair { int A, B; };
struct Odd { char A[3]; };
static _Atomic struct Pair Pairs;
static _Atomic struct Odd Odds;
static _Atomic float Float = 1.5f;
static _Atomic double Double = 2.5;
static _Atomic(int *) Pointer;
static _Atomic bool Bool;
static atomic_flag Flag = ATOMIC_FLAG_INIT;
static int Array[4] = {1, 2, 3, 4};

int main(void) {
  testI8(&I8Global, -100); testU8(&U8Global, 200);
  testI16(&I16Global, -30000); testU16(&U16Global, 60000);
  testI32(&I32Global, -2000000000); testU32(&U32Global, 4000000000);
  testI64(&I64Global, -8000000000000000000); testU64(&U64Global, 17000000000000000000u);
  struct Pair P = {1, 2}, Q = {5, 6};
  atomic_init(&Pairs, P);
  P = Pairs;
  printf("%d %d\n", P.A, P.B);
  bool Same = atomic_compare_exchange_strong(&Pairs, &P, Q);
  P = atomic_load(&Pairs);
  printf("%d %d %d\n", Same, P.A, P.B);
  struct Odd O = {{1, 2, 3}};
  Odds = O;
  O.A[0] = 4;
  O = atomic_exchange(&Odds, O);
  printf("%d %d\n", O.A[1], ((struct Odd)Odds).A[0]);
  Float += 2.25f; Float *= 2; Double /= 3; Double += 1;
  float F = Float;
  double D = Double;
  printf("%g %g\n", F, D);
  Pointer = Array;
  atomic_fetch_add(&Pointer, 2);
  int *Old = atomic_fetch_sub(&Pointer, 1);
  printf("%d %d\n", *Old, *atomic_load(&Pointer));
  printf("%d ", atomic_exchange(&Bool, true));
  printf("%d %d\n", Bool, atomic_fetch_and(&Bool, false));
  bool First = atomic_flag_test_and_set(&Flag), Second = atomic_flag_test_and_set(&Flag);
  atomic_flag_clear(&Flag);
  printf("%d %d %d\n", First, Second, atomic_flag_test_and_set(&Flag));
  int Least = 3, Most = 3;
  uint16_t Half = 9;
  int64_t Wide = 5;
  __atomic_fetch_max(&Most, 5, __ATOMIC_SEQ_CST);
  __atomic_fetch_min(&Least, -5, __ATOMIC_SEQ_CST);
  __atomic_fetch_min(&Half, 2, __ATOMIC_RELAXED);
  __atomic_fetch_max(&Wide, 1ll << 40, __ATOMIC_SEQ_CST);
  printf("%d %d %d %lld\n", Most, Least, Half, (long long)Wide);
  __atomic_fetch_add(&F, 2.0f, __ATOMIC_SEQ_CST);
  __atomic_fetch_sub(&D, 2.0, __ATOMIC_SEQ_CST);
  printf("%g %g\n", F, D);
  atomic_thread_fence(memory_order_seq_cst);
  atomic_signal_fence(memory_order_seq_cst);
  printf("%d\n", atomic_is_lock_free(&I32Global));
}
