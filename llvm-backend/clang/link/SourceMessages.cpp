//===- SourceMessages.cpp - Messages about places in the source -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/SourceMessages.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/LineIterator.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/WithColor.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp {

StringRef SourceMessages::lineAt(const SourcePlace &Place) {
  auto [Known, IsNew] = Files.try_emplace(Place.File);
  if (IsNew)
    if (auto Buffer = MemoryBuffer::getFile(Place.File, /*IsText=*/true))
      Known->second = std::move(*Buffer);
  if (!Known->second)
    return {};
  line_iterator Line(*Known->second, /*SkipBlanks=*/false);
  while (!Line.is_at_end() && Line.line_number() < Place.Line)
    ++Line;
  return Line.is_at_end() ? StringRef() : *Line;
}

// The line and a caret under the place, as clang shows them.
static void printLine(StringRef Line, const SourcePlace &Place) {
  constexpr unsigned NumberWidth = 5;
  std::string Indentation;
  for (char C : Line.take_front(Place.Column - 1))
    Indentation += C == '\t' ? '\t' : ' ';
  errs() << right_justify(std::to_string(Place.Line), NumberWidth) << " | "
         << Line << '\n'
         << right_justify("", NumberWidth) << " | " << Indentation;
  WithColor(errs(), raw_ostream::GREEN, /*Bold=*/true) << '^';
  errs() << '\n';
}

static raw_ostream &printKind(SourceMgr::DiagKind Kind) {
  switch (Kind) {
  case SourceMgr::DK_Error:
    return WithColor::error(errs());
  case SourceMgr::DK_Warning:
    return WithColor::warning(errs());
  case SourceMgr::DK_Remark:
    return WithColor::remark(errs());
  case SourceMgr::DK_Note:
    return WithColor::note(errs());
  }
  return errs();
}

void SourceMessages::print(SourceMgr::DiagKind Kind, const SourcePlace &Place,
                           const Twine &Message) {
  errs() << (Place.File.empty() ? StringRef("<program>") : Place.File) << ':';
  if (Place.Line != 0)
    errs() << Place.Line << ':';
  if (Place.Column != 0)
    errs() << Place.Column << ':';
  errs() << ' ';
  printKind(Kind) << Message << '\n';
  const StringRef Line = lineAt(Place);
  if (Place.Column != 0 && Place.Column <= Line.size() + 1)
    printLine(Line, Place);
}

} // namespace tp
