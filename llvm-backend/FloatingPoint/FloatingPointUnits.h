//===- FloatingPointUnits.h - What units assume of infinity -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTUNITS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTUNITS_H

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"

#include <string>

namespace llvm {

class Module;

/// A translation unit with floating point in it, as the linker compares it with
/// others.
struct FloatingPointUnit {
  std::string SourceFile;
  /// Whether it was compiled as if there were no NaN or no infinities.
  bool IsFinite;
};

/// Adds \p Unit to the `!tp.floating_point` of \p M.
void addFloatingPointUnit(Module &M, const FloatingPointUnit &Unit);

/// The units that were linked into \p M.
SmallVector<FloatingPointUnit> floatingPointUnits(const Module &M);

/// The bytes of an object's section `.tp.floating_point` for \p Units.
std::string
encodeFloatingPointUnits(const SmallVectorImpl<FloatingPointUnit> &Units);

/// The units that \p Section says; those before the damage if it is damaged.
SmallVector<FloatingPointUnit> decodeFloatingPointUnits(StringRef Section);

/// The section of an object that lists its units; not part of a program.
inline constexpr const char FloatingPointUnitsSection[] = ".tp.floating_point";

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTUNITS_H
