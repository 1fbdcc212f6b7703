//===- Variables.h - The variables that can be seen at a place --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_VARIABLES_H
#define TP_DEBUGGER_SOURCE_VARIABLES_H

#include "debugger/source/SourceFiles.h"
#include "debugger/source/Value.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"

#include <optional>
#include <string>
#include <vector>

namespace tp {

class LocationEvaluator;
class NameIndex;
class SourceMap;
class TypeTable;

/// A variable, without regard to where a thread is.
struct VariableInfo {
  std::string Name;
  const Type *Of = nullptr;
  llvm::DWARFDie Die;
  bool IsParameter = false;
  /// `this`, and what the compiler made.
  bool IsArtificial = false;
  /// How many blocks around the place are further in: 0 is the innermost.
  unsigned BlockDepth = 0;
  /// Hidden by one of the same name further in.
  bool IsShadowed = false;
  SourcePosition Declared;
};

/// Finds variables by scope and name, and their values.
class Variables {
public:
  /// What is passed must outlive the object.
  Variables(const SourceMap &Map, const NameIndex &Names, TypeTable &Types,
            const LocationEvaluator &Locations);

  /// Parameters of the function of this frame, in their order.
  std::vector<VariableInfo> arguments(const FrameContext &Frame) const;
  /// Variables of the blocks of this frame, innermost block first.
  std::vector<VariableInfo> locals(const FrameContext &Frame) const;
  /// All global, static and thread_local variables, by qualified name.
  std::vector<VariableInfo> globals() const;

  /// The variable that \p Name means in this frame: of a block, of the
  /// function, then of its namespaces and classes, then any global.
  std::optional<VariableInfo> find(const FrameContext &Frame,
                                   llvm::StringRef Name) const;
  /// Only of the blocks and the function, also what its template was given.
  std::optional<VariableInfo> findLocal(const FrameContext &Frame,
                                        llvm::StringRef Name) const;
  /// Only of those that live as long as the program, the nearest one.
  std::optional<VariableInfo> findGlobal(const FrameContext &Frame,
                                         llvm::StringRef Name) const;

  /// Its value in this frame, perhaps optimized out. The error says what the
  /// debug information has that cannot be read.
  llvm::Expected<Value> value(const VariableInfo &Variable,
                              const FrameContext &Frame) const;

private:
  const SourceMap &Map;
  const NameIndex &Names;
  TypeTable &Types;
  const LocationEvaluator &Locations;

  VariableInfo describe(llvm::DWARFDie Die) const;
  llvm::Expected<const Type *> typeOf(const VariableInfo &Variable,
                                      const FrameContext &Frame) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_VARIABLES_H
