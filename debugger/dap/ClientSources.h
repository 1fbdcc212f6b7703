//===- ClientSources.h - Source files as a client names them ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_CLIENTSOURCES_H
#define TP_DEBUGGER_DAP_CLIENTSOURCES_H

#include "debugger/dap/Arguments.h"
#include "debugger/source/SourceFiles.h"

#include "llvm/Support/JSON.h"

#include <optional>

namespace tp::dap {

/// Translates between files of the program and the client's paths.
class ClientSources {
public:
  explicit ClientSources(SourceFiles &Files) : Files(Files) {}

  /// The file of the program that the client means: that of its path, or the
  /// only one of that name. The error says that there is none.
  llvm::Expected<SourceFileId> find(const SourceArgument &Source) const;

  /// The protocol's Source for a file. One that the client cannot open has
  /// only a name.
  llvm::json::Object describe(SourceFileId File);

private:
  SourceFiles &Files;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_CLIENTSOURCES_H
