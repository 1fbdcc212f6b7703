/*===- setjmp.h - Jumps out of functions ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_SETJMP_H
#define TP_LIBC_SETJMP_H

#ifdef __cplusplus
extern "C" {
#endif

/* The registers that a function keeps for its caller: r16 to r23, r29 to r31
 * and f20 to f31. */
typedef struct {
  unsigned Registers[23];
} jmp_buf[1];

int setjmp(jmp_buf Buffer) __attribute__((returns_twice));
/* The TP has no signals, so that this is the same. */
int _setjmp(jmp_buf Buffer) __attribute__((returns_twice));
/* Only within the thread that called setjmp, and before the function that did
 * returns. No destructors run. */
void longjmp(jmp_buf Buffer, int Value) __attribute__((noreturn));
void _longjmp(jmp_buf Buffer, int Value) __attribute__((noreturn));

#ifdef __cplusplus
}
#endif

#define setjmp(Buffer) setjmp(Buffer)

#endif /* TP_LIBC_SETJMP_H */
