//===- LocationEvaluator.h - Where a variable is ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_LOCATIONEVALUATOR_H
#define TP_DEBUGGER_SOURCE_LOCATIONEVALUATOR_H

#include "debugger/source/FrameContext.h"
#include "debugger/source/Value.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"
#include "llvm/Support/Error.h"

#include <map>
#include <vector>

namespace tp {

class SourceMap;
class Unwinder;

/// Evaluates the locations of DWARF at a frame.
class LocationEvaluator {
public:
  /// What is passed must outlive the evaluator.
  LocationEvaluator(const SourceMap &Map, const Unwinder &Frames)
      : Map(Map), Frames(Frames) {}

  /// Where the variable \p Die of \p Size bytes is; no pieces if nowhere.
  llvm::Expected<std::vector<ValuePiece>>
  locate(llvm::DWARFDie Die, uint32_t Size, const FrameContext &Frame) const;

  /// The number that an attribute of \p Die has: a constant, or an expression
  /// (an array's bound) or the variable that it refers to. Nothing if it is
  /// not available.
  llvm::Expected<std::optional<int64_t>>
  number(llvm::DWARFDie Die, llvm::dwarf::Attribute Attribute,
         const FrameContext &Frame) const;

private:
  friend class LocationStack;

  const SourceMap &Map;
  const Unwinder &Frames;
  /// Calls by the address behind them, of the functions asked for.
  mutable llvm::DenseMap<uint32_t, llvm::DWARFDie> CallSites;
  mutable llvm::DenseMap<uint64_t, bool> FunctionsRead;
  /// Locations of variables by the offset of their entry.
  mutable std::map<uint64_t, llvm::DWARFLocationExpressionsVector> Locations;

  llvm::Expected<uint32_t> frameBase(const FrameContext &Frame) const;
  llvm::DWARFDie callSite(uint32_t ReturnPc) const;
  /// What the location's expression names had when the function was called.
  llvm::Expected<std::optional<uint64_t>>
  entryValue(llvm::ArrayRef<uint8_t> Expression,
             const FrameContext &Frame) const;
  void readCallSites(llvm::DWARFDie Die) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_LOCATIONEVALUATOR_H
