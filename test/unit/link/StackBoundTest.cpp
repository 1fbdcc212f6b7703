//===- StackBoundTest.cpp - Bounds of made-up call graphs -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/StackBound.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <map>
#include <random>

using namespace tp;

/// The deepest chain of a graph whose calls lead to greater numbers, by trying
/// all.
static uint32_t
deepest(const std::vector<uint32_t> &Frames,
        const std::vector<std::vector<std::pair<int, bool>>> &Calls,
        size_t From) {
  uint32_t Most = Frames[From];
  for (auto [Callee, IsTail] : Calls[From])
    Most = std::max(Most, (IsTail ? 0 : Frames[From]) +
                              deepest(Frames, Calls, size_t(Callee)));
  return Most;
}

namespace {

/// A call graph by names; the first function is the entry.
class Graph {
public:
  Graph &function(const std::string &Name, uint32_t FrameBytes) {
    CallGraphNode &Node = node(Name);
    Node.FrameBytes = FrameBytes;
    return *this;
  }
  Graph &kind(const std::string &Name, CallGraphNode::Frame Kind) {
    node(Name).Kind = Kind;
    return *this;
  }
  Graph &call(const std::string &Caller, const std::string &Callee) {
    node(Caller).Calls.push_back({&node(Callee), /*IsTail=*/false});
    return *this;
  }
  Graph &jump(const std::string &Caller, const std::string &Callee) {
    node(Caller).Calls.push_back({&node(Callee), /*IsTail=*/true});
    return *this;
  }
  StackBound bound() {
    Calls.Entry = &Calls.Nodes.front();
    return boundStack(Calls);
  }

private:
  CallGraphNode &node(const std::string &Name) {
    CallGraphNode *&Node = ByName[Name];
    if (!Node) {
      Node = &Calls.Nodes.emplace_back();
      Node->Name = Name;
    }
    return *Node;
  }

  CallGraph Calls;
  std::map<std::string, CallGraphNode *> ByName;
};

TEST(StackBound, IsTheDeepestChain) {
  StackBound Bound = Graph()
                         .function("main", 16)
                         .function("a", 100)
                         .function("b", 40)
                         .function("c", 72)
                         .call("main", "a")
                         .call("main", "b")
                         .call("b", "c")
                         .call("a", "b")
                         .bound();
  // 228, in steps of 16.
  EXPECT_EQ(Bound.Bytes, 240u);
  EXPECT_EQ(describeChain(Bound), "main -> a -> b -> c");
  EXPECT_EQ(Bound.DeepestChain[1].FrameBytes, 100u);
}

TEST(StackBound, CountsWhatCannotBeReachedNever) {
  StackBound Bound = Graph()
                         .function("main", 16)
                         .function("dead", 1000)
                         .call("dead", "dead")
                         .bound();
  EXPECT_EQ(Bound.Bytes, 16u);
}

TEST(StackBound, TailCallsGiveBackTheFrame) {
  StackBound Bound = Graph()
                         .function("main", 16)
                         .function("a", 96)
                         .function("b", 64)
                         .call("main", "a")
                         .jump("a", "b")
                         .bound();
  EXPECT_EQ(Bound.Bytes, 112u);
  EXPECT_EQ(describeChain(Bound), "main -> a");
  // They may go in a circle, from which one leaves at the deepest place.
  Bound = Graph()
              .function("main", 16)
              .function("a", 32)
              .function("b", 48)
              .function("leaf", 80)
              .call("main", "a")
              .jump("a", "b")
              .jump("b", "a")
              .call("b", "leaf")
              .bound();
  EXPECT_EQ(Bound.Bytes, 144u);
  EXPECT_EQ(describeChain(Bound), "main -> a -> b -> leaf");
}

TEST(StackBound, RecursionHasNone) {
  StackBound Bound = Graph()
                         .function("main", 16)
                         .function("a", 16)
                         .function("b", 0)
                         .call("main", "a")
                         .jump("a", "b")
                         .jump("b", "a")
                         .call("a", "b")
                         .bound();
  EXPECT_EQ(Bound.Bytes, std::nullopt);
  EXPECT_EQ(Bound.Reason, "  recursion: a -> b -> a\n"
                          "  reached by main -> a");
  Bound = Graph().function("main", 8).call("main", "main").bound();
  EXPECT_EQ(Bound.Reason, "  recursion: main -> main");
}

TEST(StackBound, UnknownFramesHaveNone) {
  Graph Calls;
  Calls.function("main", 8).call("main", "a").call("a", "b");
  EXPECT_EQ(Calls.bound().Bytes, 16u);
  StackBound Bound = Calls.kind("b", CallGraphNode::Frame::Dynamic).bound();
  EXPECT_EQ(Bound.Bytes, std::nullopt);
  EXPECT_THAT(Bound.Reason, testing::HasSubstr("b takes stack of a size"));
  EXPECT_THAT(Bound.Reason, testing::HasSubstr("main -> a -> b"));
  Bound = Calls.kind("b", CallGraphNode::Frame::Unstated).bound();
  EXPECT_THAT(Bound.Reason, testing::HasSubstr("b is not compiled"));
}

TEST(StackBound, EndsAtTheLargestLocalStore) {
  EXPECT_EQ(Graph().function("main", 0x100000).bound().Bytes, 0x100000u);
  StackBound Bound = Graph()
                         .function("main", 0xFFFFFFF0)
                         .function("a", 0xFFFFFFF0)
                         .call("main", "a")
                         .bound();
  EXPECT_EQ(Bound.Bytes, std::nullopt);
  EXPECT_EQ(Bound.Reason, "  it may take 8589934560 bytes, more than the "
                          "largest local store has");
}

TEST(StackBound, AgreesWithAllPathsOfRandomGraphs) {
  std::mt19937 Random(1);
  for (int Round = 0; Round != 200; ++Round) {
    constexpr int Count = 12;
    std::vector<uint32_t> Frames;
    std::vector<std::vector<std::pair<int, bool>>> Calls(Count);
    Graph Made;
    for (int I = 0; I != Count; ++I) {
      Frames.push_back(Random() % 8 * 16);
      Made.function(std::to_string(I), Frames.back());
    }
    for (int Caller = 0; Caller != Count - 1; ++Caller)
      for (unsigned Number = Random() % 4; Number != 0; --Number) {
        const int Callee =
            Caller + 1 + int(Random() % unsigned(Count - 1 - Caller));
        const bool IsTail = Random() % 3 == 0;
        Calls[size_t(Caller)].push_back({Callee, IsTail});
        if (IsTail)
          Made.jump(std::to_string(Caller), std::to_string(Callee));
        else
          Made.call(std::to_string(Caller), std::to_string(Callee));
      }
    const StackBound Bound = Made.bound();
    EXPECT_EQ(Bound.Bytes, deepest(Frames, Calls, 0));
    uint32_t Sum = 0;
    for (const StackBound::Step &Step : Bound.DeepestChain)
      Sum += Step.FrameBytes;
    EXPECT_EQ(Bound.Bytes, Sum);
  }
}

} // namespace
