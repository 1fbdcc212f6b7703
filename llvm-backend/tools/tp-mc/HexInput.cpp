//===- HexInput.cpp - Bytes written as hexadecimal text -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-mc/HexInput.h"
#include "llvm/Support/SourceMgr.h"

using namespace llvm;

namespace tp {

bool parseHexBytes(StringRef Text, const SourceMgr &Sources, HexBytes &Bytes) {
  constexpr StringLiteral Separators = " \t\r\n,[]";
  bool Good = true;
  while (true) {
    Text = Text.ltrim(Separators);
    if (Text.empty())
      return Good;
    if (Text.front() == '#') {
      Text = Text.drop_until([](char C) { return C == '\n'; });
      continue;
    }
    StringRef Token = Text.substr(0, Text.find_if([&](char C) {
      return Separators.contains(C) || C == '#';
    }));
    Text = Text.drop_front(Token.size());
    StringRef Digits = Token;
    Digits.consume_front_insensitive("0x");
    uint8_t Value;
    if (Digits.size() > 2 || Digits.getAsInteger(16, Value)) {
      Sources.PrintMessage(SMLoc::getFromPointer(Token.begin()),
                           SourceMgr::DK_Error,
                           "'" + Token + "' is not a byte in hexadecimal");
      Good = false;
      continue;
    }
    Bytes.Values.push_back(Value);
    Bytes.Places.push_back(Token.data());
  }
}

} // namespace tp
