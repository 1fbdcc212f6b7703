//===- FloatingPointFlags.cpp - Clang's floating-point options ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FloatingPointFlags.h"
#include "clang/Options/Options.h"

using namespace clang::options;

namespace tp {

bool isFloatingPointFlag(unsigned ID) {
  switch (ID) {
  case OPT_Ofast:
  case OPT_ffast_math:
  case OPT_fno_fast_math:
  case OPT_ffp_model_EQ:
  case OPT_ffp_contract:
  case OPT_ffp_eval_method_EQ:
  case OPT_ffp_exception_behavior_EQ:
  case OPT_funsafe_math_optimizations:
  case OPT_fno_unsafe_math_optimizations:
  case OPT_ffinite_math_only:
  case OPT_fno_finite_math_only:
  case OPT_fhonor_infinities:
  case OPT_fno_honor_infinities:
  case OPT_fhonor_nans:
  case OPT_fno_honor_nans:
  case OPT_fapprox_func:
  case OPT_fno_approx_func:
  case OPT_fmath_errno:
  case OPT_fno_math_errno:
  case OPT_fassociative_math:
  case OPT_fno_associative_math:
  case OPT_freciprocal_math:
  case OPT_fno_reciprocal_math:
  case OPT_fsigned_zeros:
  case OPT_fno_signed_zeros:
  case OPT_ftrapping_math:
  case OPT_fno_trapping_math:
  case OPT_frounding_math:
  case OPT_fno_rounding_math:
  case OPT_fprotect_parens:
  case OPT_fno_protect_parens:
  case OPT_fstrict_float_cast_overflow:
  case OPT_fno_strict_float_cast_overflow:
  case OPT_fdenormal_fp_math_EQ:
  case OPT_fcomplex_arithmetic_EQ:
  case OPT_fcx_limited_range:
  case OPT_fno_cx_limited_range:
  case OPT_fcx_fortran_rules:
  case OPT_fno_cx_fortran_rules:
    return true;
  default:
    return false;
  }
}

} // namespace tp
