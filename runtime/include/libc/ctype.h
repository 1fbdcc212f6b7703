/*===- ctype.h - Kinds of characters, in the C locale ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_CTYPE_H
#define TP_LIBC_CTYPE_H

#ifdef __cplusplus
extern "C" {
#endif

int isalnum(int Character);
int isalpha(int Character);
int isblank(int Character);
int iscntrl(int Character);
int isdigit(int Character);
int isgraph(int Character);
int islower(int Character);
int isprint(int Character);
int ispunct(int Character);
int isspace(int Character);
int isupper(int Character);
int isxdigit(int Character);
int tolower(int Character);
int toupper(int Character);

#ifdef __cplusplus
}
#endif

#endif /* TP_LIBC_CTYPE_H */
