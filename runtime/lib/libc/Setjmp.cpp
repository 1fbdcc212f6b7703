//===- Setjmp.cpp - Jumps out of functions --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include <setjmp.h>
#undef setjmp

// The buffer's words in their order, where the second argument is an
// instruction for an integer register and the third one for a float register.
#define TP_EACH_REGISTER(Integer, Float)                                       \
  Integer " r16, 0(r4)\n\t" Integer " r17, 4(r4)\n\t" Integer                  \
          " r18, 8(r4)\n\t" Integer " r19, 12(r4)\n\t" Integer                 \
          " r20, 16(r4)\n\t" Integer " r21, 20(r4)\n\t" Integer                \
          " r22, 24(r4)\n\t" Integer " r23, 28(r4)\n\t" Integer                \
          " r29, 32(r4)\n\t" Integer " r30, 36(r4)\n\t" Integer                \
          " r31, 40(r4)\n\t" Float " f20, 44(r4)\n\t" Float                    \
          " f21, 48(r4)\n\t" Float " f22, 52(r4)\n\t" Float                    \
          " f23, 56(r4)\n\t" Float " f24, 60(r4)\n\t" Float                    \
          " f25, 64(r4)\n\t" Float " f26, 68(r4)\n\t" Float                    \
          " f27, 72(r4)\n\t" Float " f28, 76(r4)\n\t" Float                    \
          " f29, 80(r4)\n\t" Float " f30, 84(r4)\n\t" Float " f31, 88(r4)\n\t"

extern "C" {

__attribute__((naked)) int setjmp(jmp_buf) {
  __asm__ volatile(TP_EACH_REGISTER("sw", "swc1") "addi r4, r0, 0\n\t"
                                                  "jr r31");
}

__attribute__((naked)) void longjmp(jmp_buf, int) {
  __asm__ volatile(TP_EACH_REGISTER("lw", "lwc1") "addi r4, r5, 0\n\t"
                                                  "bne r5, r0, 1f\n\t"
                                                  "addi r4, r0, 1\n"
                                                  "1:\n\t"
                                                  "jr r31");
}

int _setjmp(jmp_buf) __attribute__((alias("setjmp")));
void _longjmp(jmp_buf, int) __attribute__((alias("longjmp")));

} // extern "C"
