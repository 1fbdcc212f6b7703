//===- OwnOptions.cpp - The options that only tpcc has --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/OwnOptions.h"
#include "llvm-backend/clang/CommandLineOption.h"
#include "llvm-backend/clang/FloatingPointFlags.h"
#include "llvm-backend/clang/TargetChoice.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Format.h"

#include <map>

using namespace clang::options;
using namespace llvm;

namespace tp {

//===----------------------------------------------------------------------===//
// The table
//===----------------------------------------------------------------------===//

namespace {

/// Options of one group exclude each other.
enum class OptionGroup {
  FloatingPointPreset,
  CheckedFloatingPoint,
  CheckedObjects,
  FusedMultiplyAdd,
  Trigonometry,
  Outlining,
  PrintFloatingPoint
};

struct OwnOption {
  StringRef Name;
  OptionGroup Group;
  StringRef Help;
  /// What takes its place.
  ArrayRef<const char *> Replacement = {};
  /// What the options of the user override.
  ArrayRef<const char *> Defaults = {};
};

} // namespace

static constexpr StringRef PresetPrefix = "-ftp-fp=";

static constexpr const char *Strict[] = {"-fno-fast-math", "-fno-math-errno",
                                         "-ffp-contract=off"};
static constexpr const char *Reproducible[] = {
    "-fassociative-math", "-freciprocal-math", "-fapprox-func",
    "-fno-signed-zeros",  "-fno-math-errno",   "-ffp-contract=off"};
// The second part keeps clang from warning, of an option that the user has not
// written, when a later one changes contraction.
static constexpr const char *Fast[] = {"-ffast-math", "-ffp-contract=fast"};
static constexpr const char *Checked[] = {"-mllvm", "-tp-fp-check",
                                          "-D__TP_CHECK_FP__=1"};
static constexpr const char *LineTables[] = {"-gline-tables-only"};
static constexpr const char *WithObjects[] = {"-mllvm", "-tp-check-objects"};
static constexpr const char *WithFma[] = {"-Xclang", "-target-feature",
                                          "-Xclang", "+fma"};
static constexpr const char *WithoutFma[] = {"-Xclang", "-target-feature",
                                             "-Xclang", "-fma"};
static constexpr const char *WithTrig[] = {"-Xclang", "-target-feature",
                                           "-Xclang", "+trig"};
static constexpr const char *WithoutTrig[] = {"-Xclang", "-target-feature",
                                              "-Xclang", "-trig"};
static constexpr const char *WithOutlining[] = {"-mllvm",
                                                "-enable-machine-outliner"};

static constexpr OwnOption Options[] = {
    {"-ftp-fp=strict", OptionGroup::FloatingPointPreset,
     "IEEE arithmetic as the source says it (default)", Strict},
    {"-ftp-fp=reproducible", OptionGroup::FloatingPointPreset,
     "Faster rewrites that give the same bits here and on the host; NaN and "
     "infinity keep their meaning",
     Reproducible},
    {"-ftp-fp=fast", OptionGroup::FloatingPointPreset,
     "All of -ffast-math: also assumes that there are no NaN and infinities",
     Fast},
    {"-ftp-check-fp", OptionGroup::CheckedFloatingPoint,
     "Trap where the program uses an invalid floating-point value", Checked,
     LineTables},
    {"-fno-tp-check-fp", OptionGroup::CheckedFloatingPoint,
     "Do not check floating-point values (default)"},
    {"-ftp-check-objects", OptionGroup::CheckedObjects,
     "Let tpsim --check know where objects of the stack begin and end",
     WithObjects},
    {"-fno-tp-check-objects", OptionGroup::CheckedObjects, "Do not (default)"},
    {"-mfma", OptionGroup::FusedMultiplyAdd, "The chip has madd_s", WithFma},
    {"-mno-fma", OptionGroup::FusedMultiplyAdd,
     "The chip lacks madd_s (default)", WithoutFma},
    {"-mtrig", OptionGroup::Trigonometry,
     "The chip has sin_s and cos_s (default)", WithTrig},
    {"-mno-trig", OptionGroup::Trigonometry, "The chip lacks sin_s and cos_s",
     WithoutTrig},
    {"-moutline", OptionGroup::Outlining,
     "Move instructions that occur several times to functions of their own: "
     "shorter and slower",
     WithOutlining},
    {"-mno-outline", OptionGroup::Outlining,
     "Do not outline instructions (default)"},
    {"--print-fp", OptionGroup::PrintFloatingPoint,
     "Print how the other options treat floating point and which of them "
     "decides; compile nothing"},
};

static const OwnOption *findOwnOption(StringRef Word) {
  const auto *Found = find_if(
      Options, [&](const OwnOption &Option) { return Option.Name == Word; });
  return Found == std::end(Options) ? nullptr : Found;
}

bool isOwnFloatingPointOption(StringRef Word) {
  const OwnOption *Option = findOwnOption(Word);
  return Option && Option->Group != OptionGroup::Trigonometry &&
         Option->Group != OptionGroup::Outlining &&
         Option->Group != OptionGroup::CheckedObjects &&
         Option->Group != OptionGroup::PrintFloatingPoint;
}

//===----------------------------------------------------------------------===//
// Help
//===----------------------------------------------------------------------===//

static void printHelp(raw_ostream &Stream, StringRef Name, StringRef Help) {
  constexpr unsigned Column = 27, Width = 80;
  Stream << "  " << left_justify(Name, Column - 2);
  size_t Used = Name.size() + 2 < Column ? Column : Width;
  while (!Help.empty()) {
    auto [Word, Rest] = Help.split(' ');
    if (Used + 1 + Word.size() > Width) {
      Stream << '\n' << left_justify("", Column);
      Used = Column;
    }
    Stream << ' ' << Word;
    Used += 1 + Word.size();
    Help = Rest;
  }
  Stream << '\n';
}

void printOwnOptions(raw_ostream &Stream) {
  for (const OwnOption &Option : Options)
    printHelp(Stream, Option.Name, Option.Help);
  printHelp(Stream, "-Wno-tp-fp, -Wno-tp-fp-<name>",
            "Do not warn about the hazards of floating-point options; also "
            "-Werror=, -Wno-error=");
  printHelp(Stream, "-Wtp-double",
            "Warn of arithmetic in double, which the TP does in software");
}

//===----------------------------------------------------------------------===//
// Translation
//===----------------------------------------------------------------------===//

namespace {

/// Builds a translated command line option by option.
class Translation {
public:
  explicit Translation(ArrayRef<CommandLineOption> Given);
  Error translate(const CommandLineOption &Option, size_t Index);

  TranslatedCommandLine Result;

private:
  void copy(const CommandLineOption &Option);
  void appendUnwarned(ArrayRef<const char *> Words);

  std::map<OptionGroup, size_t> LastOfGroup;
  std::optional<size_t> Preset;
  const char *LastContraction = "-ffp-contract=off";
  bool IsUnwarned = false;
};

} // namespace

Translation::Translation(ArrayRef<CommandLineOption> Given) {
  for (auto [Index, Option] : enumerate(Given))
    if (const OwnOption *Own = findOwnOption(Option.name()))
      LastOfGroup[Own->Group] = Index;
  auto Last = LastOfGroup.find(OptionGroup::FloatingPointPreset);
  if (Last != LastOfGroup.end())
    Preset = Last->second;
}

// Appends what clang must not call unused when there is nothing to compile.
void Translation::appendUnwarned(ArrayRef<const char *> Words) {
  if (!IsUnwarned)
    Result.Words.push_back("--start-no-unused-arguments");
  append_range(Result.Words, Words);
  if (!IsUnwarned)
    Result.Words.push_back("--end-no-unused-arguments");
}

void Translation::copy(const CommandLineOption &Option) {
  switch (Option.ID) {
  case OPT_start_no_unused_arguments:
    IsUnwarned = true;
    break;
  case OPT_end_no_unused_arguments:
    IsUnwarned = false;
    break;
  case OPT_ffp_contract:
    LastContraction = Option.Words.front();
    break;
  case OPT_mllvm: // Also an option of the link.
    return appendUnwarned(Option.Words);
  case OPT_W_Joined:
  case OPT_w:
    Result.Warnings.readGeneralWord(Option.name());
    break;
  default:
    break;
  }
  append_range(Result.Words, Option.Words);
  // Clang goes back to its own defaults, tpcc to the user's and tpcc's.
  if (Option.ID == OPT_fno_fast_math || Option.ID == OPT_ffp_model_EQ)
    appendUnwarned({"-fno-math-errno"});
  if (Option.ID == OPT_fno_fast_math ||
      Option.ID == OPT_fno_unsafe_math_optimizations)
    appendUnwarned({LastContraction});
}

Error Translation::translate(const CommandLineOption &Option, size_t Index) {
  StringRef Name = Option.name();
  if (const OwnOption *Own = findOwnOption(Name)) {
    if (LastOfGroup.at(Own->Group) != Index)
      return Error::success();
    Result.PrintsFloatingPoint |= Own->Group == OptionGroup::PrintFloatingPoint;
    append_range(Result.Defaults, Own->Defaults);
    if (!Own->Replacement.empty())
      appendUnwarned(Own->Replacement);
    return Error::success();
  }
  if (Name.starts_with(PresetPrefix))
    return createStringError(
        "invalid value '" + Name.drop_front(PresetPrefix.size()) + "' in '" +
        Name + "'; use 'strict', 'reproducible' or 'fast'");
  if (WarningOptions::isOwnWord(Name)) {
    Result.WarningWords.push_back(Option.Words.front());
    return Result.Warnings.readOwnWord(Name);
  }
  if (isTargetChoice(Option))
    return checkTargetChoice(Option);
  if (Preset && Index < *Preset && isFloatingPointFlag(Option.ID)) {
    // It is an optimization level as well.
    if (Option.ID == OPT_Ofast)
      Result.Words.push_back("-O3");
    return Error::success();
  }
  copy(Option);
  return Error::success();
}

Expected<TranslatedCommandLine>
translateOwnOptions(ArrayRef<const char *> Words) {
  std::vector<CommandLineOption> Given = splitCommandLine(Words);
  Translation Translator(Given);
  for (auto [Index, Option] : enumerate(Given))
    if (Error Failure = Translator.translate(Option, Index))
      return Failure;
  return std::move(Translator.Result);
}

} // namespace tp
