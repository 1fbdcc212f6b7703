//===- FloatingPointResolver.cpp - Which option decides what --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FloatingPointResolver.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/DriverArguments.h"
#include "llvm-backend/clang/FloatingPointFlags.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "llvm-backend/clang/OwnOptions.h"
#include "clang/Driver/Compilation.h"
#include "clang/Driver/Driver.h"
#include "clang/Frontend/CompilerInstance.h"
#include "clang/Options/Options.h"
#include "llvm/Option/OptTable.h"

using namespace clang;
using namespace clang::options;
using namespace llvm;

namespace tp {

// Whether the option can change how floating point is compiled.
static bool isRelevant(const CommandLineOption &Option) {
  return isOwnFloatingPointOption(Option.name()) ||
         isFloatingPointFlag(Option.ID) || Option.ID == OPT_Xclang ||
         Option.ID == OPT_mllvm ||
         getDriverOptTable().getOption(Option.ID).matches(OPT_O_Group);
}

//===----------------------------------------------------------------------===//
// One command line
//===----------------------------------------------------------------------===//

std::optional<FloatingPointSettings>
FloatingPointResolver::resolve(ArrayRef<CommandLineOption> Options) const {
  return resolve(Options, {});
}

std::optional<FloatingPointSettings>
FloatingPointResolver::resolve(ArrayRef<CommandLineOption> Options,
                               ArrayRef<const char *> More) const {
  SmallVector<const char *, 32> Words;
  for (const CommandLineOption &Option : Options)
    if (isRelevant(Option))
      append_range(Words, Option.Words);
  append_range(Words, More);
  Expected<TranslatedCommandLine> Translated = translateOwnOptions(Words);
  if (!Translated) {
    consumeError(Translated.takeError());
    return std::nullopt;
  }

  SmallVector<const char *, 64> Arguments{ToolPath.c_str()};
  append_range(Arguments, defaultDriverArguments());
  append_range(Arguments, Translated->Words);
  append_range(Arguments,
               ArrayRef<const char *>{"-fsyntax-only", "-x", "c++", "-"});
  DiagnosticOptions DiagOptions;
  IgnoringDiagConsumer Silence;
  DiagnosticsEngine Diags(DiagnosticIDs::create(), DiagOptions, &Silence,
                          /*ShouldOwnClient=*/false);
  clang::driver::Driver TheDriver(ToolPath, llvm::TPTriple, Diags);
  std::unique_ptr<clang::driver::Compilation> Jobs(
      TheDriver.BuildCompilation(Arguments));
  if (!Jobs || Jobs->containsError() || Jobs->getJobs().empty())
    return std::nullopt;

  ArrayRef<const char *> JobArguments(Jobs->getJobs().begin()->getArguments());
  std::unique_ptr<CompilerInstance> Frontend =
      interpretArguments(JobArguments.drop_front(), ToolPath.c_str());
  if (!Frontend)
    return std::nullopt;
  return floatingPointSettings(*Frontend);
}

//===----------------------------------------------------------------------===//
// Who decides
//===----------------------------------------------------------------------===//

// Two command lines that differ in every property that one option can set.
static constexpr const char *OneExtreme[] = {"-ftp-fp=strict", "-mno-fma",
                                             "-fno-tp-check-fp"};
static constexpr const char *OtherExtreme[] = {
    "-ftp-fp=fast",
    "-fmath-errno",
    "-frounding-math",
    "-ffp-exception-behavior=maytrap",
    "-fstrict-float-cast-overflow",
    "-fdenormal-fp-math=preserve-sign",
    "-mfma",
    "-ftp-check-fp"};

namespace {
/// Tells the properties that an option sets, whatever stands before it.
class SetProperties {
public:
  explicit SetProperties(const FloatingPointResolver &Resolver)
      : Resolver(Resolver), OneWithout(under(OneExtreme, {})),
        OtherWithout(under(OtherExtreme, {})) {}

  /// For each property, whether \p Option sets it to its value in \p After.
  std::array<bool, NumFloatingPointProperties>
  operator()(const CommandLineOption &Option,
             const FloatingPointSettings &After) const;

private:
  std::optional<FloatingPointSettings>
  under(ArrayRef<const char *> Extreme, ArrayRef<const char *> Words) const {
    SmallVector<const char *, 16> All(Extreme);
    append_range(All, Words);
    return Resolver.resolve({}, All);
  }

  const FloatingPointResolver &Resolver;
  std::optional<FloatingPointSettings> OneWithout, OtherWithout;
};
} // namespace

std::array<bool, NumFloatingPointProperties>
SetProperties::operator()(const CommandLineOption &Option,
                          const FloatingPointSettings &After) const {
  std::array<bool, NumFloatingPointProperties> Sets{};
  auto One = under(OneExtreme, Option.Words);
  auto Other = under(OtherExtreme, Option.Words);
  if (!One || !Other || !OneWithout || !OtherWithout)
    return Sets;
  for (size_t I = 0; I < NumFloatingPointProperties; ++I) {
    auto Property = static_cast<FloatingPointProperty>(I);
    Sets[I] = (*OneWithout)[Property] != (*OtherWithout)[Property] &&
              (*One)[Property] == After[Property] &&
              (*Other)[Property] == After[Property];
  }
  return Sets;
}

std::optional<FloatingPointDecisions>
decideFloatingPoint(const FloatingPointResolver &Resolver,
                    ArrayRef<CommandLineOption> Options) {
  FloatingPointDecisions Result;
  std::optional<FloatingPointSettings> Final = Resolver.resolve(Options);
  std::optional<FloatingPointSettings> Before = Resolver.resolve({});
  if (!Final || !Before)
    return std::nullopt;
  Result.Settings = *Final;

  SetProperties SetsProperties(Resolver);
  for (size_t Index = 0; Index < Options.size(); ++Index) {
    if (!isRelevant(Options[Index]))
      continue;
    // What an option with a missing second half says, its second half says.
    std::optional<FloatingPointSettings> After =
        Resolver.resolve(Options.take_front(Index + 1));
    if (!After)
      continue;
    std::array<bool, NumFloatingPointProperties> Sets =
        SetsProperties(Options[Index], *After);
    for (size_t I = 0; I < NumFloatingPointProperties; ++I) {
      auto Property = static_cast<FloatingPointProperty>(I);
      if (Sets[I] || (*After)[Property] != (*Before)[Property])
        Result.Deciders[I] = Index;
    }
    Before = After;
  }
  return Result;
}

} // namespace tp
