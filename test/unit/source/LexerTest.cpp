//===- LexerTest.cpp - Words of expressions ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/ExpressionLexer.h"

#include <gtest/gtest.h>

using namespace llvm;
using namespace tp;

static std::string words(StringRef Text) {
  Expected<std::vector<Token>> Tokens = tokenize(Text);
  if (!Tokens)
    return "error: " + toString(Tokens.takeError());
  std::string Result;
  for (const Token &Word : *Tokens)
    Result += (Result.empty() ? "" : " ") + Word.Text.str();
  return Result;
}

TEST(Lexer, TheLongestOperatorWins) {
  EXPECT_EQ(words("a<<=b>>c->d--e::f"), "a <<= b >> c -> d -- e :: f ");
  EXPECT_EQ(words("a+++b"), "a ++ + b ");
  EXPECT_EQ(words("x.y"), "x . y ");
}

TEST(Lexer, NumbersEndWhereTheyEnd) {
  EXPECT_EQ(words("1+2"), "1 + 2 ");
  EXPECT_EQ(words("1e+2"), "1e+2 ");
  EXPECT_EQ(words("0x1e+2"), "0x1e + 2 ");
  EXPECT_EQ(words("1.5f*x"), "1.5f * x ");
}

TEST(Lexer, DollarNames) { EXPECT_EQ(words("$r4+$$2-$"), "$r4 + $$2 - $ "); }

TEST(Lexer, BadWordsAreErrors) {
  EXPECT_EQ(words("1.2.3"), "error: Invalid number \"1.2.3\".");
  EXPECT_EQ(words("1uu"), "error: Invalid number \"1uu\".");
  EXPECT_EQ(words("''"), "error: Empty character constant.");
  EXPECT_EQ(words("99999999999999999999"),
            "error: Invalid number \"99999999999999999999\".");
}
