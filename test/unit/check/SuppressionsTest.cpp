//===- SuppressionsTest.cpp - Reports that the user does not want ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/Suppressions.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/raw_ostream.h"

#include "gtest/gtest.h"

using namespace llvm;
using tp::Suppressions;

/// What a file with \p Text suppresses.
static Expected<Suppressions> read(StringRef Text) {
  int File;
  SmallString<128> Path;
  EXPECT_FALSE(sys::fs::createTemporaryFile("suppressions", "txt", File, Path));
  raw_fd_ostream(File, /*shouldClose=*/true) << Text;
  Expected<Suppressions> Result = Suppressions::read(Path);
  EXPECT_FALSE(sys::fs::remove(Path));
  return Result;
}

static std::string errorOf(StringRef Text) {
  Expected<Suppressions> Result = read(Text);
  return Result ? "" : toString(Result.takeError());
}

TEST(Suppressions, NothingIsCoveredByNothing) {
  EXPECT_TRUE(Suppressions().isEmpty());
  Expected<Suppressions> Empty = read("\n# race:f\n  \r\n");
  ASSERT_TRUE(bool(Empty));
  EXPECT_TRUE(Empty->isEmpty());
  EXPECT_FALSE(Empty->covers("race", "f"));
}

TEST(Suppressions, ByCheckerAndFunctionWithAndWithoutArguments) {
  Expected<Suppressions> Rules = read("race:tp::Cache::*\r\n*:f?ll(int)\n");
  ASSERT_TRUE(bool(Rules));
  EXPECT_TRUE(Rules->covers("race", "tp::Cache::get(unsigned int) const"));
  EXPECT_FALSE(Rules->covers("init", "tp::Cache::get(unsigned int) const"));
  EXPECT_TRUE(Rules->covers("init", "fill(int)"));
  EXPECT_TRUE(Rules->covers("memory", "full(int)"));
  EXPECT_FALSE(Rules->covers("memory", "full(char)"));
  EXPECT_FALSE(Rules->covers("race", "main"));
}

TEST(Suppressions, OnlyStarAndQuestionMarkStandForOthers) {
  Expected<Suppressions> Rules = read("race:Table::operator[]\nrace:a[bc]\n");
  ASSERT_TRUE(bool(Rules)) << toString(Rules.takeError());
  EXPECT_TRUE(Rules->covers("race", "Table::operator[](int)"));
  EXPECT_TRUE(Rules->covers("race", "a[bc]"));
  EXPECT_FALSE(Rules->covers("race", "ab"));
}

TEST(Suppressions, CopiesOutliveTheirFile) {
  Suppressions Copy;
  {
    Expected<Suppressions> Rules =
        read("race:some_function_with_a_long_name*\n");
    ASSERT_TRUE(bool(Rules));
    Copy = *Rules;
  }
  EXPECT_TRUE(Copy.covers("race", "some_function_with_a_long_name_too"));
}

TEST(Suppressions, ErrorsNameTheLine) {
  EXPECT_NE(errorOf("race:f\nleaks:f\n").find(":2: 'leaks' is no checker"),
            std::string::npos);
  EXPECT_NE(errorOf("\nrace\n").find(":2: expected <checker>:<function>"),
            std::string::npos);
}
