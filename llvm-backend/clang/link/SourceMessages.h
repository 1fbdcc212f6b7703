//===- SourceMessages.h - Messages about places in the source ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_SOURCEMESSAGES_H
#define TP_LLVM_BACKEND_CLANG_LINK_SOURCEMESSAGES_H

#include "llvm/ADT/StringMap.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/SourceMgr.h"

#include <string>

namespace tp {

/// A place in a source file. Line and column are 0 if they are not known.
struct SourcePlace {
  std::string File;
  unsigned Line = 0;
  unsigned Column = 0;
};

/// Prints messages as clang does, with the line of the source if its file is
/// still there. The linker has no front end that could.
class SourceMessages {
public:
  void print(llvm::SourceMgr::DiagKind Kind, const SourcePlace &Place,
             const llvm::Twine &Message);

private:
  llvm::StringRef lineAt(const SourcePlace &Place);

  llvm::StringMap<std::unique_ptr<llvm::MemoryBuffer>> Files;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_SOURCEMESSAGES_H
