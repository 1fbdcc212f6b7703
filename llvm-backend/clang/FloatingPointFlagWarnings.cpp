//===- FloatingPointFlagWarnings.cpp - Hazards on the command line --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FloatingPointFlagWarnings.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

using namespace clang::options;
using namespace llvm;

namespace tp {

using Property = FloatingPointProperty;

namespace {
/// Looks at one command line.
class FlagWarner {
public:
  FlagWarner(const FloatingPointResolver &Resolver,
             ArrayRef<CommandLineOption> Options,
             const WarningOptions &Warnings)
      : Resolver(Resolver), Options(Options), Warnings(Warnings) {}

  void warnOfOrder();
  void warnOfAssociativeMath();
  void warnOfContraction();
  void warnOfForeignFlags();

  bool HasErrors = false;

private:
  void report(FloatingPointWarning Warning, const Twine &Message) {
    HasErrors |= reportWarning(Warnings, Warning, Message);
  }
  bool reassociates(ArrayRef<const char *> More) const;

  const FloatingPointResolver &Resolver;
  ArrayRef<CommandLineOption> Options;
  const WarningOptions &Warnings;
};
} // namespace

//===----------------------------------------------------------------------===//
// Flags that undo earlier ones
//===----------------------------------------------------------------------===//

// Whether the option drops infinities and NaN among other things.
static bool isUmbrella(const CommandLineOption &Option) {
  return is_contained({OPT_ffast_math, OPT_Ofast, OPT_ffp_model_EQ},
                      Option.ID) ||
         Option.name() == "-ftp-fp=fast";
}

// What the option says of infinities or of NaN by name: 1 to honour them, -1
// not to, 0 nothing.
static int explicitRequest(const CommandLineOption &Option,
                           Property InfinityOrNaN) {
  bool IsInfinity = InfinityOrNaN == Property::Infinity;
  switch (Option.ID) {
  case OPT_fno_finite_math_only:
    return 1;
  case OPT_ffinite_math_only:
    return -1;
  case OPT_fhonor_infinities:
    return IsInfinity ? 1 : 0;
  case OPT_fno_honor_infinities:
    return IsInfinity ? -1 : 0;
  case OPT_fhonor_nans:
    return IsInfinity ? 0 : 1;
  case OPT_fno_honor_nans:
    return IsInfinity ? 0 : -1;
  default:
    return 0;
  }
}

// The request to honour infinities or NaN that the options behind it have
// dropped without naming them.
static std::optional<size_t>
droppedRequest(const FloatingPointDecisions &Decisions,
               ArrayRef<CommandLineOption> Options, Property InfinityOrNaN) {
  std::optional<size_t> Decider = Decisions.decider(InfinityOrNaN);
  if (!Decider || !isUmbrella(Options[*Decider]) ||
      Decisions.Settings[InfinityOrNaN] != AssumedAbsentValue)
    return std::nullopt;
  for (size_t Index = *Decider; Index-- > 0;)
    if (int Request = explicitRequest(Options[Index], InfinityOrNaN))
      return Request > 0 ? std::optional(Index) : std::nullopt;
  return std::nullopt;
}

// Whether a request to honour infinities or NaN stands before an umbrella.
static bool mayDropRequests(ArrayRef<CommandLineOption> Options) {
  const auto *First = find_if(Options, [](const CommandLineOption &Option) {
    return explicitRequest(Option, Property::Infinity) > 0 ||
           explicitRequest(Option, Property::NaN) > 0;
  });
  return std::any_of(First, Options.end(), isUmbrella);
}

void FlagWarner::warnOfOrder() {
  if (!mayDropRequests(Options))
    return;
  std::optional<FloatingPointDecisions> Decisions =
      decideFloatingPoint(Resolver, Options);
  if (!Decisions)
    return;
  auto Report = [&](size_t Request, Property Decided, StringRef What) {
    report(FloatingPointWarning::FlagOrder,
           "'" + Options[*Decisions->decider(Decided)].text() + "' drops the " +
               What + " that '" + Options[Request].text() +
               "' asked for; put '" + Options[Request].text() + "' behind it");
  };
  auto Infinity = droppedRequest(*Decisions, Options, Property::Infinity);
  auto NaN = droppedRequest(*Decisions, Options, Property::NaN);
  if (Infinity && Infinity == NaN)
    return Report(*Infinity, Property::Infinity, "infinities and NaN");
  if (Infinity)
    Report(*Infinity, Property::Infinity, "infinities");
  if (NaN)
    Report(*NaN, Property::NaN, "NaN");
}

//===----------------------------------------------------------------------===//
// Flags that do nothing
//===----------------------------------------------------------------------===//

bool FlagWarner::reassociates(ArrayRef<const char *> More) const {
  auto Settings = Resolver.resolve(Options, More);
  return Settings && (*Settings)[Property::Reassociate] == AllowedValue;
}

void FlagWarner::warnOfAssociativeMath() {
  static constexpr const char *Companions[] = {"-fno-signed-zeros",
                                               "-fno-trapping-math"};
  auto IsAssociativeMath = [](const CommandLineOption &Option) {
    return Option.ID == OPT_fassociative_math;
  };
  if (none_of(Options, IsAssociativeMath) || reassociates({}) ||
      !reassociates(Companions))
    return;
  SmallVector<std::string, 2> Missing;
  for (const char *Companion : Companions) {
    SmallVector<const char *, 2> Others;
    copy_if(Companions, std::back_inserter(Others),
            [&](const char *Other) { return Other != Companion; });
    if (!reassociates(Others))
      Missing.push_back(("'" + Twine(Companion) + "'").str());
  }
  report(FloatingPointWarning::IgnoredFlag,
         "'-fassociative-math' does nothing without " + join(Missing, " and ") +
             "; write '-fassociative-math -fno-signed-zeros "
             "-fno-trapping-math', or '-ftp-fp=reproducible' for all rewrites "
             "that keep NaN and infinity");
}

void FlagWarner::warnOfContraction() {
  if (none_of(Options, [](const CommandLineOption &Option) {
        return Option.name().starts_with("-ffp-contract=fast");
      }))
    return;
  auto Decisions = decideFloatingPoint(Resolver, Options);
  if (!Decisions)
    return;
  std::optional<size_t> Decider = Decisions->decider(Property::Contraction);
  if (!Decider || Options[*Decider].ID != OPT_ffp_contract ||
      !Decisions->Settings[Property::Contraction].starts_with(
          AcrossExpressionsValue) ||
      Decisions->Settings[Property::FusedMultiplyAdd] != NoInstructionValue)
    return;
  report(FloatingPointWarning::IgnoredFlag,
         "'" + Options[*Decider].text() +
             "' does nothing: the chip has no fused multiply-add; add '-mfma' "
             "if yours has");
}

void FlagWarner::warnOfForeignFlags() {
  for (const CommandLineOption &Option : Options) {
    if (Option.ID == OPT_mrecip || Option.ID == OPT_mrecip_EQ)
      report(FloatingPointWarning::IgnoredFlag,
             "'" + Option.text() +
                 "' does nothing: the TP divides exactly and has no estimates; "
                 "'-freciprocal-math' allows reciprocals");
    else if (Option.ID == OPT_fexcess_precision_EQ ||
             Option.ID == OPT_ffloat16_excess_precision_EQ)
      report(FloatingPointWarning::IgnoredFlag,
             "'" + Option.text() +
                 "' does nothing: the TP rounds each operation to its type");
  }
}

bool warnOfFloatingPointFlags(const FloatingPointResolver &Resolver,
                              ArrayRef<CommandLineOption> Options,
                              const WarningOptions &Warnings) {
  auto IsOn = [&](FloatingPointWarning Warning) {
    return Warnings.level(Warning) != WarningLevel::Ignored;
  };
  FlagWarner Warner(Resolver, Options, Warnings);
  if (IsOn(FloatingPointWarning::FlagOrder))
    Warner.warnOfOrder();
  if (IsOn(FloatingPointWarning::IgnoredFlag)) {
    Warner.warnOfAssociativeMath();
    Warner.warnOfContraction();
    Warner.warnOfForeignFlags();
  }
  return Warner.HasErrors;
}

} // namespace tp
