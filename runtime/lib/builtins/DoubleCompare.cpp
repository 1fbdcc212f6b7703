//===- DoubleCompare.cpp - Order of IEEE doubles --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;

/// -1, 0 or 1 as \p A is less than, equal to or greater than \p B;
/// \p Unordered if one of them is a NaN.
static inline int compare(double A, double B, int Unordered) {
  uint64_t BitsA = bits(A), BitsB = bits(B);
  uint64_t MagnitudeA = BitsA & ~kSign;
  uint64_t MagnitudeB = BitsB & ~kSign;
  if (MagnitudeA > kInfinity || MagnitudeB > kInfinity)
    return Unordered;
  if ((MagnitudeA | MagnitudeB) == 0 || BitsA == BitsB)
    return 0;
  if ((BitsA ^ BitsB) & kSign)
    return BitsA & kSign ? -1 : 1;
  bool Less = BitsA < BitsB;
  return (BitsA & kSign ? !Less : Less) ? -1 : 1;
}

extern "C" {

int TP_LIBCALL(__eqdf2)(double A, double B) { return compare(A, B, 1); }
int TP_LIBCALL(__nedf2)(double A, double B) { return compare(A, B, 1); }
int TP_LIBCALL(__ltdf2)(double A, double B) { return compare(A, B, 1); }
int TP_LIBCALL(__ledf2)(double A, double B) { return compare(A, B, 1); }
int TP_LIBCALL(__gtdf2)(double A, double B) { return compare(A, B, -1); }
int TP_LIBCALL(__gedf2)(double A, double B) { return compare(A, B, -1); }

int TP_LIBCALL(__unorddf2)(double A, double B) {
  return (bits(A) & ~kSign) > kInfinity || (bits(B) & ~kSign) > kInfinity;
}

} // extern "C"
