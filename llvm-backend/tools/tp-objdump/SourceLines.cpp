//===- SourceLines.cpp - Source lines of instructions ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/tools/tp-objdump/SourceLines.h"
#include "llvm/Support/LineIterator.h"

using namespace llvm;

namespace tp {

static symbolize::LLVMSymbolizer::Options symbolizerOptions() {
  symbolize::LLVMSymbolizer::Options Options;
  // The symbols of an object are not laid out as its debugging information is.
  Options.UseSymbolTable = false;
  return Options;
}

SourceLines::SourceLines(const ObjectInput &Input, bool LineNumbers, bool Text)
    : LineNumbers(LineNumbers), Text(Text), Image(Input),
      Symbolizer(symbolizerOptions()) {}

StringRef SourceLines::textOf(const std::string &FileName, uint32_t Line) {
  auto [Entry, IsNew] = Files.try_emplace(FileName);
  if (IsNew)
    if (auto Buffer = MemoryBuffer::getFile(FileName))
      Entry->second = std::move(*Buffer);
  if (!Entry->second)
    return "";
  line_iterator Lines(*Entry->second, /*SkipBlanks=*/false);
  while (!Lines.is_at_end() && Lines.line_number() != Line)
    ++Lines;
  return Lines.is_at_end() ? "" : *Lines;
}

void SourceLines::print(const Section &Section, uint32_t Address,
                        raw_ostream &OS) {
  if (!LineNumbers && !Text)
    return;
  Expected<DILineInfo> Place = Symbolizer.symbolizeCode(
      Image.file(), {Image.addressOf(Section, Address), Section.Index});
  if (!Place) {
    consumeError(Place.takeError());
    return;
  }
  bool IsNewFunction = Place->FunctionName != Last.FunctionName;
  if (!*Place || Place->Line == 0 ||
      (!IsNewFunction && Place->Line == Last.Line &&
       Place->FileName == Last.FileName))
    return;
  if (LineNumbers) {
    if (IsNewFunction)
      OS << "; " << Place->FunctionName << ":\n";
    OS << "; " << Place->FileName << ':' << Place->Line << '\n';
  }
  if (Text) {
    StringRef Line = textOf(Place->FileName, Place->Line);
    if (!Line.empty())
      OS << "; " << Line << '\n';
  }
  Last = *Place;
}

} // namespace tp
