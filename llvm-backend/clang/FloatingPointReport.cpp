//===- FloatingPointReport.cpp - Prints how floating point is compiled ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FloatingPointReport.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

static constexpr StringRef ValueTitle = "value";

static size_t valueWidth(const FloatingPointSettings &Settings) {
  size_t Width = ValueTitle.size();
  for (size_t I = 0; I < NumFloatingPointProperties; ++I)
    Width =
        std::max(Width, Settings[static_cast<FloatingPointProperty>(I)].size());
  return Width;
}

void printFloatingPointTable(raw_ostream &Stream,
                             const FloatingPointDecisions &Decisions,
                             ArrayRef<CommandLineOption> Options) {
  size_t Width = valueWidth(Decisions.Settings);
  auto PrintRow = [&](StringRef Name, StringRef Value, StringRef Decider) {
    Stream << left_justify(Name, 23) << left_justify(Value, Width + 2)
           << Decider << '\n';
  };
  PrintRow("floating point", ValueTitle, "decided by");
  for (size_t I = 0; I < NumFloatingPointProperties; ++I) {
    auto Property = static_cast<FloatingPointProperty>(I);
    std::optional<size_t> Decider = Decisions.decider(Property);
    PrintRow(floatingPointPropertyName(Property), Decisions.Settings[Property],
             Decider ? Options[*Decider].text() : "default");
  }
}

void printFloatingPointComment(raw_ostream &Stream,
                               const FloatingPointSettings &Settings) {
  StringRef Separator = "# floating point: ";
  for (size_t I = 0; I < NumFloatingPointProperties; ++I) {
    auto Property = static_cast<FloatingPointProperty>(I);
    Stream << Separator << floatingPointPropertyName(Property) << ": "
           << Settings[Property];
    Separator = "; ";
  }
  Stream << '\n';
}

} // namespace tp
