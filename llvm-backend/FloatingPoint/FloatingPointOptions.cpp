//===- FloatingPointOptions.cpp - Options of the passes -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm/Support/CommandLine.h"
#include <optional>
#include <string>

using namespace llvm;

namespace {

/// An option that this process may already have: tpcc contains the passes, and
/// may load the plug-in, which contains them again. Both then read one option.
template <typename T> class SharedOption {
public:
  template <typename... Modifiers>
  SharedOption(StringRef Name, const Modifiers &...Modifier) {
    auto Registered = cl::getRegisteredOptions().find(Name);
    if (Registered != cl::getRegisteredOptions().end())
      Option = static_cast<cl::opt<T> *>(Registered->second);
    else
      Option = &Own.emplace(Name, cl::Hidden, Modifier...);
  }

  const T &get() const { return Option->getValue(); }

private:
  std::optional<cl::opt<T>> Own;
  cl::opt<T> *Option;
};

} // namespace

static SharedOption<bool>
    Canonicalize("tp-fp-canonicalize", cl::init(true),
                 cl::desc("Rewrite floating-point expressions in a form that "
                          "does not depend on their context"));

static SharedOption<std::string>
    Scope("tp-fp-scope", cl::value_desc("file"),
          cl::desc("Keep fast-math flags only where the file says"));

static SharedOption<std::string>
    ScopeList("tp-fp-scope-list", cl::value_desc("file"),
              cl::desc("Append to the file what fast-math flags there are"));

static SharedOption<bool>
    Check("tp-fp-check", cl::init(false),
          cl::desc("Trap on invalid floating-point values"));

bool llvm::isFloatingPointCanonicalizationEnabled() {
  return Canonicalize.get();
}

StringRef llvm::getFloatingPointScopeFile() { return Scope.get(); }

StringRef llvm::getFloatingPointScopeListFile() { return ScopeList.get(); }

bool llvm::isFloatingPointCheckEnabled() { return Check.get(); }
