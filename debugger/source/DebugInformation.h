//===- DebugInformation.h - What a program says of its source ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_DEBUGINFORMATION_H
#define TP_DEBUGGER_SOURCE_DEBUGINFORMATION_H

#include "debugger/source/Frames.h"
#include "debugger/source/SourceFiles.h"
#include "debugger/source/SourceMap.h"
#include "debugger/source/TypeTable.h"
#include "debugger/source/Variables.h"
#include "simulator/loader/ElfProgram.h"

#include "llvm/DebugInfo/DWARF/DWARFContext.h"

#include <memory>
#include <string>
#include <vector>

namespace tp {

class LocationEvaluator;
class NameIndex;

/// A program's debug information: files, lines, functions, types, variables
/// and frames. A program without any has symbols and addresses. What is asked
/// for is kept, so that no two threads of the host may ask at the same time.
class DebugInformation {
public:
  /// \p Program must outlive the object.
  explicit DebugInformation(const ElfProgram &Program);
  ~DebugInformation();

  SourceFiles &files() { return Files; }
  const SourceMap &map() const { return *Map; }
  TypeTable &types() { return *Types; }
  const Unwinder &unwinder() const { return *Frames; }
  const Variables &variables() const { return *Names; }
  const NameIndex &names() const { return *Index; }
  /// What is wrong with the debug information, one line each.
  llvm::ArrayRef<std::string> warnings() const { return Warnings; }

private:
  std::vector<std::string> Warnings;
  std::unique_ptr<llvm::DWARFContext> Dwarf;
  SourceFiles Files;
  std::unique_ptr<NameIndex> Index;
  std::unique_ptr<SourceMap> Map;
  std::unique_ptr<TypeTable> Types;
  std::unique_ptr<Unwinder> Frames;
  std::unique_ptr<LocationEvaluator> Locations;
  std::unique_ptr<Variables> Names;
};

/// The definition of a type as the source has it, members a line each: what
/// `ptype` prints.
std::string describeType(const Type &Of);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_DEBUGINFORMATION_H
