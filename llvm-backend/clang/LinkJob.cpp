//===- LinkJob.cpp - The driver's last job --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/LinkJob.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "llvm-backend/clang/LinkReports.h"
#include "runtime/include/tp/memory_map.h"
#include "clang/Driver/InputInfo.h"
#include "clang/Options/Options.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Pass.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace clang::driver;
using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

static OptimizationLevel optimizationLevel(const ArgList &Arguments) {
  const Arg *Level = Arguments.getLastArg(OPT_O_Group);
  if (!Level || Level->getOption().matches(OPT_O0))
    return OptimizationLevel::O0;
  if (Level->getOption().matches(OPT_O4) ||
      Level->getOption().matches(OPT_Ofast))
    return OptimizationLevel::O3;
  StringRef Value = Level->getValue();
  if (Value == "s")
    return OptimizationLevel::Os;
  if (Value == "z")
    return OptimizationLevel::Oz;
  if (Value == "0")
    return OptimizationLevel::O0;
  if (Value == "1" || Value == "g" || Value.empty())
    return OptimizationLevel::O1;
  return Value == "2" ? OptimizationLevel::O2 : OptimizationLevel::O3;
}

namespace {
/// A word of the command line that the link sees: a file or an option.
struct LinkWord {
  const InputInfo *File = nullptr;
  const Arg *Option = nullptr;
};
} // namespace

// The files and options of the link in the order of the command line. The
// command has lost the options, its action has not.
static std::vector<LinkWord> linkWords(const Command &Job) {
  std::vector<LinkWord> Words;
  const InputInfo *NextFile = Job.getInputInfos().data();
  for (const Action *Input : cast<LinkJobAction>(Job.getSource()).inputs()) {
    const auto *Given = dyn_cast<InputAction>(Input);
    if (Given && !Given->getInputArg().getOption().matches(OPT_INPUT))
      Words.push_back({nullptr, &Given->getInputArg()});
    else
      Words.push_back({NextFile++, nullptr});
  }
  return Words;
}

namespace {
/// Reads the inputs and options of the link from clang's plan.
class LinkPlan {
public:
  LinkPlan(const Compilation &Jobs, const JobPlan &Plan, const Sysroot &Folders,
           const Command &Job, LinkDiagnostics &Diags);

  LinkOptions Options;
  std::vector<LinkInput> Inputs;

private:
  void refuse(ArrayRef<OptSpecifier> Kinds, const char *Reason);
  void readOption(const Arg &Argument);
  void readLinkerWords(ArrayRef<const char *> Words);
  void readKeyword(StringRef Keyword);
  void addLibrary(StringRef Name);

  const ArgList &Arguments;
  LinkDiagnostics &Diags;
  bool WholeArchive = false;
};
} // namespace

LinkPlan::LinkPlan(const Compilation &Jobs, const JobPlan &Plan,
                   const Sysroot &Folders, const Command &Job,
                   LinkDiagnostics &Diags)
    : Arguments(Jobs.getArgs()), Diags(Diags) {
  Options.Level = optimizationLevel(Arguments);
  if (!Job.getOutputFilenames().empty())
    Options.OutputPath = Job.getOutputFilenames().front();
  const Arg *Debug = Arguments.getLastArg(OPT_g_Group);
  Options.FullRuntimeDebugInfo =
      Debug && !Debug->getOption().matches(OPT_g0) &&
      !Debug->getOption().matches(OPT_gline_tables_only);
  if (!Arguments.hasArg(OPT_nostdlib, OPT_nodefaultlibs))
    Options.RuntimePath = Folders.runtimeBitcode();
  refuse({OPT_r, OPT_shared, OPT_rdynamic, OPT_pie, OPT_static_pie},
         "the TP runs whole programs at fixed addresses");
  refuse({OPT_T}, "the TP's memory map is fixed (docs/tpcc.md)");
  refuse({OPT_s}, "the simulator needs the symbols; llvm-strip --strip-debug "
                  "makes a program smaller");
  for (const LinkWord &Word : linkWords(Job)) {
    if (Word.Option)
      readOption(*Word.Option);
    else
      Inputs.push_back({Word.File->getBaseInput(), nullptr,
                        Plan.linkInput(Word.File->getFilename()).str(),
                        WholeArchive});
  }
  Options.Reports = readProgramReports(Arguments, Options.OutputPath);
  if (const Arg *Entry = Arguments.getLastArg(OPT_e))
    Options.EntrySymbol = Entry->getValue();
  for (const std::string &Name : Arguments.getAllArgValues(OPT_u))
    Options.KeptSymbols.push_back(Name);
}

void LinkPlan::refuse(ArrayRef<OptSpecifier> Kinds, const char *Reason) {
  for (const Arg *Given : Arguments)
    if (is_contained(Kinds, Given->getOption().getID()))
      Diags.error("'" + Given->getAsString(Arguments) +
                  "' is not possible: " + Reason);
}

void LinkPlan::readOption(const Arg &Argument) {
  const Option &Kind = Argument.getOption();
  if (Kind.matches(OPT_l))
    addLibrary(Argument.getValue());
  else if (Kind.matches(OPT_z))
    readKeyword(Argument.getValue());
  else if (Kind.matches(OPT_Wl_COMMA) || Kind.matches(OPT_Xlinker))
    readLinkerWords(Argument.getValues());
}

void LinkPlan::readLinkerWords(ArrayRef<const char *> Words) {
  for (size_t I = 0; I < Words.size(); ++I) {
    StringRef Word = Words[I];
    // `--name=value`, or the value is the next word.
    auto Matches = [&](ArrayRef<StringRef> Names, std::string &Value) {
      for (StringRef Name : Names) {
        if (Word == Name && I + 1 < Words.size()) {
          Value = Words[++I];
          return true;
        }
        StringRef Rest = Word;
        if (Rest.consume_front(Name) && Rest.consume_front("=")) {
          Value = Rest.str();
          return true;
        }
      }
      return false;
    };
    std::string Value;
    if (Word == "--gc-sections")
      Options.CollectGarbage = true;
    else if (Word == "--no-gc-sections")
      Options.CollectGarbage = false;
    else if (Word == "--whole-archive")
      WholeArchive = true;
    else if (Word == "--no-whole-archive")
      WholeArchive = false;
    else if (Matches({"--entry", "-e"}, Value))
      Options.EntrySymbol = Value;
    else if (Matches({"--undefined", "-u"}, Value))
      Options.KeptSymbols.push_back(Value);
    else if (Matches({"-Map", "--Map"}, Value))
      Options.MapPath = Value;
    else if (Word == "-z" && I + 1 < Words.size())
      readKeyword(Words[++I]);
    else if (Word != "--start-group" && Word != "--end-group")
      Diags.error("unknown linker option '" + Word +
                  "'; tpcc --help lists them");
  }
}

void LinkPlan::readKeyword(StringRef Keyword) {
  StringRef Value = Keyword;
  if (!Value.consume_front("stack-size=")) {
    Diags.error("unknown linker option '-z " + Keyword +
                "'; there is -z stack-size=<bytes>");
    return;
  }
  uint32_t Bytes;
  if (Value.getAsInteger(0, Bytes) || Bytes > kLocalStoreBytesMax) {
    Diags.error("'-z " + Keyword + "' is not a number of bytes from 0 to " +
                Twine(kLocalStoreBytesMax));
    return;
  }
  Options.StackBytes = Bytes;
}

void LinkPlan::addLibrary(StringRef Name) {
  SmallString<128> Searched;
  for (const std::string &Folder : Arguments.getAllArgValues(OPT_L)) {
    SmallString<128> Path(Folder);
    sys::path::append(Path, "lib" + Name + ".a");
    if (sys::fs::exists(Path)) {
      Inputs.push_back(
          {Path.str().str(), nullptr, Path.str().str(), WholeArchive});
      return;
    }
    Searched += (Searched.empty() ? "" : ", ") + Folder;
  }
  // The runtime has the whole C library.
  if (Name == "c" || Name == "m")
    return;
  Diags.error("cannot find library '-l" + Name + "': no lib" + Name + ".a in " +
              (Searched.empty()
                   ? StringRef("the folders of -L (there are none)")
                   : StringRef(Searched)));
}

bool LinkJob::run(const Command &Job) {
  LinkDiagnostics Diags;
  LinkPlan Planned(Jobs, Plan, Folders, Job, Diags);
  Planned.Options.Warnings = Warnings;
  if (Diags.hasErrors())
    return false;
  for (LinkInput &Input : Planned.Inputs)
    if (auto Unit = Units.find(Input.Path); Unit != Units.end())
      Input.Unit = std::move(Unit->second);
  const ArgList &Arguments = Jobs.getArgs();
  setBackendOptions(Arguments.getAllArgValues(OPT_mllvm));
  TimePassesIsEnabled = Arguments.hasArg(OPT_ftime_report, OPT_ftime_report_EQ);
  TimeTrace Trace(readTimeTrace(Arguments, Planned.Options.OutputPath));
  const bool Succeeded =
      linkProgram(Context, std::move(Planned.Inputs), Planned.Options, Diags);
  if (TimePassesIsEnabled)
    printTimeReport();
  return Succeeded;
}

// The options besides files, libraries and words for the linker that run()
// reads.
static constexpr unsigned DescribedOptions[] = {
    OPT_O_Group,
    OPT_g_Group,
    OPT_mllvm,
    OPT_L,
    OPT_e,
    OPT_u,
    OPT_nostdlib,
    OPT_nodefaultlibs,
    OPT_Rpass_EQ,
    OPT_Rpass_missed_EQ,
    OPT_Rpass_analysis_EQ,
    OPT_R_Joined,
    OPT_fsave_optimization_record,
    OPT_fsave_optimization_record_EQ,
    OPT_foptimization_record_file_EQ,
    OPT_foptimization_record_passes_EQ,
    OPT_fstack_usage,
    OPT_ftime_report,
    OPT_ftime_trace,
    OPT_ftime_trace_EQ,
    OPT_ftime_trace_granularity_EQ,
};

void LinkJob::describe(const Compilation &Jobs, const JobPlan &Plan,
                       const std::string &ToolPath,
                       ArrayRef<const char *> WarningWords, Command &Job) {
  ArgStringList Words;
  const ArgList &Arguments = Jobs.getArgs();
  Words.push_back("-o");
  for (const std::string &Output : Job.getOutputFilenames())
    Words.push_back(Arguments.MakeArgString(Output));
  for (const Arg *Given : Arguments)
    if (any_of(DescribedOptions,
               [&](unsigned ID) { return Given->getOption().matches(ID); }))
      Given->render(Arguments, Words);
  append_range(Words, WarningWords);
  for (const LinkWord &Word : linkWords(Job)) {
    if (Word.Option)
      Word.Option->render(Arguments, Words);
    else
      Words.push_back(
          Arguments.MakeArgString(Plan.linkInput(Word.File->getFilename())));
  }
  Job.replaceExecutable(Arguments.MakeArgString(ToolPath));
  Job.replaceArguments(std::move(Words));
}

} // namespace tp
