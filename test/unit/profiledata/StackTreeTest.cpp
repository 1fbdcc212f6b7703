//===- StackTreeTest.cpp - Calls and inlined functions in one tree --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/StackTree.h"
#include "test/unit/profiledata/SmallProfile.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

using Stack = std::vector<uint32_t>;

/// By functions from the outermost; nodes of their own are not merged.
std::map<Stack, ProfileCounts> stacksOf(const Profile &Data) {
  StackTree Tree(Data);
  std::map<Stack, ProfileCounts> Result;
  for (uint32_t I = 0; I != Tree.nodes().size(); ++I) {
    bool IsNew =
        Result.try_emplace(Tree.functionsOf(I), Tree.nodes()[I].Self).second;
    EXPECT_TRUE(IsNew);
  }
  return Result;
}

TEST(StackTree, JoinsCallsAndInlinedFunctions) {
  auto Stacks = stacksOf(smallProfile());
  ASSERT_EQ(Stacks.size(), 4u);
  EXPECT_EQ(Stacks[Stack{0}], counts(1, 2));
  EXPECT_EQ((Stacks[Stack{0, 2}]), counts(4, 0));
  // The shares of leaf's calls in its instructions are 1 and 2 thirds, in its
  // waits all and nothing.
  EXPECT_EQ((Stacks[Stack{0, 1}]), counts(10, 9));
  EXPECT_EQ((Stacks[Stack{0, 2, 1}]), counts(20, 0));
}

TEST(StackTree, SharesAddUpWhateverTheWeights) {
  Profile Data = smallProfile();
  for (uint64_t First : {0, 1, 3, 7, 1000003}) {
    Data.Calls[1].Self = counts(First, First / 2);
    ProfileCounts Sum;
    for (const auto &[Functions, Self] : stacksOf(Data))
      Sum += Self;
    EXPECT_EQ(Sum, Data.total()) << First;
  }
}

TEST(StackTree, AFunctionWithoutCallsIsARoot) {
  Profile Data = smallProfile();
  Data.Calls.clear();
  auto Stacks = stacksOf(Data);
  EXPECT_EQ(Stacks[Stack{1}], counts(30, 9));
  EXPECT_EQ((Stacks[Stack{0, 2}]), counts(4, 0));
}

} // namespace
