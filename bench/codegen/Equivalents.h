//===- Equivalents.h - The TP's builtins for other processors -----*- C -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Where the TP has one instruction, the other processor gets one: of the same
// operands where it has it, else any with them. So the counts compare the
// compilers, not what the processors can do in one step.
//
//===----------------------------------------------------------------------===//

#ifndef TP_BENCH_CODEGEN_EQUIVALENTS_H
#define TP_BENCH_CODEGEN_EQUIVALENTS_H

#if defined(__riscv)
#define TP_FLOAT_UNARY "fsqrt.s %0, %1"
#define TP_FLOAT_TO_INT "fcvt.w.s %0, %1"
#define TP_READ "csrr %0, cycle"
#define TP_USE "mv zero, %0"
#define TP_FENCE "fence"
#define TP_PUSH "add %0, %1, %2"
#define TP_POP "mv %0, %1"
#define TP_SERVICE "ecall"
#elif defined(__mips__)
#define TP_FLOAT_UNARY "sqrt.s %0, %1"
#define TP_FLOAT_TO_INT "mfc1 %0, %1"
#define TP_READ "rdhwr %0, $2"
#define TP_USE "move $zero, %0"
#define TP_FENCE "sync"
#define TP_PUSH "addu %0, %1, %2"
#define TP_POP "move %0, %1"
#define TP_SERVICE "syscall"
#endif

#define TP_EQUIVALENT static inline __attribute__((always_inline))

#define TP_FLOAT_FUNCTION(Name)                                                \
  TP_EQUIVALENT float __builtin_tp_##Name(float Argument) {                    \
    float Result;                                                              \
    __asm__(TP_FLOAT_UNARY : "=f"(Result) : "f"(Argument));                    \
    return Result;                                                             \
  }
#define TP_CONVERSION(Name)                                                    \
  TP_EQUIVALENT int __builtin_tp_##Name(float Argument) {                      \
    int Result;                                                                \
    __asm__(TP_FLOAT_TO_INT : "=r"(Result) : "f"(Argument));                   \
    return Result;                                                             \
  }
// Reads of different constants must not be taken for the same.
#define TP_CONSTANT(Name)                                                      \
  TP_EQUIVALENT unsigned __builtin_tp_##Name(void) {                           \
    unsigned Result;                                                           \
    __asm__(TP_READ " # " #Name : "=r"(Result));                               \
    return Result;                                                             \
  }
#define TP_COUNTER(Name)                                                       \
  TP_EQUIVALENT unsigned __builtin_tp_##Name(void) {                           \
    unsigned Result;                                                           \
    __asm__ volatile(TP_READ : "=r"(Result));                                  \
    return Result;                                                             \
  }
#define TP_FENCING(Name)                                                       \
  TP_EQUIVALENT void __builtin_tp_##Name(void) {                               \
    __asm__ volatile(TP_FENCE : : : "memory");                                 \
  }

TP_FLOAT_FUNCTION(rcp)
TP_FLOAT_FUNCTION(rsqrt)
TP_FLOAT_FUNCTION(sin)
TP_FLOAT_FUNCTION(cos)
TP_CONVERSION(trunc_w)
TP_CONVERSION(round_w)
TP_CONVERSION(floor_w)
TP_CONVERSION(ceil_w)
TP_CONSTANT(thread_id)
TP_CONSTANT(tp_id)
TP_CONSTANT(tm_id)
TP_CONSTANT(thread_count)
TP_CONSTANT(tp_count)
TP_CONSTANT(tm_count)
TP_CONSTANT(local_store_bytes)
TP_COUNTER(cycle)
TP_COUNTER(cycle_high)
TP_COUNTER(instret)
TP_COUNTER(instret_high)
TP_FENCING(barrier)
TP_FENCING(sync)

TP_EQUIVALENT void __builtin_tp_prof(unsigned) { __asm__ volatile("nop"); }
TP_EQUIVALENT void __builtin_tp_profv(unsigned, unsigned Value) {
  __asm__ volatile(TP_USE : : "r"(Value));
}
TP_EQUIVALENT void __builtin_tp_sleep(unsigned Cycles) {
  __asm__ volatile(TP_USE : : "r"(Cycles));
}
TP_EQUIVALENT unsigned __builtin_tp_stream_push(unsigned *Stream,
                                                unsigned Value) {
  unsigned Result;
  __asm__ volatile(TP_PUSH : "=r"(Result) : "r"(Stream), "r"(Value) : "memory");
  return Result;
}
TP_EQUIVALENT unsigned __builtin_tp_stream_pop(unsigned *Stream) {
  unsigned Result;
  __asm__ volatile(TP_POP : "=r"(Result) : "r"(Stream) : "memory");
  return Result;
}
TP_EQUIVALENT unsigned __builtin_tp_hostcall(unsigned, unsigned A, unsigned B,
                                             unsigned C) {
#if defined(__riscv)
  register unsigned First __asm__("a0") = A;
  register unsigned Second __asm__("a1") = B;
  register unsigned Third __asm__("a2") = C;
#else
  register unsigned First __asm__("$4") = A;
  register unsigned Second __asm__("$5") = B;
  register unsigned Third __asm__("$6") = C;
#endif
  __asm__ volatile(TP_SERVICE
                   : "+r"(First)
                   : "r"(Second), "r"(Third)
                   : "memory");
  return First;
}

#endif // TP_BENCH_CODEGEN_EQUIVALENTS_H
