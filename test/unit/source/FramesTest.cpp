//===- FramesTest.cpp - Backtraces against the calls of a run ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/source/DebuggedProgram.h"

#include "simulator/isa/Instructions.h"

#include "llvm/Support/Endian.h"

#include <gtest/gtest.h>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

uint32_t wordAt(const FrameContext &Frame, uint32_t Address) {
  uint8_t Bytes[4] = {};
  EXPECT_TRUE(Frame.read(Address, Bytes));
  return support::endian::read32le(Bytes);
}

/// A caller at its call.
struct Call {
  RegisterSet Registers;
  uint32_t ReturnPc = 0;
};

/// Compares the unwound callers at every instruction with the calls that the
/// run has made.
unsigned checkUnwinding(const std::vector<std::string> &Options) {
  DebuggedProgram Program("Debug/values.cpp", Options);
  std::vector<Call> Calls;
  unsigned Checked = 0, Deepest = 0;
  uint32_t Previous = 0;
  RegisterSet Before;
  Program.run([&](const FrameContext &Frame) {
    if (Previous) {
      Instruction Last = decode(wordAt(Frame, Previous));
      bool IsCall = Frame.Registers.Values[31] == Previous + 4 &&
                    (Last.Op == Opcode::JAL || Last.Op == Opcode::JALR);
      bool IsReturn = Last.Op == Opcode::JR && Last.Source[0] == 31;
      if (IsCall)
        Calls.push_back({Before, Previous + 4});
      else if (IsReturn && !Calls.empty())
        Calls.pop_back();
    }
    Previous = Frame.Pc;
    Before = Frame.Registers;
    FrameContext At = Frame;
    for (size_t I = Calls.size(); I-- != 0;) {
      Expected<std::optional<FrameContext>> Caller =
          Program.information().unwinder().caller(At);
      ASSERT_TRUE(bool(Caller)) << toString(Caller.takeError());
      ASSERT_TRUE(Caller->has_value());
      At = **Caller;
      ASSERT_EQ(At.Pc, Calls[I].ReturnPc);
      for (unsigned Register = 0; Register != DwarfRegisters; ++Register)
        if (At.Registers.isKnown(Register) && Register != 31)
          ASSERT_EQ(At.Registers.Values[Register],
                    Calls[I].Registers.Values[Register])
              << "register " << Register << " at " << Frame.Pc;
      ASSERT_TRUE(At.Registers.isKnown(29));
      ASSERT_TRUE(At.Registers.isKnown(20));
    }
    Expected<std::optional<FrameContext>> Outermost =
        Program.information().unwinder().caller(At);
    ASSERT_TRUE(bool(Outermost)) << toString(Outermost.takeError());
    ASSERT_FALSE(Outermost->has_value())
        << Program.map().describeAddress(Frame.Pc) << ", called from "
        << Program.map().describeAddress((*Outermost)->Pc);
    Deepest = std::max(Deepest, unsigned(Calls.size()));
    ++Checked;
  });
  EXPECT_GE(Deepest, 5u);
  return Checked;
}

std::vector<std::string> namesOf(DebuggedProgram &Program,
                                 const FrameContext &Innermost) {
  std::vector<std::string> Names;
  for (const Frame &Part : Program.backtrace(Innermost))
    Names.push_back(Part.Function ? Program.map().function(*Part.Function).Name
                                  : "?");
  return Names;
}

} // namespace

TEST(Frames, CallersAreThoseOfTheRunAtEveryInstruction) {
  EXPECT_GT(checkUnwinding({"-O0", "-g"}), 1000u);
  EXPECT_GT(checkUnwinding({"-O2", "-g"}), 500u);
}

TEST(Frames, InlinedFunctionsAreFrames) {
  DebuggedProgram Program("Debug/values.cpp", {"-O2", "-g"});
  bool Seen = false;
  Program.runToCallsOf("probe", [&](const FrameContext &Caller) {
    std::vector<Frame> Stack = Program.backtrace(Caller);
    if (Stack.size() < 2 || !Stack[0].Inlined)
      return;
    Seen = true;
    const SourceMap &Map = Program.map();
    EXPECT_EQ(Map.function(*Stack[0].Function).Name, "inner(int, int)");
    EXPECT_EQ(Map.function(*Stack[1].Function).Name, "inlined(int, int)");
    EXPECT_EQ(Stack[0].Cfa, Stack[1].Cfa);
    EXPECT_EQ(Stack[1].Context.InlineDepth, 1u);
    EXPECT_GT(Stack[1].Position.Line, Stack[0].Position.Line);
  });
  EXPECT_TRUE(Seen);
}

TEST(Frames, RecursionIsThereAtAllLevels) {
  DebuggedProgram Program("Debug/values.cpp", {"-O0", "-g"});
  unsigned Deepest = 0;
  Program.runToCallsOf("probe", [&](const FrameContext &Frame) {
    unsigned Levels = 0;
    for (const std::string &Name : namesOf(Program, Frame))
      Levels += Name == "recursive(int)";
    Deepest = std::max(Deepest, Levels);
  });
  EXPECT_EQ(Deepest, 4u);
}

TEST(Frames, ALimitCountsInlinedFramesToo) {
  DebuggedProgram Program("Debug/values.cpp", {"-O2", "-g"});
  Program.runToCallsOf("probe", [&](const FrameContext &Frame) {
    EXPECT_EQ(
        Program.information().unwinder().backtrace(Frame, 2).Frames.size(), 2u);
  });
}

TEST(Frames, ABrokenStackEndsWithAReason) {
  DebuggedProgram Program("Debug/values.cpp", {"-O0", "-g"});
  bool Done = false;
  Program.runToCallsOf("probe", [&](const FrameContext &Frame) {
    if (Done)
      return;
    Done = true;
    FrameContext Broken = Frame;
    Broken.Registers.Values[29] = 16;
    Backtrace Stack = Program.information().unwinder().backtrace(Broken);
    EXPECT_EQ(Stack.Frames.size(), 1u);
    EXPECT_NE(Stack.Problem.find("cannot read the saved register"),
              std::string::npos)
        << Stack.Problem;
    Broken.Pc = 0x40;
    Broken.IsCaller = false;
    Stack = Program.information().unwinder().backtrace(Broken);
    EXPECT_EQ(Stack.Problem, "no frame information for this code");
  });
}
