//===- RefusedOptions.cpp - What clang can and the TP cannot --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/RefusedOptions.h"
#include "clang/Basic/Sanitizers.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/STLExtras.h"

using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

namespace {

/// Options that are refused for one reason, unless their opposite comes later.
struct Refusal {
  ArrayRef<unsigned> Options;
  const char *Reason;
  ArrayRef<unsigned> Opposites = {};
};

} // namespace

static constexpr unsigned Exceptions[] = {OPT_fexceptions, OPT_fcxx_exceptions};
static constexpr unsigned NoExceptions[] = {OPT_fno_exceptions,
                                            OPT_fno_cxx_exceptions};
static constexpr unsigned TypeInformation[] = {OPT_frtti};
static constexpr unsigned NoTypeInformation[] = {OPT_fno_rtti};
static constexpr unsigned Threads[] = {OPT_pthread, OPT_fopenmp,
                                       OPT_fopenmp_EQ};
static constexpr unsigned NoThreads[] = {OPT_no_pthread, OPT_fno_openmp};
static constexpr unsigned Profiles[] = {OPT_fprofile_generate,
                                        OPT_fprofile_generate_EQ,
                                        OPT_fcs_profile_generate,
                                        OPT_fcs_profile_generate_EQ,
                                        OPT_fprofile_arcs,
                                        OPT_fprofile_instr_generate,
                                        OPT_ftest_coverage,
                                        OPT_fprofile_instr_generate_EQ,
                                        OPT_fcoverage_mapping,
                                        OPT_coverage,
                                        OPT_pg,
                                        OPT_fsanitize_coverage};
static constexpr unsigned NoProfiles[] = {
    OPT_fno_profile_generate, OPT_fno_profile_instr_generate,
    OPT_fno_profile_arcs, OPT_fno_test_coverage, OPT_fno_coverage_mapping};
static constexpr unsigned StackProtectors[] = {
    OPT_fstack_protector, OPT_fstack_protector_all, OPT_fstack_protector_strong,
    OPT_fsplit_stack};
static constexpr unsigned NoStackProtectors[] = {OPT_fno_stack_protector,
                                                 OPT_fno_split_stack};
static constexpr unsigned OtherAssemblers[] = {OPT_fno_integrated_as};
static constexpr unsigned OwnAssembler[] = {OPT_fintegrated_as};
static constexpr unsigned ImplicitModules[] = {OPT_fmodules};
static constexpr unsigned NoImplicitModules[] = {OPT_fno_modules};
static constexpr unsigned EmbeddedBitcode[] = {OPT_fembed_bitcode,
                                               OPT_fembed_bitcode_EQ};
static constexpr unsigned SanitizerRuntimes[] = {OPT_fsanitize_minimal_runtime,
                                                 OPT_fno_sanitize_trap_EQ};
static constexpr unsigned NoSanitizerRuntimes[] = {
    OPT_fno_sanitize_minimal_runtime, OPT_fsanitize_trap_EQ};

static constexpr Refusal Refusals[] = {
    {Exceptions,
     "the runtime does not unwind the stack; return errors, as in "
     "std::optional, and leave the option out",
     NoExceptions},
    {TypeInformation,
     "the runtime has no type information; tell classes apart by a virtual "
     "function or a member, and leave the option out",
     NoTypeInformation},
    {Threads,
     "each thread processor runs main and there are no other threads; "
     "tp/thread.h tells them apart; leave the option out",
     NoThreads},
    {Profiles,
     "a program on the chip has no file for its counts; tpsim counts: "
     "tpsim --per-pc --stats <file>",
     NoProfiles},
    {StackProtectors,
     "a stack that leaves its part of the local store traps by itself; leave "
     "the option out",
     NoStackProtectors},
    {OtherAssemblers, "only tpcc's own assembler knows the TP", OwnAssembler},
    {ImplicitModules,
     "clang would compile the modules for a target that it does not know; use "
     "C++20 modules (--precompile) or a precompiled header (-include-pch)",
     NoImplicitModules},
    {EmbeddedBitcode, "objects have no section for it; -c -flto makes bitcode "
                      "that links like an object"},
    {SanitizerRuntimes,
     "the runtime has no functions for sanitizers; a failed check of "
     "-fsanitize=undefined traps and tpsim says which one it was",
     NoSanitizerRuntimes},
};

static void addLine(std::string &Lines, const Arg &Given,
                    const ArgList &Arguments, const Twine &Reason) {
  if (!Lines.empty())
    Lines += "\ntpcc: error: ";
  Lines += ("'" + Given.getAsString(Arguments) + "' is not possible: " + Reason)
               .str();
}

static bool matchesAny(const Arg &Given, ArrayRef<unsigned> Options) {
  return any_of(Options,
                [&](unsigned ID) { return Given.getOption().matches(ID); });
}

// The last option of Rule that no opposite follows, or null.
static const Arg *findRefused(const ArgList &Arguments, const Refusal &Rule) {
  const Arg *Found = nullptr;
  for (const Arg *Given : Arguments) {
    if (matchesAny(*Given, Rule.Options))
      Found = Given;
    else if (matchesAny(*Given, Rule.Opposites))
      Found = nullptr;
  }
  return Found;
}

// All parts are checks that end in a trap.
static constexpr const char *PossibleSanitizers[] = {
    "undefined",    "integer", "nullability",         "implicit-conversion",
    "local-bounds", "bounds",  "float-divide-by-zero"};

static bool isPossibleSanitizer(StringRef Name) {
  auto Parse = [](StringRef Group) {
    return clang::expandSanitizerGroups(
        clang::parseSanitizerValue(Group, /*AllowGroups=*/true));
  };
  clang::SanitizerMask Possible;
  for (StringRef Group : PossibleSanitizers)
    Possible |= Parse(Group);
  // Clang reports names that it does not know, and leaves vptr out of groups
  // that trap.
  return !(Parse(Name) & ~Possible) && Name != "vptr";
}

static void checkSanitizers(const ArgList &Arguments, std::string &Lines) {
  for (const Arg *Given : Arguments.filtered(OPT_fsanitize_EQ))
    for (StringRef Name : Given->getValues())
      if (!isPossibleSanitizer(Name))
        addLine(Lines, *Given, Arguments,
                "the runtime has nothing for '" + Name +
                    "'; -fsanitize=undefined, integer, nullability and their "
                    "parts without vptr work; wild accesses trap on their own");
}

static void checkLanguages(const ArgList &Arguments, std::string &Lines) {
  static constexpr StringRef Others[] = {
      "cl",   "clcpp",           "cuda",          "cuda-cpp-output", "hip",
      "hlsl", "objective-c",     "objective-c++", "renderscript",    "f77",
      "f95",  "objc-cpp-output", "hip-cpp-output"};
  for (const Arg *Given : Arguments.filtered(OPT_x))
    if (is_contained(Others, StringRef(Given->getValue())))
      addLine(Lines, *Given, Arguments,
              "tpcc compiles C, C++, LLVM IR and assembly");
}

Error checkRefusedOptions(const ArgList &Arguments) {
  std::string Lines;
  for (const Refusal &Rule : Refusals)
    if (const Arg *Given = findRefused(Arguments, Rule))
      addLine(Lines, *Given, Arguments, Rule.Reason);
  checkSanitizers(Arguments, Lines);
  checkLanguages(Arguments, Lines);
  if (Lines.empty())
    return Error::success();
  return createStringError(Lines);
}

} // namespace tp
