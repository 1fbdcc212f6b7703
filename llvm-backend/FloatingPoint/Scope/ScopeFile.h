//===- ScopeFile.h - Which instructions keep fast math --------- -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEFILE_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEFILE_H

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include <string>
#include <vector>

namespace llvm {

/// The items of one function (see ScopeItems.h) that keep their freedom.
class ScopeSelection {
public:
  /// Adds the items from \p First to \p Last, both included.
  void add(unsigned First, unsigned Last);
  void addAll() { IsAll = true; }
  void add(const ScopeSelection &Other);

  bool contains(unsigned Item) const;
  bool isAll() const { return IsAll; }

private:
  bool IsAll = false;
  SmallVector<std::pair<unsigned, unsigned>, 4> Ranges;
};

/// What a scope file says. Each line has three fields, separated by tabs:
/// \code
///   source file    function (mangled)    items
/// \endcode
/// Source file and function may be `*`, which matches any. Items are `*` or
/// numbers and ranges of numbers, `0,3-5`. Lines that begin with `#` and empty
/// ones mean nothing. What no line selects is strict.
class ScopeFile {
public:
  /// Reads \p Path; an error names the file, the line and what it should be.
  static Expected<ScopeFile> read(StringRef Path);

  /// Selects every item of every function.
  static ScopeFile everything();

  /// Whatever the lines that match this function select.
  ScopeSelection select(StringRef Source, StringRef Function) const;

private:
  struct Line {
    std::string Source;
    std::string Function;
    ScopeSelection Items;
  };

  static Expected<Line> parseLine(StringRef Text);

  std::vector<Line> Lines;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPEFILE_H
