//===- ClientSources.cpp - Source files as a client names them ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ClientSources.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp::dap {

Expected<SourceFileId> ClientSources::find(const SourceArgument &Source) const {
  if (!Source.Path)
    return createStringError("the source has no path");
  for (SourceFileId File = 0; File < Files.size(); ++File) {
    std::string Path = Files.path(File);
    if (Path == *Source.Path || sys::fs::equivalent(Path, *Source.Path))
      return File;
  }
  std::vector<SourceFileId> SameName =
      Files.find(sys::path::filename(*Source.Path));
  if (SameName.size() == 1)
    return SameName.front();
  return createStringError("no code of the program comes from '" +
                           *Source.Path +
                           "'; was it compiled with -g from here?");
}

json::Object ClientSources::describe(SourceFileId File) {
  std::string Path = Files.path(File);
  json::Object Result{{"name", json::fixUTF8(sys::path::filename(Path))}};
  if (!sys::fs::exists(Path)) {
    Result["origin"] = "not found: " + json::fixUTF8(Path);
    Result["presentationHint"] = "deemphasize";
    return Result;
  }
  Result["path"] = json::fixUTF8(Path);
  if (Files.hasChanged(File))
    Result["origin"] = "changed after it was compiled";
  return Result;
}

} // namespace tp::dap
