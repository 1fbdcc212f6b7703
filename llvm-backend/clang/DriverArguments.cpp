//===- DriverArguments.cpp - tpcc's defaults among clang's options --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/DriverArguments.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/HostPaths.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/STLExtras.h"

using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

static constexpr const char *Defaults[] = {
    "--no-default-config",
    "--target=tp-unknown-elf",
    "-resource-dir",
    ClangResourceFolder,
    // tpcc adds its own folders.
    "-nostdinc",
    "-fintegrated-as",
    // The runtime unwinds no stack and keeps no type information.
    "-fno-exceptions",
    "-fno-rtti",
    "-fno-unwind-tables",
    "-fno-asynchronous-unwind-tables",
    "-fno-stack-protector",
    // One program at fixed addresses.
    "-fno-pic",
    "-ftls-model=local-exec",
    "-fno-addrsig",
    "-fomit-frame-pointer",
    // A kernel rounds as it does on the host, with or without fused
    // multiply-add.
    "-ffp-contract=off",
    "-fno-math-errno",
    // Conversions saturate, as the instruction does.
    "-fno-strict-float-cast-overflow",
    // The runtime has no functions for failed checks.
    "-fsanitize-trap=all",
    // A trap of its own for each check can name it.
    "-fno-sanitize-merge",
    ("-Wframe-larger-than=" TP_DEFAULT_LOCAL_STORE_BYTES),
};

ArrayRef<const char *> defaultDriverArguments() { return Defaults; }

void compileForWholeProgram(ArgStringList &JobArguments) {
  // Under -save-temps clang leaves the passes to a job of their own.
  const auto *Deferred = find(JobArguments, StringRef("-disable-llvm-passes"));
  if (Deferred != JobArguments.end())
    JobArguments.erase(Deferred);
  for (const char *&Argument : JobArguments)
    if (StringRef(Argument) == "-emit-obj")
      Argument = "-emit-llvm-bc";
  JobArguments.push_back("-flto=full");
}

// Whether `-x` names C++, a C++ header or preprocessed C++.
static bool compilesCxx(const ArgStringList &JobArguments) {
  const auto *Language = find(JobArguments, StringRef("-x"));
  if (Language == JobArguments.end() ||
      std::next(Language) == JobArguments.end())
    return false;
  return StringRef(*std::next(Language)).starts_with("c++");
}

static void appendHeaderFolders(const ArgList &UserArguments,
                                const Sysroot &Folders,
                                const ArgList &StringOwner, bool IsCxx,
                                ArgStringList &JobArguments) {
  auto Append = [&](const std::string &Folder, const char *Option) {
    JobArguments.push_back(Option);
    JobArguments.push_back(StringOwner.MakeArgString(Folder));
  };
  if (UserArguments.hasArg(OPT_nostdinc))
    return;
  bool WithLibraries = !UserArguments.hasArg(OPT_nostdlibinc);
  if (WithLibraries && IsCxx && !UserArguments.hasArg(OPT_nostdincxx))
    for (const std::string &Folder : Folders.cxxHeaders())
      Append(Folder, "-internal-isystem");
  if (WithLibraries)
    Append(Folders.runtimeHeaders(), "-internal-isystem");
  if (!UserArguments.hasArg(OPT_nobuiltininc))
    Append(Sysroot::resourceFolder() + "/include", "-internal-isystem");
}

void completeJobArguments(const ArgList &UserArguments,
                          ArrayRef<const char *> WarningWords,
                          const Sysroot &Folders, const ArgList &StringOwner,
                          ArgStringList &JobArguments) {
  for (size_t I = 0; I + 1 < JobArguments.size(); ++I)
    if (StringRef(JobArguments[I]) == "-triple")
      JobArguments[I + 1] = TPTriple;
  if (StringRef(JobArguments.front()) != "-cc1")
    return;

  bool IsCxx = compilesCxx(JobArguments);
  if (IsCxx && none_of(JobArguments, [](StringRef Argument) {
        return Argument.starts_with("-std=");
      }))
    JobArguments.push_back("-std=gnu++20");
  for (const char *Word : WarningWords) {
    JobArguments.push_back(WarningPlugInOption);
    JobArguments.push_back(Word);
  }
  appendHeaderFolders(UserArguments, Folders, StringOwner, IsCxx, JobArguments);
}

} // namespace tp
