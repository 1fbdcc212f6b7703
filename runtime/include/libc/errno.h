/*===- errno.h - The number of the last error ===*/
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */

#ifndef TP_LIBC_ERRNO_H
#define TP_LIBC_ERRNO_H

#define EDOM 33
#define ERANGE 34
#define EILSEQ 84
#define EINVAL 22
#define ENOMEM 12

#ifdef __cplusplus
extern "C"
#endif
    int *__tp_errno_location(void);

/* Each thread has its own. The math functions never set it. */
#define errno (*__tp_errno_location())

#endif /* TP_LIBC_ERRNO_H */
