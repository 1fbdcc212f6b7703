// Sizes of types and predefined macros.
//
// RUN: tpcc -dM -E %s | FileCheck %s
// RUN: tpcc -dM -E -mno-trig %s | FileCheck --check-prefix=NOTRIG %s
// RUN: tpcc -fsyntax-only %s
// RUN: tpcc -fsyntax-only -x c++ %s

// CHECK-DAG: #define __ELF__ 1
// CHECK-DAG: #define __LITTLE_ENDIAN__ 1
// CHECK-DAG: #define __TP_TRIG__ 1
// CHECK-DAG: #define __TP__ 1
// CHECK-DAG: #define __tp__ 1
// CHECK-DAG: #define __DBL_MANT_DIG__ 53
// CHECK-DAG: #define __LDBL_MANT_DIG__ 53
// CHECK-DAG: #define __GCC_ATOMIC_INT_LOCK_FREE 2
// CHECK-DAG: #define __GCC_ATOMIC_LLONG_LOCK_FREE 1
// CHECK-DAG: #define __SIZE_TYPE__ unsigned int
// NOTRIG-NOT: __TP_TRIG__

#ifdef __cplusplus
#define _Static_assert static_assert
#define _Alignof alignof
#endif
_Static_assert(sizeof(void *) == 4 && sizeof(long) == 4 && sizeof(int) == 4, "");
_Static_assert(sizeof(long long) == 8 && _Alignof(long long) == 8, "");
_Static_assert(sizeof(double) == 8 && sizeof(long double) == 8, "");
_Static_assert(_Alignof(double) == 8, "");
_Static_assert(sizeof(__WCHAR_TYPE__) == 4 && (char)-1 < 0, "");
_Static_assert(__atomic_always_lock_free(4, 0), "");
_Static_assert(!__atomic_always_lock_free(8, 0), "");
