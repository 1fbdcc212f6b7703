//===- Mailbox.cpp - Requests that wait for their turn --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Mailbox.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp::dap {

Mailbox::Mailbox(sys::fs::file_t Input, Channel &Out, Arrival Arrived)
    : Reader(Input), Out(Out), Arrived(std::move(Arrived)),
      Thread([this] { readAll(); }) {}

Mailbox::~Mailbox() { Thread.join(); }

std::optional<Request> Mailbox::take() {
  std::unique_lock Lock(Mutex);
  Change.wait(Lock, [this] { return Ended || !Queue.empty(); });
  Current.reset();
  Cancelled = false;
  if (Queue.empty())
    return std::nullopt;
  Request Next = std::move(Queue.front());
  Queue.pop_front();
  Current = Next.Number;
  return Next;
}

bool Mailbox::waiting() {
  std::lock_guard Lock(Mutex);
  return Ended || !Queue.empty();
}

void Mailbox::announceWaiting() {
  std::lock_guard Lock(Mutex);
  for (const Request &Waiting : Queue)
    Arrived(&Waiting);
  if (Ended)
    Arrived(nullptr);
}

bool Mailbox::currentCancelled() {
  std::lock_guard Lock(Mutex);
  return Cancelled;
}

void Mailbox::readAll() {
  bool More = true;
  while (More) {
    Expected<std::optional<json::Value>> Message = Reader.read();
    if (!Message) {
      Out.output("important", "tpdbg: cannot read the client's message: " +
                                  toString(Message.takeError()) + "\n");
      break;
    }
    const std::optional<json::Value> &Next = *Message;
    More = Next.has_value() && accept(*Next);
  }
  {
    std::lock_guard Lock(Mutex);
    Ended = true;
  }
  Arrived(nullptr);
  Change.notify_one();
}

/// Queues the request in \p Message. False after the last one.
bool Mailbox::accept(const json::Value &Message) {
  Request Next;
  json::Path::Root Root("message");
  if (!fromJSON(Message, Next, Root)) {
    Out.output("important", "tpdbg: the client's message is no request: " +
                                toString(Root.getError()) + "\n");
    return true;
  }
  bool Last = Next.Command == "disconnect";
  if (Next.Command == "cancel")
    cancel(Next);
  Request Copy = Next;
  {
    std::lock_guard Lock(Mutex);
    Queue.push_back(std::move(Next));
  }
  Arrived(&Copy);
  Change.notify_one();
  return !Last;
}

void Mailbox::cancel(const Request &Wish) {
  std::optional<int64_t> Number =
      Wish.Arguments.getAsObject()
          ? Wish.Arguments.getAsObject()->getInteger("requestId")
          : std::nullopt;
  if (!Number)
    return;
  std::lock_guard Lock(Mutex);
  if (Current == Number)
    Cancelled = true;
  auto Waiting = find_if(
      Queue, [&](const Request &Queued) { return Queued.Number == *Number; });
  if (Waiting == Queue.end())
    return;
  Out.fail(*Waiting, "cancelled", "the client cancelled this request");
  Queue.erase(Waiting);
}

} // namespace tp::dap
