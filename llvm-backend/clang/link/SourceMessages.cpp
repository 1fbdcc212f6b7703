//===- SourceMessages.cpp - Messages about places in the source -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/SourceMessages.h"
#include "llvm/Support/LineIterator.h"
#include "llvm/Support/MemoryBuffer.h"
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

void SourceMessages::print(SourceMgr::DiagKind Kind, const SourcePlace &Place,
                           const Twine &Message) {
  const SourceMgr Sources;
  const StringRef Line = lineAt(Place);
  const bool HasCaret = Place.Column != 0 && Place.Column <= Line.size() + 1;
  // SMDiagnostic counts columns from 0 and prints them from 1; it has no line
  // without a column.
  SMDiagnostic(Sources, SMLoc(), Place.File.empty() ? "<program>" : Place.File,
               Place.Line, static_cast<int>(Place.Column) - 1, Kind,
               Message.str(), HasCaret ? Line : StringRef(), {})
      .print(/*ProgName=*/nullptr, errs());
}

} // namespace tp
