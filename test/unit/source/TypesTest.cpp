//===- TypesTest.cpp - Types of a program --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/source/DebuggedProgram.h"

#include <gtest/gtest.h>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

class TypesTest : public testing::Test {
protected:
  static inline std::unique_ptr<DebuggedProgram> Program;

  static void SetUpTestSuite() {
    Program = std::make_unique<DebuggedProgram>(
        "unit/source/Inputs/expressions.cpp",
        std::vector<std::string>{"-O0", "-g", "-fstandalone-debug"});
  }
  static void TearDownTestSuite() { Program.reset(); }

  std::string describe(const char *Name) {
    const Type *Found = Program->information().types().find(Name);
    return Found ? describeType(*Found) : "none";
  }
};

} // namespace

TEST_F(TypesTest, DefinitionsAsTheSourceHasThem) {
  EXPECT_EQ(describe("scene::Vector"), "struct scene::Vector {\n"
                                       "    float X;\n"
                                       "    float Y;\n"
                                       "    float Z;\n"
                                       "}");
  EXPECT_EQ(describe("Color"), "enum Color {Red, Green = 5, Blue}");
  EXPECT_EQ(describe("Mode"), "enum class Mode {Off, On = 200}");
  EXPECT_EQ(describe("scene::Box<int, 3>"), "struct scene::Box<int, 3> {\n"
                                            "    int Items[3];\n"
                                            "    int Used;\n"
                                            "}");
  EXPECT_EQ(describe("Sphere"),
            "struct scene::Sphere : scene::Shape, scene::Counter {\n"
            "    scene::Vector Center;\n"
            "    float Radius;\n"
            "    unsigned int Visible : 1;\n"
            "    int Level : 5;\n"
            "    unsigned int Wide : 20;\n"
            "    union {\n"
            "        int AsInteger;\n"
            "        float AsFloat;\n"
            "    };\n"
            "    Mode State;\n"
            "    const char *Name;\n"
            "    scene::Sphere *Next;\n"
            "}");
  EXPECT_EQ(describe("Nothing"), "none");
}

TEST_F(TypesTest, PointersShowWhatTheyPointTo) {
  TypeTable &Types = Program->information().types();
  const Type &Color = *Types.find("Color");
  EXPECT_EQ(describeType(Types.pointerTo(Color)),
            "enum Color {Red, Green = 5, Blue} *");
  EXPECT_EQ(describeType(Types.arrayOf(Color, 4)),
            "enum Color {Red, Green = 5, Blue} [4]");
  EXPECT_EQ(describeType(Types.pointerTo(Types.basic("int"))), "int *");
}

TEST_F(TypesTest, NamesMayLackNamespaces) {
  TypeTable &Types = Program->information().types();
  EXPECT_EQ(Types.find("Sphere"), Types.find("scene::Sphere"));
  EXPECT_NE(Types.find("other::Vector"), Types.find("scene::Vector"));
  EXPECT_EQ(Types.find("wrong::Sphere"), nullptr);
  EXPECT_EQ(Types.find("::Sphere"), nullptr);
  EXPECT_EQ(Types.find("::scene::Sphere"), Types.find("scene::Sphere"));
}

TEST_F(TypesTest, DerivedTypesAreTheSame) {
  TypeTable &Types = Program->information().types();
  const Type &Int = Types.basic("int");
  EXPECT_EQ(&Types.pointerTo(Int), &Types.pointerTo(Int));
  EXPECT_EQ(Types.pointerTo(Int).Name, "int *");
  EXPECT_EQ(Types.pointerTo(Types.pointerTo(Int)).Name, "int **");
  EXPECT_EQ(Types.arrayOf(Types.arrayOf(Int, 4), 3).Name, "int[3][4]");
  EXPECT_EQ(Types.pointerTo(Types.arrayOf(Int, 4)).Name, "int (*)[4]");
  EXPECT_EQ(Types.arrayOf(Types.arrayOf(Int, 4), 3).Size, 48u);
}
