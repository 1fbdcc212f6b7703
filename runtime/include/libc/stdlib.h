/*===- stdlib.h - Ending, memory, numbers, sorting ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_STDLIB_H
#define TP_LIBC_STDLIB_H

#define __need_size_t
#define __need_wchar_t
#define __need_NULL
#include <stddef.h>

#define EXIT_SUCCESS 0
#define EXIT_FAILURE 1
#define RAND_MAX 0x7fffffff

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  int quot;
  int rem;
} div_t;
typedef struct {
  long quot;
  long rem;
} ldiv_t;
typedef struct {
  long long quot;
  long long rem;
} lldiv_t;

/* Ends the calling thread. The program's status is the first one in the order
 * of the threads that is not 0. */
void exit(int Status) __attribute__((noreturn));
void _Exit(int Status) __attribute__((noreturn));
/* Ends the whole program as a trap does. */
void abort(void) __attribute__((noreturn));
/* Called by the last thread that ends. */
int atexit(void (*Function)(void));

/* One heap for all threads, behind the program in global memory. Memory that is
 * given back joins what is free beside it. */
void *malloc(size_t Bytes) __attribute__((malloc));
void *calloc(size_t Count, size_t Bytes) __attribute__((malloc));
void *realloc(void *Memory, size_t Bytes);
void *aligned_alloc(size_t Alignment, size_t Bytes) __attribute__((malloc));
void free(void *Memory);

int abs(int Value);
long labs(long Value);
long long llabs(long long Value);
div_t div(int A, int B);
ldiv_t ldiv(long A, long B);
lldiv_t lldiv(long long A, long long B);

double atof(const char *Text);
int atoi(const char *Text);
long atol(const char *Text);
long long atoll(const char *Text);
double strtod(const char *__restrict Text, char **__restrict End);
float strtof(const char *__restrict Text, char **__restrict End);
long double strtold(const char *__restrict Text, char **__restrict End);
long strtol(const char *__restrict Text, char **__restrict End, int Base);
unsigned long strtoul(const char *__restrict Text, char **__restrict End,
                      int Base);
long long strtoll(const char *__restrict Text, char **__restrict End, int Base);
unsigned long long strtoull(const char *__restrict Text, char **__restrict End,
                            int Base);

void qsort(void *Elements, size_t Count, size_t Bytes,
           int (*Compare)(const void *, const void *));
void *bsearch(const void *Key, const void *Elements, size_t Count, size_t Bytes,
              int (*Compare)(const void *, const void *));

/* A sequence of its own in every thread. */
int rand(void);
void srand(unsigned Seed);

char *getenv(const char *Name);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_STDLIB_H */
