//===- MessageStream.cpp - Framing of the protocol's messages -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/MessageStream.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp::dap {

constexpr StringLiteral EndOfHeader = "\r\n\r\n";
/// A header without an end within this is none.
constexpr size_t MaxHeaderBytes = 4096;

/// The value of `Content-Length` in \p Header.
static Expected<size_t> contentLength(StringRef Header) {
  for (StringRef Line : split(Header, "\r\n")) {
    auto [Name, Value] = Line.split(':');
    if (!Name.equals_insensitive("Content-Length"))
      continue;
    size_t Length;
    if (!Value.trim().getAsInteger(10, Length) && Length <= MaxMessageBytes)
      return Length;
    return createStringError("the header 'Content-Length:" + Value +
                             "' has no length from 0 to " +
                             Twine(MaxMessageBytes));
  }
  return createStringError("a message's header lacks 'Content-Length'");
}

Expected<bool> MessageReader::fill() {
  char Chunk[4096];
  Expected<size_t> Bytes = sys::fs::readNativeFile(File, Chunk);
  if (!Bytes)
    return Bytes.takeError();
  Buffer.append(Chunk, *Bytes);
  return *Bytes != 0;
}

Expected<std::optional<json::Value>> MessageReader::read() {
  size_t HeaderEnd;
  while ((HeaderEnd = Buffer.find(EndOfHeader.data())) == std::string::npos) {
    if (Buffer.size() > MaxHeaderBytes)
      return createStringError("no empty line ends the header of a message");
    Expected<bool> More = fill();
    if (!More)
      return More.takeError();
    if (*More)
      continue;
    if (Buffer.empty())
      return std::nullopt;
    return createStringError("the input ends inside of a message's header");
  }

  Expected<size_t> Length =
      contentLength(StringRef(Buffer).take_front(HeaderEnd));
  if (!Length)
    return Length.takeError();
  Buffer.erase(0, HeaderEnd + EndOfHeader.size());
  while (Buffer.size() < *Length) {
    Expected<bool> More = fill();
    if (!More)
      return More.takeError();
    if (!*More)
      return createStringError("the input ends inside of a message");
  }

  std::string Body = Buffer.substr(0, *Length);
  Buffer.erase(0, *Length);
  Expected<json::Value> Message = json::parse(Body);
  if (!Message)
    return Message.takeError();
  return std::move(*Message);
}

std::string frame(const json::Value &Message) {
  std::string Body;
  raw_string_ostream(Body) << Message;
  return "Content-Length: " + utostr(Body.size()) + EndOfHeader.str() + Body;
}

} // namespace tp::dap
