//===- LogMessage.cpp - What a log point prints ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/LogMessage.h"

#include "debugger/source/ValuePrinter.h"

using namespace llvm;

namespace tp::dap {

/// The length of the expression that \p Text begins with, up to the brace that
/// closes it; nothing if none does.
static std::optional<size_t> expressionLength(StringRef Text) {
  unsigned Depth = 0;
  for (size_t I = 0; I < Text.size(); ++I) {
    if (Text[I] == '{')
      ++Depth;
    else if (Text[I] == '}' && Depth-- == 0)
      return I;
  }
  return std::nullopt;
}

Expected<LogMessage> LogMessage::parse(StringRef Text,
                                       DebugInformation &Information) {
  LogMessage Result;
  Result.Information = &Information;
  std::string Plain;
  for (StringRef Rest = Text; !Rest.empty();) {
    if (Rest.consume_front("\\{")) {
      Plain += '{';
      continue;
    }
    if (!Rest.consume_front("{")) {
      Plain += Rest.front();
      Rest = Rest.drop_front();
      continue;
    }
    std::optional<size_t> Length = expressionLength(Rest);
    if (!Length)
      return createStringError("log message '" + Text +
                               "': no brace closes '{" + Rest + "'");
    Expected<Expression> Value =
        Expression::parse(Rest.take_front(*Length), Information);
    if (!Value)
      return createStringError("log message '" + Text +
                               "': " + toString(Value.takeError()));
    Result.Parts.push_back({std::move(Plain), std::move(*Value)});
    Plain.clear();
    Rest = Rest.drop_front(*Length + 1);
  }
  Result.Parts.push_back({std::move(Plain), std::nullopt});
  return std::move(Result);
}

std::string LogMessage::render(const FrameContext &Frame) const {
  ValuePrinter Printer(Information->map());
  std::string Result;
  for (const Part &Each : Parts) {
    Result += Each.Text;
    if (!Each.Value)
      continue;
    Expected<tp::Value> Value = Each.Value->evaluate(Frame);
    Result += Value ? Printer.print(*Value, Frame)
                    : "<error: " + toString(Value.takeError()) + ">";
  }
  return Result;
}

} // namespace tp::dap
