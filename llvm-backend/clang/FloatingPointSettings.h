//===- FloatingPointSettings.h - How floating point is compiled -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_FLOATINGPOINTSETTINGS_H
#define TP_LLVM_BACKEND_CLANG_FLOATINGPOINTSETTINGS_H

#include "llvm/ADT/StringRef.h"

#include <array>

namespace clang {
class CompilerInstance;
} // namespace clang

namespace tp {

/// What options decide about floating-point arithmetic, in the order of
/// reports.
enum class FloatingPointProperty {
  Reassociate,
  Reciprocal,
  ApproximateFunctions,
  SignedZeros,
  NaN,
  Infinity,
  Contraction,
  MathErrno,
  Trapping,
  Rounding,
  Subnormals,
  IntegerConversion,
  Canonicalization,
  FusedMultiplyAdd,
  CheckedMode
};

inline constexpr size_t NumFloatingPointProperties =
    static_cast<size_t>(FloatingPointProperty::CheckedMode) + 1;

/// The value of each property in words.
class FloatingPointSettings {
public:
  llvm::StringRef &operator[](FloatingPointProperty Property) {
    return Values[static_cast<size_t>(Property)];
  }
  llvm::StringRef operator[](FloatingPointProperty Property) const {
    return Values[static_cast<size_t>(Property)];
  }

private:
  std::array<llvm::StringRef, NumFloatingPointProperties> Values;
};

/// Values that the driver asks for by name.
inline constexpr llvm::StringRef AllowedValue = "allowed";
inline constexpr llvm::StringRef AssumedAbsentValue = "assumed absent";
inline constexpr llvm::StringRef AcrossExpressionsValue = "across expressions";
inline constexpr llvm::StringRef NoInstructionValue = "no";

/// What \p Property is called in reports.
llvm::StringRef floatingPointPropertyName(FloatingPointProperty Property);

/// Reads the settings from a front end whose target has been created, and hands
/// its `-mllvm` options to LLVM's command line, which holds some of them.
FloatingPointSettings
floatingPointSettings(const clang::CompilerInstance &Frontend);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_FLOATINGPOINTSETTINGS_H
