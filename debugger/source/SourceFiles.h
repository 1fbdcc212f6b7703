//===- SourceFiles.h - The source files of a program ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_SOURCEFILES_H
#define TP_DEBUGGER_SOURCE_SOURCEFILES_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/MD5.h"
#include "llvm/Support/MemoryBuffer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// Index of a file in SourceFiles.
using SourceFileId = uint32_t;

/// A line of a file; Line 0: unknown.
struct SourcePosition {
  SourceFileId File = 0;
  uint32_t Line = 0;
  uint32_t Column = 0;

  bool isKnown() const { return Line != 0; }
  friend bool operator==(const SourcePosition &,
                         const SourcePosition &) = default;
};

/// The files that a program was compiled from, and their text.
class SourceFiles {
public:
  SourceFiles();
  ~SourceFiles();
  SourceFiles(const SourceFiles &) = delete;
  SourceFiles &operator=(const SourceFiles &) = delete;

  /// Adds a file, or finds it: \p Name as the compiler was told, made absolute
  /// by \p Folder, where the compiler ran. \p Checksum is the text's when it
  /// was compiled.
  SourceFileId add(llvm::StringRef Name, llvm::StringRef Folder,
                   std::optional<llvm::MD5::MD5Result> Checksum);

  uint32_t size() const { return uint32_t(Files.size()); }
  /// As the compiler was told.
  llvm::StringRef name(SourceFileId File) const { return Files[File].Name; }
  /// Absolute, without dots, after substitution and search.
  std::string path(SourceFileId File) const;
  /// `main.cpp:12`, with the file's last component.
  std::string shortName(SourcePosition Position) const;

  /// The files that \p Name can mean: the whole path or its last components.
  std::vector<SourceFileId> find(llvm::StringRef Name) const;

  /// The lines of a file. The error says which path was tried.
  llvm::Expected<llvm::ArrayRef<llvm::StringRef>> text(SourceFileId File);
  /// The line, or nothing if the file cannot be read or is shorter.
  std::optional<llvm::StringRef> line(SourcePosition Position);
  /// Whether the file's text is not what was compiled.
  bool hasChanged(SourceFileId File);

  /// Paths that begin with \p From begin with \p To instead.
  void substitute(llvm::StringRef From, llvm::StringRef To);
  /// Looks for files that are not at their path in \p Folder too.
  void addFolder(llvm::StringRef Folder);

private:
  struct File {
    std::string Name;
    std::string Path;
    std::optional<llvm::MD5::MD5Result> Checksum;
    bool Loaded = false;
    std::string LoadError;
    std::unique_ptr<llvm::MemoryBuffer> Text;
    std::vector<llvm::StringRef> Lines;
  };

  std::vector<File> Files;
  llvm::StringMap<SourceFileId> ByPath;
  std::vector<std::pair<std::string, std::string>> Substitutions;
  std::vector<std::string> Folders;

  void load(File &F, SourceFileId Id);
  void forgetText();
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_SOURCEFILES_H
