//===- OutputFile.cpp - Files that a command writes -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/OutputFile.h"

using namespace llvm;

namespace tp {

Error writeTo(const std::string &Path,
              function_ref<void(raw_ostream &)> Write) {
  if (Path == "-") {
    Write(outs());
    return Error::success();
  }
  std::error_code EC;
  raw_fd_ostream File(Path, EC);
  if (!EC) {
    Write(File);
    File.close();
    EC = File.error();
    File.clear_error();
  }
  if (EC)
    return createStringError("cannot write " + Path + ": " + EC.message());
  return Error::success();
}

Error flushOutput() {
  outs().flush();
  if (!outs().has_error())
    return Error::success();
  std::error_code EC = outs().error();
  outs().clear_error();
  return createStringError("cannot write standard output: " + EC.message());
}

} // namespace tp
