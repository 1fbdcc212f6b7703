//===- StopReason.cpp - Why the program stands, for a client --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/StopReason.h"

#include "debugger/dap/Debuggee.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/ErrorHandling.h"

#include <cassert>

using namespace llvm;

namespace tp::dap {

namespace {

/// One of the protocol's words, and a sentence if that says more.
struct Reason {
  StringRef Word;
  std::string Sentence;
};

} // namespace

/// The protocol's word for the kind of breakpoint that was set.
static StringRef breakpointWord(const SessionStop &Stop,
                                const BreakpointWords &Words) {
  for (unsigned Number : Stop.Numbers) {
    auto Known = Words.find(Number);
    if (Known != Words.end())
      return Known->second;
  }
  return "breakpoint";
}

/// The watched bytes as a value of their type, or as bytes.
static std::string watchedText(ArrayRef<uint8_t> Bytes, const SessionStop &Stop,
                               Session &Program) {
  if (!Stop.WatchedType || Stop.WatchedType->Size != Bytes.size())
    return "0x" + toHex(Bytes, /*LowerCase=*/true);
  FrameContext Frame = Program.context(Stop.Thread);
  return Program.printer().summary(
      tp::Value::computed(*Stop.WatchedType, Bytes), Frame);
}

static Reason watchReason(const SessionStop &Stop, Session &Program) {
  std::string Name = "data";
  for (unsigned Number : Stop.Numbers)
    if (const tp::Breakpoint *Hit = Program.breakpoints().find(Number))
      Name = Hit->Text;
  if (!Stop.IsWrite)
    return {"data breakpoint",
            Name + " is read: " + watchedText(Stop.Old, Stop, Program)};
  return {"data breakpoint", Name + ": " +
                                 watchedText(Stop.Old, Stop, Program) + " -> " +
                                 watchedText(Stop.New, Stop, Program)};
}

static Reason reasonOf(const SessionStop &Stop, Session &Program,
                       const BreakpointWords &Words) {
  switch (Stop.Kind) {
  case SessionStop::Breakpoint:
    return {breakpointWord(Stop, Words), ""};
  case SessionStop::Watchpoint:
    return watchReason(Stop, Program);
  case SessionStop::ScopeEnded:
    return {"data breakpoint", "the watched variable's function has returned"};
  case SessionStop::Step:
    return {"step", ""};
  case SessionStop::Exited:
    return {"exit",
            "the program has ended with status " + itostr(Stop.ExitStatus)};
  case SessionStop::Trapped:
    assert(Stop.TrapInfo && "a trap says what it is");
    return {"exception", Stop.TrapInfo->what()};
  case SessionStop::Beginning:
    return {"entry", "before this the program has done nothing"};
  case SessionStop::Interrupted:
    return {"pause", ""};
  case SessionStop::CycleLimit:
    return {"pause", "--max-cycles is reached"};
  case SessionStop::ConditionFailed:
    return {"breakpoint", "the condition cannot be evaluated"};
  }
  llvm_unreachable("unknown kind of stop");
}

json::Object stoppedBody(const SessionStop &Stop, Session &Program,
                         const BreakpointWords &Words) {
  Reason Why = reasonOf(Stop, Program, Words);
  json::Object Body{{"reason", Why.Word},
                    {"threadId", threadId(Stop.Thread)},
                    {"allThreadsStopped", true}};
  if (!Why.Sentence.empty()) {
    Body["description"] = json::fixUTF8(Why.Sentence);
    Body["text"] = json::fixUTF8(Why.Sentence);
  }
  if (!Stop.Numbers.empty())
    Body["hitBreakpointIds"] = json::Array(Stop.Numbers);
  return Body;
}

} // namespace tp::dap
