//===- MailboxTest.cpp - Requests that wait for their turn ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Mailbox.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <future>
#include <unistd.h>

using namespace llvm;
using namespace tp::dap;
using testing::HasSubstr;

namespace {

/// A mailbox, the client's end of its input, and what it answered.
class MailboxTest : public testing::Test {
protected:
  int Ends[2];
  std::string Answers;
  raw_string_ostream OS{Answers};
  Channel Out{OS};
  std::optional<Mailbox> Box;
  std::promise<void> SawEnd;

  MailboxTest() {
    EXPECT_EQ(pipe(Ends), 0);
    Box.emplace(Ends[0], Out, [this](const Request *Next) {
      if (!Next)
        SawEnd.set_value();
    });
  }
  ~MailboxTest() override {
    close(Ends[1]);
    Box.reset();
    close(Ends[0]);
  }

  void send(int Number, StringRef Command,
            json::Value Arguments = json::Object()) {
    sendRaw(json::Object{{"type", "request"},
                         {"seq", Number},
                         {"command", Command},
                         {"arguments", std::move(Arguments)}});
  }
  void sendRaw(const json::Value &Message) {
    std::string Text = frame(Message);
    EXPECT_EQ(write(Ends[1], Text.data(), Text.size()), ssize_t(Text.size()));
  }
};

TEST_F(MailboxTest, GivesRequestsInTheirOrder) {
  send(1, "initialize");
  send(2, "threads");
  EXPECT_EQ(Box->take()->Command, "initialize");
  EXPECT_EQ(Box->take()->Number, 2);
}

TEST_F(MailboxTest, EndsWithDisconnect) {
  send(1, "disconnect");
  SawEnd.get_future().wait();
  EXPECT_EQ(Box->take()->Command, "disconnect");
  EXPECT_FALSE(Box->take().has_value());
}

TEST_F(MailboxTest, CancelsAWaitingRequest) {
  send(1, "evaluate");
  send(2, "variables");
  send(3, "cancel", json::Object{{"requestId", 2}});
  send(4, "disconnect");
  SawEnd.get_future().wait();
  EXPECT_EQ(Box->take()->Number, 1);
  EXPECT_EQ(Box->take()->Number, 3);
  EXPECT_THAT(Answers, HasSubstr(R"("request_seq":2)"));
  EXPECT_THAT(Answers, HasSubstr(R"("message":"cancelled")"));
}

TEST_F(MailboxTest, CancelsTheCurrentRequest) {
  send(1, "evaluate");
  EXPECT_EQ(Box->take()->Number, 1);
  EXPECT_FALSE(Box->currentCancelled());
  send(2, "cancel", json::Object{{"requestId", 1}});
  send(3, "disconnect");
  SawEnd.get_future().wait();
  EXPECT_TRUE(Box->currentCancelled());
  EXPECT_EQ(Box->take()->Number, 2);
  EXPECT_FALSE(Box->currentCancelled());
}

TEST_F(MailboxTest, ReportsWhatIsNoRequestAndGoesOn) {
  sendRaw(json::Object{{"type", "event"}, {"seq", 1}});
  send(2, "threads");
  EXPECT_EQ(Box->take()->Number, 2);
  EXPECT_THAT(Answers, HasSubstr("expected 'request' at message.type"));
}

} // namespace
