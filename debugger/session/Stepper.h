//===- Stepper.h - Runs a thread to where a step ends -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_STEPPER_H
#define TP_DEBUGGER_SESSION_STEPPER_H

#include "debugger/session/Session.h"

#include "llvm/ADT/SmallVector.h"

namespace tp {

/// Takes a thread from one place of the source to another, forwards or
/// backwards, in as few runs as possible: one per line or call that is passed.
class Stepper {
public:
  Stepper(Session &Owner, uint32_t Thread);

  SessionStop step(const StepRequest &Request);
  llvm::Expected<SessionStop> finish(const Frame &Of, Direction Towards);
  SessionStop advance(const Frame &Of, llvm::ArrayRef<CodeLocation> Locations);
  SessionStop until();

private:
  /// The function that a step is in.
  struct Place {
    FrameContext Context;
    uint32_t Cfa = 0;
    uint32_t ReturnPc = 0;
    std::optional<uint32_t> Function;
    /// The innermost function there, if it is inlined.
    std::optional<uint32_t> Inlined;
    SourcePosition Line;

    /// Inlined, or else Function.
    std::optional<uint32_t> innermost() const {
      return Inlined ? Inlined : Function;
    }
  };
  /// How another place of the thread lies to one.
  enum class Relation { Same, Callee, Other };

  Session &Owner;
  const SourceMap &Map;
  uint32_t Thread;

  uint32_t pc() const;
  Place here();
  Relation relationTo(const Place &Of);
  bool hasLine(uint32_t Pc) const;
  /// The place in the function, which is inlined there or the outermost, that
  /// an instruction is of.
  std::optional<SourcePosition> lineIn(uint32_t Pc, uint32_t Function) const;
  std::vector<AddressRange> rangesOf(const Place &Of) const;
  /// With what is inlined into the function \p Level at that line.
  std::vector<AddressRange> rangesOf(const Place &Of,
                                     std::optional<uint32_t> Level) const;
  bool isInlinedCallee(const Place &Of) const;
  std::optional<FrameContext> caller() const;
  /// The call that the thread's function will return behind.
  std::optional<uint32_t> callSite() const;
  /// Before the first statement of its function, or at it.
  bool isInPrologue(const Place &At) const;

  SessionStop run(Direction Towards, InstructionEvents Until);
  SessionStop oneInstruction(Direction Towards);
  SessionStop leave(llvm::ArrayRef<AddressRange> Ranges, Direction Towards);
  SessionStop to(uint32_t Pc, std::optional<uint32_t> StackPointer,
                 Direction Towards);
  SessionStop forward(bool OverCalls, bool NotBack);
  SessionStop backward(bool OverCalls);
  /// To the last instruction before \p Start that is of a line, or in another
  /// function.
  SessionStop toLineBefore(const Place &Start, bool OverCalls);
  /// From a function's first instruction to behind its call.
  SessionStop returnFromCallee();
  /// From within a function to before its call.
  SessionStop backToCall();
  SessionStop skipPrologue(SessionStop Stop);
  SessionStop leaveInlined(const Frame &Of, Direction Towards);
  /// What the function returned to a caller with this stack pointer; none if
  /// nothing or where is not known.
  std::optional<Value> returned(uint32_t Function, uint32_t StackPointer);
  /// The object that the caller has reserved for what the function returns.
  std::optional<uint32_t> resultObject(uint32_t Function,
                                       uint32_t StackPointer);
};

} // namespace tp

#endif // TP_DEBUGGER_SESSION_STEPPER_H
