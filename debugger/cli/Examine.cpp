//===- Examine.cpp - Memory by format and unit ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Examine.h"

#include "debugger/cli/Shell.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

Expected<FormatLetters> parseFormat(StringRef Text) {
  FormatLetters Result;
  StringRef Rest = Text;
  if (!Rest.empty() && isDigit(Rest.front()) &&
      (Rest.consumeInteger(10, Result.Count) || Result.Count > (1 << 20)))
    return createStringError("Count of '/" + Text + "' is too large");
  for (char Letter : Rest) {
    switch (Letter) {
    case 'b':
      Result.Unit = 1;
      break;
    case 'h':
      Result.Unit = 2;
      break;
    case 'w':
      Result.Unit = 4;
      break;
    case 'g':
      Result.Unit = 8;
      break;
    default:
      if (!StringRef("xduotacfszi").contains(Letter))
        return createStringError("Undefined output format \"" + Twine(Letter) +
                                 "\".");
      Result.Format = Letter;
    }
  }
  return Result;
}

bool isMemoryFormat(StringRef Format) {
  return Format.find_first_of("0123456789bhwgis") != StringRef::npos;
}

/// Prints the string at \p Address and moves behind it.
static llvm::Error examineString(Shell &S, uint32_t &Address) {
  std::string Text;
  uint32_t Begin = Address;
  for (uint8_t Byte;; Text += char(Byte)) {
    if (!S.context().read(Address, Byte))
      return cannotAccess(Address);
    ++Address;
    if (Byte == 0)
      break;
    if (Text.size() == S.Printing.MaxElements) {
      S.OS << S.map().describeAddress(Begin) << ":\t" << quoted(Text)
           << "...\n";
      return llvm::Error::success();
    }
  }
  S.OS << S.map().describeAddress(Begin) << ":\t" << quoted(Text) << '\n';
  return llvm::Error::success();
}

static llvm::Error examineNumbers(Shell &S, const FormatLetters &Format,
                                  uint32_t &Address) {
  unsigned PerLine = Format.Format == 't'   ? 8 / Format.Unit
                     : Format.Format == 'c' ? 8
                                            : std::min(16 / Format.Unit, 8u);
  PerLine = std::max(PerLine, 1u);
  for (uint64_t I = 0; I != Format.Count; ++I, Address += Format.Unit) {
    uint8_t Bytes[8];
    MutableArrayRef<uint8_t> Unit(Bytes, Format.Unit);
    if (!S.context().read(Address, Unit)) {
      if (I % PerLine != 0)
        S.OS << '\n';
      return cannotAccess(Address);
    }
    if (I % PerLine == 0)
      S.OS << S.map().describeAddress(Address) << ':';
    S.OS << '\t' << formatNumber(Unit, Format.Format, S.map());
    if (I % PerLine == PerLine - 1 || I + 1 == Format.Count)
      S.OS << '\n';
  }
  return llvm::Error::success();
}

llvm::Error examine(Shell &S, StringRef Text, StringRef Where) {
  FormatLetters &Last = S.LastFormat;
  Expected<FormatLetters> Parsed = parseFormat(Text);
  if (!Parsed)
    return Parsed.takeError();
  FormatLetters Format = *Parsed;
  if (Format.Format == 0)
    Format.Format = Last.Format;
  if (Format.Unit == 0)
    Format.Unit = Format.Format == 'c'                           ? 1
                  : Format.Format == 'a' || Format.Format == 'f' ? 4
                                                                 : Last.Unit;
  Last.Format = Format.Format;
  Last.Unit = Format.Unit;
  if (!Where.empty()) {
    Expected<uint32_t> Address = S.evaluateAddress(Where);
    if (!Address)
      return Address.takeError();
    S.Examined = *Address;
  }
  if (!S.Examined)
    return createStringError("Argument required (starting display address).");
  uint32_t &Address = *S.Examined;
  if (Format.Format == 'i') {
    for (uint64_t I = 0; I != Format.Count; ++I, Address += 4)
      if (llvm::Error E = S.printInstruction(Address))
        return E;
    return llvm::Error::success();
  }
  if (Format.Format != 's')
    return examineNumbers(S, Format, Address);
  for (uint64_t I = 0; I != Format.Count; ++I)
    if (llvm::Error E = examineString(S, Address))
      return E;
  return llvm::Error::success();
}

} // namespace tp
