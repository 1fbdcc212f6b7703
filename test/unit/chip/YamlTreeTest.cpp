//===- YamlTreeTest.cpp - A YAML document with line numbers ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/YamlTree.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace tp;
using testing::StartsWith;

namespace {

std::string errorOf(llvm::StringRef Text) {
  llvm::Expected<YamlValue> Tree = parseYaml(Text, "f.yaml");
  return Tree ? "" : llvm::toString(Tree.takeError());
}

TEST(YamlTree, KeepsLinesOfKeysAndValues) {
  llvm::Expected<YamlValue> Tree =
      parseYaml("# comment\na: 1\nb:\n  c: 'x y'\n  d: {e: 2}\n", "f.yaml");
  ASSERT_TRUE(bool(Tree)) << llvm::toString(Tree.takeError());
  ASSERT_EQ(Tree->Entries.size(), 2u);
  EXPECT_EQ(Tree->Entries[0].Key, "a");
  EXPECT_EQ(Tree->Entries[0].Line, 2u);
  EXPECT_EQ(Tree->Entries[0].Value.Text, "1");
  const YamlValue &B = Tree->Entries[1].Value;
  ASSERT_EQ(B.Is, YamlValue::Kind::Mapping);
  EXPECT_EQ(B.Entries[0].Line, 4u);
  EXPECT_EQ(B.Entries[0].Value.Text, "x y");
  EXPECT_EQ(B.Entries[1].Value.Entries[0].Value.Line, 5u);
}

TEST(YamlTree, RefusesWhatIsNotAMapping) {
  EXPECT_THAT(errorOf(""), StartsWith("f.yaml:1: the file is empty"));
  EXPECT_THAT(errorOf("- a\n- b\n"), StartsWith("f.yaml:1: expected"));
  EXPECT_THAT(errorOf("word\n"), StartsWith("f.yaml:1: expected"));
  EXPECT_THAT(errorOf("a: 1\n---\nb: 2\n"), StartsWith("f.yaml:"));
}

TEST(YamlTree, NamesTheLineOfASyntaxError) {
  EXPECT_THAT(errorOf("a: 1\nb: {c: 1\nd: 2\n"), StartsWith("f.yaml:"));
  EXPECT_THAT(errorOf("a: 1\n\tb: 2\n"), StartsWith("f.yaml:"));
}

TEST(YamlTree, RefusesARepeatedKeyAtAnyDepth) {
  EXPECT_EQ(errorOf("a: 1\nb: 2\na: 3\n"),
            "f.yaml:3: key 'a' is given twice; the first is on line 1");
  EXPECT_EQ(errorOf("a:\n  b: 1\n  b: 2\n"),
            "f.yaml:3: key 'b' is given twice; the first is on line 2");
}

} // namespace
