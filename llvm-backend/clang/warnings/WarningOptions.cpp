//===- WarningOptions.cpp - Which -Wtp-fp warnings are on -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

// In the order of FloatingPointWarning.
static constexpr StringRef Names[] = {
    "tp-fp-flag-order", "tp-fp-ignored-flag", "tp-fp-nonfinite",
    "tp-fp-conversion", "tp-fp-comparator",   "tp-fp-mixed-infinities",
    "tp-double"};
static constexpr StringRef GroupName = "tp-fp";

namespace {
/// A -W word in its parts.
struct WarningWord {
  StringRef Name;
  bool IsNegative;
  bool ConcernsErrors;
};
} // namespace

static WarningWord parse(StringRef Word) {
  Word.consume_front("-W");
  bool IsNegative = Word.consume_front("no-");
  bool ConcernsErrors = Word.consume_front("error=");
  return {Word, IsNegative, ConcernsErrors};
}

static std::string closestName(StringRef Name) {
  StringRef Closest = GroupName;
  unsigned Distance = Name.edit_distance(GroupName);
  for (StringRef Known : Names)
    if (unsigned D = Name.edit_distance(Known); D < Distance) {
      Closest = Known;
      Distance = D;
    }
  return Closest.str();
}

bool WarningOptions::isOwnWord(StringRef Word) {
  return Word.starts_with("-W") && parse(Word).Name.starts_with("tp-");
}

Error WarningOptions::readOwnWord(StringRef Word) {
  WarningWord Parts = parse(Word);
  bool IsKnown = false;
  for (auto [Name, Warning] : zip_equal(Names, States)) {
    const bool IsInGroup = Name.starts_with(GroupName);
    if (Parts.Name != Name && !(IsInGroup && Parts.Name == GroupName))
      continue;
    IsKnown = true;
    if (!Parts.ConcernsErrors) {
      Warning.IsEnabled = !Parts.IsNegative;
      Warning.IsError &= Warning.IsEnabled;
      continue;
    }
    Warning.IsError = !Parts.IsNegative;
    Warning.IsNeverError = Parts.IsNegative;
    Warning.IsEnabled |= Warning.IsError;
  }
  if (IsKnown)
    return Error::success();
  std::string Prefix = Word.drop_back(Parts.Name.size()).str();
  return createStringError("unknown warning option '" + Word +
                           "'; did you mean '" + Prefix +
                           closestName(Parts.Name) + "'?");
}

void WarningOptions::readGeneralWord(StringRef Word) {
  if (Word == "-w")
    IgnoreAll = true;
  else if (Word == "-Werror")
    AllAreErrors = true;
  else if (Word == "-Wno-error")
    AllAreErrors = false;
  else if (Word == "-Weverything" || Word == "-Wno-everything")
    for (State &Warning : States)
      Warning.IsEnabled = Word == "-Weverything";
}

WarningLevel WarningOptions::level(FloatingPointWarning Warning) const {
  const State &Current = States[static_cast<size_t>(Warning)];
  if (IgnoreAll || !Current.IsEnabled)
    return WarningLevel::Ignored;
  bool IsError = Current.IsError || (AllAreErrors && !Current.IsNeverError);
  return IsError ? WarningLevel::Error : WarningLevel::Warning;
}

std::string WarningOptions::suffix(FloatingPointWarning Warning) const {
  bool IsError = level(Warning) == WarningLevel::Error;
  return (Twine(" [") + (IsError ? "-Werror," : "") + "-W" +
          Names[static_cast<size_t>(Warning)] + "]")
      .str();
}

bool reportWarning(const WarningOptions &Options, FloatingPointWarning Warning,
                   const Twine &Message) {
  WarningLevel Level = Options.level(Warning);
  if (Level == WarningLevel::Ignored)
    return false;
  bool IsError = Level == WarningLevel::Error;
  raw_ostream &Stream = IsError ? WithColor::error(errs(), "tpcc")
                                : WithColor::warning(errs(), "tpcc");
  Stream << Message << Options.suffix(Warning) << '\n';
  return IsError;
}

} // namespace tp
