//===- Sysroot.cpp - Where tpcc finds headers and the runtime -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/Sysroot.h"
#include "llvm-backend/clang/HostPaths.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp {

static std::string join(StringRef Folder, StringRef Entry) {
  SmallString<128> Path(Folder);
  sys::path::append(Path, Entry);
  return std::string(Path);
}

Sysroot::Sysroot(StringRef ToolPath) {
  StringRef ToolFolder = sys::path::parent_path(ToolPath);
  Root = join(sys::path::parent_path(ToolFolder), "lib/tp");
}

std::string Sysroot::runtimeBitcode() const { return join(Root, "runtime.bc"); }

std::string Sysroot::runtimeHeaders() const { return join(Root, "include"); }

std::vector<std::string> Sysroot::cxxHeaders() const {
  return {join(Root, "libstdcxx"), LibstdcxxHeaders, LibstdcxxTargetHeaders,
          LibstdcxxBackwardHeaders};
}

std::string Sysroot::resourceFolder() { return ClangResourceFolder; }

} // namespace tp
