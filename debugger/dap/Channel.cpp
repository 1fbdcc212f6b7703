//===- Channel.cpp - What the adapter tells its client --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Channel.h"

#include "debugger/dap/MessageStream.h"

using namespace llvm;

namespace tp::dap {

bool fromJSON(const json::Value &Value, Request &Request, json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  std::string Type;
  if (!Mapper || !Mapper.map("type", Type) ||
      !Mapper.map("seq", Request.Number))
    return false;
  if (Type != "request") {
    Path.field("type").report("expected 'request'");
    return false;
  }
  if (const json::Value *Arguments = Value.getAsObject()->get("arguments"))
    if (!Arguments->getAsNull())
      Request.Arguments = *Arguments;
  return Mapper.map("command", Request.Command);
}

void Channel::send(json::Object Message) {
  std::lock_guard Lock(Mutex);
  Message["seq"] = NextNumber++;
  OS << frame(std::move(Message));
  OS.flush();
}

void Channel::event(StringRef Name, json::Value Body) {
  send(json::Object{
      {"type", "event"}, {"event", Name}, {"body", std::move(Body)}});
}

void Channel::succeed(const Request &To, json::Value Body) {
  send(json::Object{{"type", "response"},
                    {"request_seq", To.Number},
                    {"success", true},
                    {"command", To.Command},
                    {"body", std::move(Body)}});
}

void Channel::fail(const Request &To, StringRef Short, const Twine &Text) {
  json::Object Problem{
      {"id", 1}, {"format", json::fixUTF8(Text.str())}, {"showUser", true}};
  send(json::Object{{"type", "response"},
                    {"request_seq", To.Number},
                    {"success", false},
                    {"command", To.Command},
                    {"message", json::fixUTF8(Short)},
                    {"body", json::Object{{"error", std::move(Problem)}}}});
}

void Channel::fail(const Request &To, Error Problem) {
  std::string Text = toString(std::move(Problem));
  fail(To, Text, Text);
}

void Channel::output(StringRef Category, StringRef Text) {
  event("output",
        json::Object{{"category", Category}, {"output", json::fixUTF8(Text)}});
}

} // namespace tp::dap
