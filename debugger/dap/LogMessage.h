//===- LogMessage.h - What a log point prints -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_LOGMESSAGE_H
#define TP_DEBUGGER_DAP_LOGMESSAGE_H

#include "debugger/source/DebugInformation.h"
#include "debugger/source/Expression.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <optional>
#include <string>
#include <vector>

namespace tp::dap {

/// Text with expressions in braces, `ray {Index} hit {Hit.Distance}`; `\{` is a
/// brace.
class LogMessage {
public:
  /// The error names the expression that is wrong. \p Information must outlive
  /// the message.
  static llvm::Expected<LogMessage> parse(llvm::StringRef Text,
                                          DebugInformation &Information);

  /// The text with the values that the expressions have in \p Frame.
  std::string render(const FrameContext &Frame) const;

private:
  struct Part {
    std::string Text;
    std::optional<Expression> Value;
  };
  DebugInformation *Information = nullptr;
  std::vector<Part> Parts;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_LOGMESSAGE_H
