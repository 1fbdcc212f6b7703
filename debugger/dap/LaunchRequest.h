//===- LaunchRequest.h - What a launch configuration asks for ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_LAUNCHREQUEST_H
#define TP_DEBUGGER_DAP_LAUNCHREQUEST_H

#include "llvm/Support/Error.h"
#include "llvm/Support/JSON.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp::dap {

/// A launch configuration. Besides the attributes here it has the options of
/// the command line: `"hostThreads": 2` or `"host-threads": 2` is
/// `--host-threads 2`, `true` a flag, a list gives the option several times,
/// and so does an object, with `<key>=<value>`.
struct LaunchRequest {
  /// As on tpdbg's command line: options, the program, its arguments.
  std::vector<std::string> CommandLine;
  /// Where relative paths begin; empty: where tpdbg was started.
  std::string Folder;
  bool StopOnEntry = false;
  /// Stand at the end of the run, so that time can run back.
  bool StopAtEnd = false;
  /// List a thread for each place; nothing: if there are many.
  std::optional<bool> GroupThreads;
  /// Run without breakpoints.
  bool NoDebug = false;
  /// Prefixes of source paths, each with what stands there instead.
  std::vector<std::pair<std::string, std::string>> SourceMap;
};

/// Reads the arguments of a launch request. The error names the attribute.
llvm::Expected<LaunchRequest> readLaunch(const llvm::json::Value &Arguments);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_LAUNCHREQUEST_H
