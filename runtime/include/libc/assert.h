/*===- assert.h - Checks at run time ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

/* No include guard: NDEBUG may differ at each inclusion. */
#undef assert
#ifdef NDEBUG
#define assert(Condition) ((void)0)
#else
#define assert(Condition)                                                      \
  ((Condition) ? (void)0                                                       \
               : __tp_assert_fail(#Condition, __FILE__, __LINE__, __func__))
#endif

#ifndef TP_LIBC_ASSERT_H
#define TP_LIBC_ASSERT_H

#ifdef __cplusplus
extern "C"
#endif
    /* Writes a message and ends the program as abort() does. */
    void __tp_assert_fail(const char *Condition, const char *File, int Line,
                          const char *Function) __attribute__((noreturn));

#if !defined(__cplusplus) && !defined(static_assert) &&                        \
    (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 202311L)
#define static_assert _Static_assert
#endif

#endif /* TP_LIBC_ASSERT_H */
