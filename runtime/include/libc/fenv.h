/*===- fenv.h - The floating-point environment ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_FENV_H
#define TP_LIBC_FENV_H

/* The TP rounds to nearest and has no exception flags. So that no macro of a
 * flag or of another rounding is defined, and the functions have nothing to
 * do. */

#define FE_ALL_EXCEPT 0
#define FE_TONEAREST 0
#define FE_DFL_ENV ((const fenv_t *)0)

typedef struct {
  unsigned Unused;
} fenv_t;
typedef unsigned fexcept_t;

#ifdef __cplusplus
extern "C" {
#endif

static inline int feclearexcept(int Flags) { return Flags; }
static inline int fegetexceptflag(fexcept_t *To, int Flags) {
  *To = 0;
  return Flags;
}
static inline int feraiseexcept(int Flags) { return Flags; }
static inline int fesetexceptflag(const fexcept_t *From, int Flags) {
  (void)From;
  return Flags;
}
static inline int fetestexcept(int Flags) {
  (void)Flags;
  return 0;
}
static inline int fegetround(void) { return FE_TONEAREST; }
static inline int fesetround(int Rounding) { return Rounding != FE_TONEAREST; }
static inline int fegetenv(fenv_t *To) {
  To->Unused = 0;
  return 0;
}
static inline int feholdexcept(fenv_t *To) { return fegetenv(To); }
static inline int fesetenv(const fenv_t *From) {
  (void)From;
  return 0;
}
static inline int feupdateenv(const fenv_t *From) { return fesetenv(From); }

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_FENV_H */
