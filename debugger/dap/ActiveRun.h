//===- ActiveRun.h - How a request stops what goes on -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_ACTIVERUN_H
#define TP_DEBUGGER_DAP_ACTIVERUN_H

#include "debugger/dap/Channel.h"
#include "debugger/session/Session.h"

#include <mutex>

namespace tp::dap {

/// The program while it runs, for the thread that reads requests.
class ActiveRun {
public:
  /// Who stops the run: any request, if it can go on afterwards, or only those
  /// that are to end it.
  enum class Interest { Any, Ending };

  void begin(Session &Program, Interest By);
  void end();

  /// Stops the run if \p Next wants that; null: the client has gone.
  void arrived(const Request *Next);

private:
  std::mutex Mutex;
  Session *Program = nullptr;
  Interest By = Interest::Ending;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_ACTIVERUN_H
