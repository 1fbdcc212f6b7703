/*===- inttypes.h - printf conversions of the exact-width integers ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_INTTYPES_H
#define TP_LIBC_INTTYPES_H

#include <stdint.h>

#define PRId8 "hhd"
#define PRIi8 "hhi"
#define PRIo8 "hho"
#define PRIu8 "hhu"
#define PRIx8 "hhx"
#define PRIX8 "hhX"
#define PRId16 "hd"
#define PRIi16 "hi"
#define PRIo16 "ho"
#define PRIu16 "hu"
#define PRIx16 "hx"
#define PRIX16 "hX"
#define PRId32 "d"
#define PRIi32 "i"
#define PRIo32 "o"
#define PRIu32 "u"
#define PRIx32 "x"
#define PRIX32 "X"
#define PRId64 "lld"
#define PRIi64 "lli"
#define PRIo64 "llo"
#define PRIu64 "llu"
#define PRIx64 "llx"
#define PRIX64 "llX"
#define PRIdMAX "jd"
#define PRIiMAX "ji"
#define PRIoMAX "jo"
#define PRIuMAX "ju"
#define PRIxMAX "jx"
#define PRIXMAX "jX"
#define PRIdPTR "zd"
#define PRIiPTR "zi"
#define PRIoPTR "zo"
#define PRIuPTR "zu"
#define PRIxPTR "zx"
#define PRIXPTR "zX"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  intmax_t quot;
  intmax_t rem;
} imaxdiv_t;

intmax_t imaxabs(intmax_t Value);
imaxdiv_t imaxdiv(intmax_t A, intmax_t B);
intmax_t strtoimax(const char *__restrict Text, char **__restrict End,
                   int Base);
uintmax_t strtoumax(const char *__restrict Text, char **__restrict End,
                    int Base);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_INTTYPES_H */
