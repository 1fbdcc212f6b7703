//===- Suppressions.h - Reports that the user does not want -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A text file with a line `<checker>:<function>` for each: reports of this
// checker (`*`: of any) in whose stacks this function occurs are not shown. The
// function is the demangled name without arguments or with them; `*` and `?`
// stand for what may be anything. Empty lines and those that begin with `#` say
// nothing.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_SUPPRESSIONS_H
#define TP_SIMULATOR_CHECK_SUPPRESSIONS_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Allocator.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/GlobPattern.h"

#include <memory>
#include <string>
#include <vector>

namespace tp {

/// The checkers that --check= knows.
inline constexpr const char *CheckerNames[] = {"memory", "init", "stack",
                                               "race"};

/// Functions whose faults are not to be shown.
class Suppressions {
public:
  /// Suppresses nothing.
  Suppressions() = default;
  /// Errors name the file, the line and what is allowed.
  static llvm::Expected<Suppressions> read(llvm::StringRef Path);

  bool isEmpty() const { return Rules.empty(); }
  /// Whether reports of \p Check that involve \p Function, demangled, are
  /// suppressed.
  bool covers(llvm::StringRef Check, llvm::StringRef Function) const;

private:
  struct Rule {
    std::string Check;
    llvm::GlobPattern Function;
  };
  /// The texts that the patterns refer to.
  std::shared_ptr<llvm::BumpPtrAllocator> Texts =
      std::make_shared<llvm::BumpPtrAllocator>();
  std::vector<Rule> Rules;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_SUPPRESSIONS_H
