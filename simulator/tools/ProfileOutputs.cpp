//===- ProfileOutputs.cpp - What is written of a profile ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ProfileOutputs.h"

#include "simulator/profile/ProfileJson.h"
#include "simulator/profile/StackFiles.h"
#include "simulator/profile/html/HtmlReport.h"
#include "simulator/tools/OutputFile.h"

using namespace llvm;

namespace tp {

llvm::Error writeProfileFiles(const Profile &Data,
                              const ProfileRequest &Request) {
  llvm::Error Failures = llvm::Error::success();
  auto Write = [&](const std::string &Path,
                   void (*Writer)(const Profile &, raw_ostream &)) {
    if (!Path.empty())
      Failures =
          joinErrors(std::move(Failures),
                     writeTo(Path, [&](raw_ostream &OS) { Writer(Data, OS); }));
  };
  Write(Request.Output, writeProfile);
  Write(Request.FoldedOutput, writeFoldedStacks);
  Write(Request.SpeedscopeOutput, writeSpeedscope);
  Write(Request.HtmlOutput, writeHtmlReport);
  return Failures;
}

llvm::Error showProfile(const ProfileRequest &Request) {
  Expected<Profile> Data = readProfile(Request.Input);
  if (!Data)
    return Data.takeError();
  if (llvm::Error E = writeProfileFiles(*Data, Request))
    return E;
  writeProfileTable(*Data, Request.Table, outs());
  return flushOutput();
}

} // namespace tp
