//===- YamlTree.h - A YAML document with line numbers -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_YAMLTREE_H
#define TP_SIMULATOR_CHIP_YAMLTREE_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <string>
#include <vector>

namespace tp {

struct YamlEntry;

/// A value of a YAML document. LLVM's parser streams its nodes; a chip file is
/// checked out of order, so it is held as a tree.
struct YamlValue {
  enum class Kind { Scalar, Mapping, Sequence };
  Kind Is = Kind::Scalar;
  /// Line of the value's first character, counted from 1.
  unsigned Line = 1;
  /// The scalar without its quotes; empty for `key:` without a value.
  std::string Text;
  /// The entries of a mapping, in the order of the file.
  std::vector<YamlEntry> Entries;

  /// The entry of this mapping with \p Key, or null.
  YamlEntry *find(llvm::StringRef Key);
  const YamlEntry *find(llvm::StringRef Key) const {
    return const_cast<YamlValue *>(this)->find(Key);
  }
};

/// A key of a mapping with its value.
struct YamlEntry {
  std::string Key;
  unsigned Line = 1;
  YamlValue Value;
};

/// The entry of \p Mapping at \p Path, keys with dots between them, or null.
YamlEntry *findPath(YamlValue &Mapping, llvm::StringRef Path);
inline const YamlEntry *findPath(const YamlValue &Mapping,
                                 llvm::StringRef Path) {
  return findPath(const_cast<YamlValue &>(Mapping), Path);
}

/// Adds \p Offset to all lines of \p Value.
void shiftLines(YamlValue &Value, unsigned Offset);

/// Reads the one document of \p Text, whose outermost value must be a mapping
/// and whose mappings must not repeat a key. Items of sequences are not kept.
/// Errors begin with `<FileName>:<line>: `.
llvm::Expected<YamlValue> parseYaml(llvm::StringRef Text,
                                    llvm::StringRef FileName);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_YAMLTREE_H
