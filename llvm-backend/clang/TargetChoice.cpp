//===- TargetChoice.cpp - Options that name the target --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/TargetChoice.h"
#include "llvm-backend/TPDataLayout.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/STLExtras.h"

using namespace clang::options;
using namespace llvm;

namespace tp {

static constexpr StringRef Triples[] = {
    "tp", "tp-elf", "tp-none-elf", "tp-unknown-elf", "tp-unknown-unknown-elf"};

bool isTargetChoice(const CommandLineOption &Option) {
  switch (Option.ID) {
  case OPT_target:
  case OPT_target_legacy_spelling:
  case OPT_march_EQ:
  case OPT_mcpu_EQ:
  case OPT_mtune_EQ:
  case OPT_m16:
  case OPT_m32:
  case OPT_m64:
  case OPT_mx32:
    return true;
  default:
    return false;
  }
}

static StringRef valueOf(const CommandLineOption &Option) {
  return Option.Words.size() > 1 ? StringRef(Option.Words.back())
                                 : Option.name().split('=').second;
}

Error checkTargetChoice(const CommandLineOption &Option) {
  StringRef Value = valueOf(Option);
  switch (Option.ID) {
  case OPT_target:
  case OPT_target_legacy_spelling:
    if (is_contained(Triples, Value))
      return Error::success();
    return createStringError("unknown target '" + Value + "' in '" +
                             Option.text() + "'; tpcc compiles for " +
                             llvm::TPTriple + ", clang for other targets");
  case OPT_m32:
    return Error::success();
  case OPT_m16:
  case OPT_m64:
  case OPT_mx32:
    return createStringError("'" + Option.text() +
                             "' is not possible: the TP has 32-bit pointers");
  case OPT_march_EQ:
    if (Value == "tp")
      return Error::success();
    return createStringError(
        "unknown architecture '" + Value + "' in '" + Option.text() +
        "'; valid: tp (-mfma and -mno-trig change the instructions)");
  default:
    if (Value == "generic")
      return Error::success();
    return createStringError(
        "unknown processor '" + Value + "' in '" + Option.text() +
        "'; valid: generic (-mfma and -mno-trig change the instructions)");
  }
}

} // namespace tp
