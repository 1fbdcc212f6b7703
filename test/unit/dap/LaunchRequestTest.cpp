//===- LaunchRequestTest.cpp - What a launch configuration asks for -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/LaunchRequest.h"

#include "llvm/ADT/StringExtras.h"
#include "gtest/gtest.h"

using namespace llvm;
using namespace tp::dap;

namespace {

LaunchRequest launch(StringRef Text) {
  Expected<json::Value> Arguments = json::parse(Text);
  EXPECT_TRUE(bool(Arguments));
  Expected<LaunchRequest> Request = readLaunch(*Arguments);
  if (Request)
    return *Request;
  ADD_FAILURE() << toString(Request.takeError());
  return {};
}

std::string commandLine(StringRef Text) {
  return join(launch(Text).CommandLine, " ");
}

std::string errorFor(StringRef Text) {
  Expected<json::Value> Arguments = json::parse(Text);
  EXPECT_TRUE(bool(Arguments));
  Expected<LaunchRequest> Request = readLaunch(*Arguments);
  return Request ? "none" : toString(Request.takeError());
}

TEST(LaunchRequest, AttributesAreOptions) {
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "chip": "1x1"})"),
            "--chip 1x1 a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "hostThreads": 2})"),
            "--host-threads 2 a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "max-cycles": 20000000000})"),
            "--max-cycles 20000000000 a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "functional": true})"),
            "--functional a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "functional": false})"),
            "a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "o": "a.png"})"),
            "-o a.png a.elf");
}

TEST(LaunchRequest, SeveralValuesRepeatTheOption) {
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "set": ["a=1", "b=2"]})"),
            "--set a=1 --set b=2 a.elf");
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "set": {"b": "x", "a": 1}})"),
            "--set a=1 --set b=x a.elf");
}

TEST(LaunchRequest, ArgumentsOfTheProgramComeLast) {
  EXPECT_EQ(commandLine(R"({"args": ["-x", 7], "program": "a.elf"})"),
            "a.elf -- -x 7");
}

TEST(LaunchRequest, EditorsMayKeepAttributesOfTheirOwn) {
  EXPECT_EQ(commandLine(R"({"program": "a.elf", "type": "tp", "name": "n",
                            "request": "launch", "__sessionId": "1"})"),
            "a.elf");
}

TEST(LaunchRequest, AttributesOfTheAdapter) {
  LaunchRequest Request = launch(R"({"program": "a.elf", "cwd": "folder",
      "stopOnEntry": true, "noDebug": true, "sourceMap": {"old": "new"}})");
  EXPECT_EQ(Request.Folder, "folder");
  EXPECT_TRUE(Request.StopOnEntry);
  EXPECT_TRUE(Request.NoDebug);
  ASSERT_EQ(Request.SourceMap.size(), 1u);
  EXPECT_EQ(Request.SourceMap[0],
            std::make_pair(std::string("old"), std::string("new")));
}

TEST(LaunchRequest, SaysWhatIsWrong) {
  EXPECT_EQ(errorFor("3"), "launch: expected an object as arguments");
  EXPECT_EQ(errorFor("{}"), "launch configuration: 'program' is missing; give "
                            "the executable that tpcc linked");
  EXPECT_EQ(errorFor(R"({"program": 3})"),
            "launch configuration: 'program': expected a string");
  EXPECT_EQ(errorFor(R"({"program": "a", "stopOnEntry": 1})"),
            "launch configuration: 'stopOnEntry': expected true or false");
  EXPECT_EQ(errorFor(R"({"program": "a", "args": [[]]})"),
            "launch configuration: 'args': expected a list of strings");
  EXPECT_EQ(errorFor(R"({"program": "a", "chip": null})"),
            "launch configuration: 'chip': expected a string, a number, true, "
            "false, a list or an object");
}

} // namespace
