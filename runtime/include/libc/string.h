/*===- string.h - Memory and zero-terminated strings ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_STRING_H
#define TP_LIBC_STRING_H

#define __need_size_t
#define __need_NULL
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void *memcpy(void *__restrict Target, const void *__restrict Source,
             size_t Bytes);
void *memmove(void *Target, const void *Source, size_t Bytes);
void *memset(void *Target, int Value, size_t Bytes);
int memcmp(const void *A, const void *B, size_t Bytes);
void *memchr(const void *Memory, int Value, size_t Bytes);

size_t strlen(const char *Text);
size_t strnlen(const char *Text, size_t Limit);
char *strcpy(char *__restrict Target, const char *__restrict Source);
char *stpcpy(char *__restrict Target, const char *__restrict Source);
char *strncpy(char *__restrict Target, const char *__restrict Source,
              size_t Bytes);
char *strcat(char *__restrict Target, const char *__restrict Source);
char *strncat(char *__restrict Target, const char *__restrict Source,
              size_t Bytes);
int strcmp(const char *A, const char *B);
int strncmp(const char *A, const char *B, size_t Bytes);
int strcoll(const char *A, const char *B);
char *strchr(const char *Text, int Character);
char *strrchr(const char *Text, int Character);
char *strstr(const char *Text, const char *Part);
size_t strspn(const char *Text, const char *Set);
size_t strcspn(const char *Text, const char *Set);
char *strpbrk(const char *Text, const char *Set);
char *strtok(char *__restrict Text, const char *__restrict Separators);
char *strtok_r(char *__restrict Text, const char *__restrict Separators,
               char **__restrict Next);
char *strdup(const char *Text);
char *strndup(const char *Text, size_t Limit);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_STRING_H */
