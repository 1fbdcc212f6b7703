//===- MathFunctions.h - Which function a call computes ------- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_MATHFUNCTIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_MATHFUNCTIONS_H

namespace llvm {

class CallBase;
class Value;

/// What the rewrites distinguish among the functions of mathematics.
enum class MathFunction {
  /// Any other function.
  None,
  SquareRoot,
  Power,
  /// With an integer exponent: llvm.powi.
  IntegerPower,
  Minimum,
  Maximum,
  /// Libraries may round them differently: sine, exponential and so on.
  Approximate,
};

/// The function that \p Call computes on float or double, be it an intrinsic or
/// a library's.
MathFunction getMathFunction(const CallBase &Call);

/// \p V as a call of \p Function, or null.
CallBase *matchMathCall(Value &V, MathFunction Function);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CANONICALIZE_MATHFUNCTIONS_H
