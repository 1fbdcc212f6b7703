//===- Symbolizer.h - Source locations of addresses -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_LOADER_SYMBOLIZER_H
#define TP_SIMULATOR_LOADER_SYMBOLIZER_H

#include "simulator/loader/ElfProgram.h"

#include "llvm/DebugInfo/Symbolize/Symbolize.h"

#include <string>
#include <vector>

namespace tp {

/// A place in the source. Parts that nothing is known of are empty or 0.
struct SourceFrame {
  /// Demangled.
  std::string Function;
  /// As the compiler was told.
  std::string File;
  unsigned Line = 0;
  unsigned Column = 0;
  /// Where Function begins.
  std::string FunctionFile;
  unsigned FunctionLine = 0;
};

/// How files are named.
enum class SourcePaths {
  /// As the compiler was told, without the directories that it looked in.
  AsCompiled,
  /// With those directories, as far as they are not relative to the one that
  /// the compiler ran in.
  Relative,
  Absolute,
};

/// Finds where an instruction comes from, by DWARF and else by the symbol
/// table.
class Symbolizer {
public:
  /// \p Program must outlive the symbolizer.
  explicit Symbolizer(const ElfProgram &Program,
                      SourcePaths Paths = SourcePaths::AsCompiled);

  /// The function that holds \p Pc and those it was inlined into, innermost
  /// first. Empty if nothing is known.
  std::vector<SourceFrame> frames(uint32_t Pc);

  /// `in function at file:line:column` for one frame, without the parts that
  /// are unknown; a file without a line is left out.
  static std::string describe(const SourceFrame &Frame);

private:
  const ElfProgram &Program;
  llvm::symbolize::LLVMSymbolizer Implementation;
};

} // namespace tp

#endif // TP_SIMULATOR_LOADER_SYMBOLIZER_H
