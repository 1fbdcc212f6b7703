//===- SourceLines.h - Source lines of instructions -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_SOURCELINES_H
#define TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_SOURCELINES_H

#include "llvm-backend/tools/tp-objdump/DebugImage.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/DebugInfo/DIContext.h"
#include "llvm/DebugInfo/Symbolize/Symbolize.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Prints where in the source instructions come from, as comments, each time
/// that it changes. Silent where there is no debugging information.
class SourceLines {
public:
  /// `LineNumbers` prints function, file and line, `Text` the source itself.
  SourceLines(const ObjectInput &Input, bool LineNumbers, bool Text);

  void print(const Section &Section, uint32_t Address, llvm::raw_ostream &OS);

private:
  /// A line of a source file, or an empty string if there is none.
  llvm::StringRef textOf(const std::string &FileName, uint32_t Line);

  const bool LineNumbers;
  const bool Text;
  DebugImage Image;
  llvm::symbolize::LLVMSymbolizer Symbolizer;
  llvm::DILineInfo Last;
  llvm::StringMap<std::unique_ptr<llvm::MemoryBuffer>> Files;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_OBJDUMP_SOURCELINES_H
