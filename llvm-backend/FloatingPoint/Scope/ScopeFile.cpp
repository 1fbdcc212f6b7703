//===- ScopeFile.cpp - Which instructions keep fast math ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Scope/ScopeFile.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/LineIterator.h"
#include "llvm/Support/MemoryBuffer.h"

using namespace llvm;

static constexpr StringRef Any = "*";

void ScopeSelection::add(unsigned First, unsigned Last) {
  Ranges.push_back({First, Last});
}

void ScopeSelection::add(const ScopeSelection &Other) {
  IsAll |= Other.IsAll;
  append_range(Ranges, Other.Ranges);
}

bool ScopeSelection::contains(unsigned Item) const {
  return IsAll || any_of(Ranges, [&](std::pair<unsigned, unsigned> Range) {
           return Range.first <= Item && Item <= Range.second;
         });
}

static Expected<ScopeSelection> parseItems(StringRef Text) {
  ScopeSelection Items;
  if (Text == Any) {
    Items.addAll();
    return Items;
  }
  for (StringRef Range : split(Text, ',')) {
    auto [First, Last] = Range.split('-');
    unsigned Begin, End;
    if (First.getAsInteger(10, Begin) ||
        (Last.empty() ? Range.contains('-') : Last.getAsInteger(10, End)))
      return createStringError("'" + Text +
                               "' are no items; write * or, for example, "
                               "0,3-5");
    Items.add(Begin, Last.empty() ? Begin : End);
  }
  return Items;
}

Expected<ScopeFile::Line> ScopeFile::parseLine(StringRef Text) {
  SmallVector<StringRef, 3> Fields;
  Text.split(Fields, '\t');
  if (Fields.size() != 3)
    return createStringError("expected source file, function and items, "
                             "separated by tabs");
  Expected<ScopeSelection> Items = parseItems(Fields[2]);
  if (!Items)
    return Items.takeError();
  return Line{Fields[0].str(), Fields[1].str(), std::move(*Items)};
}

Expected<ScopeFile> ScopeFile::read(StringRef Path) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer =
      MemoryBuffer::getFile(Path, /*IsText=*/true);
  if (!Buffer)
    return createStringError("cannot read the scope file '" + Path +
                             "': " + Buffer.getError().message());
  ScopeFile Result;
  for (line_iterator Text(**Buffer, /*SkipBlanks=*/true, '#');
       !Text.is_at_end(); ++Text) {
    Expected<Line> Parsed = parseLine(*Text);
    if (!Parsed)
      return createStringError(Path + ":" + Twine(Text.line_number()) + ": " +
                               toString(Parsed.takeError()));
    Result.Lines.push_back(std::move(*Parsed));
  }
  return Result;
}

ScopeFile ScopeFile::everything() {
  ScopeFile Result;
  Result.Lines.push_back({Any.str(), Any.str(), {}});
  Result.Lines.back().Items.addAll();
  return Result;
}

ScopeSelection ScopeFile::select(StringRef Source, StringRef Function) const {
  ScopeSelection Selected;
  auto Matches = [](StringRef Pattern, StringRef Name) {
    return Pattern == Any || Pattern == Name;
  };
  for (const Line &Entry : Lines)
    if (Matches(Entry.Source, Source) && Matches(Entry.Function, Function))
      Selected.add(Entry.Items);
  return Selected;
}
