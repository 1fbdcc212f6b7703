//===- MessageStreamTest.cpp - Framing of the protocol's messages ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/MessageStream.h"

#include "gtest/gtest.h"

#include <unistd.h>

using namespace llvm;
using namespace tp::dap;

namespace {

/// A pipe whose other end has been written and closed.
class Input {
public:
  explicit Input(StringRef Text) {
    int Ends[2];
    EXPECT_EQ(pipe(Ends), 0);
    EXPECT_EQ(write(Ends[1], Text.data(), Text.size()), ssize_t(Text.size()));
    close(Ends[1]);
    File = Ends[0];
  }
  ~Input() { close(File); }

  int File;
};

std::string errorOf(Expected<std::optional<json::Value>> Message) {
  return Message ? "none" : toString(Message.takeError());
}

TEST(MessageStream, ReadsMessagesOneAfterTheOther) {
  std::string Text = frame(json::Object{{"a", 1}}) + frame("\u00e9");
  Input Pipe(Text);
  MessageReader Reader(Pipe.File);
  Expected<std::optional<json::Value>> First = Reader.read();
  ASSERT_TRUE(bool(First));
  EXPECT_EQ(**First, json::Value(json::Object{{"a", 1}}));
  Expected<std::optional<json::Value>> Second = Reader.read();
  ASSERT_TRUE(bool(Second));
  EXPECT_EQ(**Second, json::Value("\u00e9"));
  Expected<std::optional<json::Value>> End = Reader.read();
  ASSERT_TRUE(bool(End));
  EXPECT_FALSE(End->has_value());
}

TEST(MessageStream, LengthIsInBytes) {
  EXPECT_EQ(frame("\u00e9"), "Content-Length: 4\r\n\r\n\"\u00e9\"");
}

TEST(MessageStream, OtherHeadersAreAllowed) {
  Input Pipe("Content-Type: x\r\ncontent-length:  2\r\n\r\n{}");
  Expected<std::optional<json::Value>> Message =
      MessageReader(Pipe.File).read();
  ASSERT_TRUE(bool(Message));
  EXPECT_EQ(**Message, json::Value(json::Object()));
}

TEST(MessageStream, SaysWhatIsWrong) {
  auto errorFor = [](StringRef Text) {
    Input Pipe(Text);
    return errorOf(MessageReader(Pipe.File).read());
  };
  EXPECT_EQ(errorFor("Length: 2\r\n\r\n{}"),
            "a message's header lacks 'Content-Length'");
  EXPECT_EQ(errorFor("Content-Length: -2\r\n\r\n{}"),
            "the header 'Content-Length: -2' has no length from 0 to 67108864");
  EXPECT_EQ(errorFor("Content-Length: 99999999999\r\n\r\n{}"),
            "the header 'Content-Length: 99999999999' has no length from 0 to "
            "67108864");
  EXPECT_EQ(errorFor("Content-Le"),
            "the input ends inside of a message's header");
  EXPECT_EQ(errorFor("Content-Length: 3\r\n\r\n{}"),
            "the input ends inside of a message");
  EXPECT_EQ(errorFor(std::string(5000, 'x')),
            "no empty line ends the header of a message");
  EXPECT_NE(errorFor("Content-Length: 2\r\n\r\n}{"), "none");
}

} // namespace
