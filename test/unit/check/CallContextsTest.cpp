//===- CallContextsTest.cpp - The calls that led to any moment ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/CallContexts.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

using Calls = std::vector<uint32_t>;

TEST(CallContexts, EqualCallsAreOneContext) {
  CallContexts Contexts;
  const CallContext A = Contexts.child(0, 100);
  const CallContext B = Contexts.child(A, 200);
  EXPECT_EQ(Contexts.child(0, 100), A);
  EXPECT_NE(Contexts.child(0, 200), B);
  EXPECT_EQ(Contexts.calls(B), (Calls{200, 100}));
  EXPECT_EQ(Contexts.stackAt(300, B), (Calls{300, 200, 100}));
  EXPECT_EQ(Contexts.calls(0), Calls());
}

TEST(ThreadCallStack, CallsAndReturns) {
  CallContexts Contexts;
  ThreadCallStack Stack;
  Stack.called(Contexts, 100, 104, 0x1000);
  Stack.called(Contexts, 200, 204, 0x0F00);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{200, 100}));
  Stack.jumped(204, 0x0F00);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{100}));
  Stack.jumped(104, 0x1000);
  EXPECT_EQ(Stack.context(), 0u);
}

TEST(ThreadCallStack, JumpThatIsNoReturn) {
  // Of a switch, in the called function.
  CallContexts Contexts;
  ThreadCallStack Stack;
  Stack.called(Contexts, 100, 104, 0x1000);
  Stack.jumped(500, 0x0FF0);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{100}));
}

TEST(ThreadCallStack, TailCall) {
  // The function jumped to returns to the first caller.
  CallContexts Contexts;
  ThreadCallStack Stack;
  Stack.called(Contexts, 100, 104, 0x1000);
  Stack.jumped(700, 0x1000);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{100}));
  Stack.jumped(104, 0x1000);
  EXPECT_EQ(Stack.context(), 0u);
}

TEST(ThreadCallStack, LongJumpLeavesManyFunctions) {
  CallContexts Contexts;
  ThreadCallStack Stack;
  Stack.called(Contexts, 100, 104, 0x1000);
  Stack.called(Contexts, 200, 204, 0x0F00);
  Stack.called(Contexts, 300, 304, 0x0E00);
  Stack.jumped(150, 0x0F80);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{100}));
}

TEST(ThreadCallStack, CallsThatDoNotReturnDoNotPileUp) {
  // Assembly that finds out where it is.
  CallContexts Contexts;
  ThreadCallStack Stack;
  for (unsigned I = 0; I != 10; ++I)
    Stack.called(Contexts, 100, 104, 0x1000);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{100}));
  Stack.called(Contexts, 200, 204, 0x0F00);
  Stack.called(Contexts, 300, 304, 0x1000);
  EXPECT_EQ(Contexts.calls(Stack.context()), (Calls{300, 100}));
}

TEST(ThreadCallStack, Recursion) {
  CallContexts Contexts;
  ThreadCallStack Stack;
  for (uint32_t Depth = 0; Depth != 50; ++Depth)
    Stack.called(Contexts, 100, 104, 0x1000 - 16 * Depth);
  EXPECT_EQ(Contexts.calls(Stack.context()).size(), 50u);
  for (uint32_t Depth = 50; Depth-- != 0;)
    Stack.jumped(104, 0x1000 - 16 * Depth);
  EXPECT_EQ(Stack.context(), 0u);
}

} // namespace
