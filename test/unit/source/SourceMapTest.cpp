//===- SourceMapTest.cpp - Lines, functions and files of addresses -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/source/DebuggedProgram.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/MemoryBuffer.h"

#include <gtest/gtest.h>
#include <set>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

constexpr const char *Source = "unit/source/Inputs/expressions.cpp";

/// The number of the line of the source that \p Text is in.
uint32_t lineOf(StringRef Text) {
  auto Buffer = MemoryBuffer::getFile(std::string(TP_TESTS) + "/" + Source);
  EXPECT_TRUE(bool(Buffer));
  StringRef All = (*Buffer)->getBuffer();
  size_t At = All.find(Text);
  EXPECT_NE(At, StringRef::npos) << Text.str();
  return uint32_t(All.take_front(At).count('\n') + 1);
}

std::set<std::string> names(DebuggedProgram &Program, StringRef Name) {
  std::set<std::string> Result;
  for (uint32_t Index : Program.map().findFunctions(Name))
    Result.insert(Program.map().function(Index).Name);
  return Result;
}

using Names = std::set<std::string>;

} // namespace

TEST(SourceMap, FunctionsByName) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  EXPECT_EQ(names(Program, "main"), Names({"main()"}));
  EXPECT_EQ(names(Program, "twice"),
            Names({"scene::twice(int)", "scene::twice(float)"}));
  EXPECT_EQ(names(Program, "scene::twice(int)"), Names({"scene::twice(int)"}));
  EXPECT_EQ(names(Program, "twice( float )"), Names({"scene::twice(float)"}));
  EXPECT_EQ(names(Program, "other::twice"), Names());
  EXPECT_EQ(names(Program, "::twice"), Names());
  EXPECT_EQ(names(Program, "Sphere::area"),
            Names({"scene::Sphere::area(int)"}));
  EXPECT_EQ(names(Program, "_ZN5scene5twiceEi"), Names({"scene::twice(int)"}));
  EXPECT_EQ(names(Program, "nothing"), Names());
  EXPECT_EQ(names(Program, "std::array<int, 4>::operator[]"),
            Names({"std::array<int, 4U>::operator[]("
                   "std::array<int, 4U>::size_type)"}));
}

TEST(SourceMap, OperatorsByName) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  Names Calls(
      {"Function::operator()(int) const", "Function::operator()(float) const"});
  EXPECT_EQ(names(Program, "Function::operator()"), Calls);
  EXPECT_EQ(names(Program, "operator()"), Calls);
  EXPECT_EQ(names(Program, "operator()(int)"),
            Names({"Function::operator()(int) const"}));
  EXPECT_EQ(names(Program, "Function::operator<"),
            Names({"Function::operator<(const Function &) const"}));
  EXPECT_EQ(names(Program, "Function::operator>>(int)"),
            Names({"Function::operator>>(int) const"}));
  EXPECT_EQ(names(Program, "operator->"),
            Names({"Function::operator->() const"}));
  EXPECT_EQ(names(Program, "Function::operator bool"),
            Names({"Function::operator bool() const"}));
  EXPECT_EQ(names(Program, "painted"), Names({"painted<(Color)5>(int)"}));
  EXPECT_EQ(names(Program, "painted<(Color)5>(int)"),
            Names({"painted<(Color)5>(int)"}));
}

TEST(SourceMap, BreakpointsOnFunctionsAreBehindThePrologue) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  const SourceMap &Map = Program.map();
  const FunctionInfo &Function =
      Map.function(Map.findFunctions("expressions").front());
  EXPECT_GT(Function.Body, Function.Entry);
  EXPECT_EQ(Map.lineAt(Function.Body)->Position.Line, lineOf("int X = A + 1"));
  EXPECT_EQ(Function.Declared.Line, lineOf("int expressions(int A"));
  std::vector<LineStop> Stops =
      Map.stopsAtLine(Function.Declared.File, Function.Declared.Line);
  ASSERT_EQ(Stops.size(), 1u);
  EXPECT_EQ(Stops[0].Address, Function.Body);
}

TEST(SourceMap, LinesWithoutCodeStopAtTheNext) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  const SourceMap &Map = Program.map();
  std::vector<SourceFileId> Files = Map.files().find("expressions.cpp");
  ASSERT_EQ(Files.size(), 1u);
  uint32_t Line = lineOf("int &Alias = X;");
  std::vector<LineStop> Stops = Map.stopsAtLine(Files[0], Line - 1);
  ASSERT_EQ(Stops.size(), 1u);
  EXPECT_EQ(Stops[0].Position.Line, Line);
  EXPECT_EQ(Map.lineAt(Stops[0].Address)->Position.Line, Line);
  EXPECT_TRUE(Map.stopsAtLine(Files[0], 100000).empty());
  for (AddressRange Range : Map.rangesOfLine(Files[0], Line))
    EXPECT_EQ(Map.lineAt(Range.Begin)->Position.Line, Line);
}

TEST(SourceMap, EachInlinedCopyIsAStop) {
  DebuggedProgram Program("Debug/values.cpp", {"-O2", "-g"});
  const SourceMap &Map = Program.map();
  std::vector<uint32_t> Copies = Map.findFunctions("inner");
  EXPECT_EQ(Copies.size(), 2u);
  for (uint32_t Copy : Copies) {
    ASSERT_TRUE(Map.function(Copy).InlinedInto);
    EXPECT_EQ(Map.function(*Map.function(Copy).InlinedInto).BaseName,
              "inlined");
    std::vector<InlinedCall> Calls = Map.callsAt(Map.function(Copy).Body);
    ASSERT_EQ(Calls.size(), 2u);
    EXPECT_EQ(Calls[0].Function, Copy);
  }
}

TEST(SourceMap, LinesCoverWhatFunctionsCover) {
  DebuggedProgram Program("Debug/values.cpp", {"-O2", "-g"});
  const SourceMap &Map = Program.map();
  uint32_t End = 0;
  for (const LineRange &Range : Map.lines()) {
    EXPECT_GE(Range.Begin, End);
    EXPECT_LT(Range.Begin, Range.End);
    End = Range.End;
  }
  unsigned InMain = 0;
  for (const LineRange &Range : Map.lines())
    if (std::optional<uint32_t> Function = Map.functionAt(Range.Begin))
      InMain += Map.function(*Function).BaseName == "main";
  EXPECT_GT(InMain, 10u);
}

TEST(SourceMap, SymbolsOfCodeAndData) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  const SourceMap &Map = Program.map();
  uint32_t Main = *Program.elf().symbol("main");
  EXPECT_EQ(Map.symbolAt(Main), "main()");
  EXPECT_EQ(Map.symbolAt(Main + 8), "main()+8");
  uint32_t Matrix = *Program.elf().symbol("Matrix");
  EXPECT_EQ(Map.symbolAt(Matrix + 4), "Matrix+4");
  EXPECT_EQ(Map.symbolAt(0), std::nullopt);
  EXPECT_EQ(Map.describeAddress(0x20), "0x00000020");
}

TEST(SourceMap, ProgramsWithoutDebugInformationHaveSymbols) {
  DebuggedProgram Program(Source, {"-O0", "-g0"});
  const SourceMap &Map = Program.map();
  ASSERT_EQ(Map.findFunctions("main").size(), 1u);
  const FunctionInfo &Main = Map.function(Map.findFunctions("main").front());
  EXPECT_EQ(Map.functionAt(Main.Entry + 4), Map.findFunctions("main").front());
  EXPECT_EQ(Main.Body, Main.Entry);
  EXPECT_EQ(Map.findFunctions("scene::twice").size(), 2u);
}

TEST(SourceFiles, TextAndChanges) {
  DebuggedProgram Program(Source, {"-O0", "-g", "-fstandalone-debug"});
  SourceFiles &Files = Program.information().files();
  std::vector<SourceFileId> Found = Files.find("Inputs/expressions.cpp");
  ASSERT_EQ(Found.size(), 1u);
  uint32_t Line = lineOf("int &Alias = X;");
  EXPECT_EQ(Files.line({Found[0], Line, 0}), "  int &Alias = X;");
  EXPECT_EQ(Files.line({Found[0], 100000, 0}), std::nullopt);
  EXPECT_EQ(Files.shortName({Found[0], 12, 0}), "expressions.cpp:12");
  EXPECT_FALSE(Files.hasChanged(Found[0]));
  EXPECT_TRUE(Files.find("pressions.cpp").empty());
  Files.substitute(std::string(TP_TESTS) + "/unit", "/nowhere");
  Expected<ArrayRef<StringRef>> Text = Files.text(Found[0]);
  ASSERT_FALSE(bool(Text));
  EXPECT_EQ(toString(Text.takeError()),
            "/nowhere/source/Inputs/expressions.cpp: No such file or "
            "directory");
  Files.addFolder(std::string(TP_TESTS) + "/unit/source/Inputs");
  EXPECT_TRUE(Files.line({Found[0], Line, 0}).has_value());
}
