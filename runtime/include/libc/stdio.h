/*===- stdio.h - Output in whole lines ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_STDIO_H
#define TP_LIBC_STDIO_H

/* A thread's text goes out when a line is complete, by fflush(), and when the
 * thread ends. There is no input and there are no files. */

#define __need_size_t
#define __need_NULL
#include <stddef.h>
#define __need___va_list
#include <stdarg.h>

#define EOF (-1)
#define BUFSIZ 4096

#ifdef __cplusplus
extern "C" {
#endif

typedef struct __tp_file FILE;

extern FILE *const stdout;
extern FILE *const stderr;
#define stdout stdout
#define stderr stderr

int printf(const char *__restrict Format, ...)
    __attribute__((format(printf, 1, 2)));
int fprintf(FILE *__restrict File, const char *__restrict Format, ...)
    __attribute__((format(printf, 2, 3)));
int sprintf(char *__restrict Buffer, const char *__restrict Format, ...)
    __attribute__((format(printf, 2, 3)));
int snprintf(char *__restrict Buffer, size_t Bytes,
             const char *__restrict Format, ...)
    __attribute__((format(printf, 3, 4)));
int vprintf(const char *__restrict Format, __builtin_va_list Arguments)
    __attribute__((format(printf, 1, 0)));
int vfprintf(FILE *__restrict File, const char *__restrict Format,
             __builtin_va_list Arguments) __attribute__((format(printf, 2, 0)));
int vsprintf(char *__restrict Buffer, const char *__restrict Format,
             __builtin_va_list Arguments) __attribute__((format(printf, 2, 0)));
int vsnprintf(char *__restrict Buffer, size_t Bytes,
              const char *__restrict Format, __builtin_va_list Arguments)
    __attribute__((format(printf, 3, 0)));
int putchar(int Character);
int putc(int Character, FILE *File);
int fputc(int Character, FILE *File);
int puts(const char *Text);
int fputs(const char *__restrict Text, FILE *__restrict File);
size_t fwrite(const void *__restrict Data, size_t Bytes, size_t Count,
              FILE *__restrict File);
int fflush(FILE *File);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_STDIO_H */
