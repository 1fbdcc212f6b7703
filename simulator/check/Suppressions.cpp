//===- Suppressions.cpp - Reports that the user does not want -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/Suppressions.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/LineIterator.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/StringSaver.h"

using namespace llvm;

namespace tp {

/// \p Pattern with only `*` and `?` standing for others.
static std::string withoutOtherWildcards(StringRef Pattern) {
  std::string Result;
  for (char Letter : Pattern) {
    if (Letter == '[' || Letter == ']' || Letter == '\\')
      Result += '\\';
    Result += Letter;
  }
  return Result;
}

Expected<Suppressions> Suppressions::read(StringRef Path) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> File =
      MemoryBuffer::getFile(Path, /*IsText=*/true);
  if (!File)
    return createStringError("cannot read " + Path + ": " +
                             File.getError().message());
  Suppressions Result;
  StringSaver Texts(*Result.Texts);
  for (line_iterator Line(**File, /*SkipBlanks=*/true, '#'); !Line.is_at_end();
       ++Line) {
    if (Line->trim().empty())
      continue;
    auto [Check, Function] = Line->trim().split(':');
    std::string Place = (Path + ":" + Twine(Line.line_number())).str();
    if (Check != "*" && !is_contained(CheckerNames, Check))
      return createStringError(
          Place + ": '" + Check +
          "' is no checker; expected <checker>:<function> with " +
          join(std::begin(CheckerNames), std::end(CheckerNames), ", ") +
          " or *");
    if (Function.empty())
      return createStringError(Place + ": expected <checker>:<function>");
    Expected<GlobPattern> Pattern =
        GlobPattern::create(Texts.save(withoutOtherWildcards(Function)));
    if (!Pattern)
      return createStringError(Place + ": " + toString(Pattern.takeError()));
    Result.Rules.push_back({Check.str(), std::move(*Pattern)});
  }
  return Result;
}

/// Without the arguments, if it ends in some.
static StringRef withoutArguments(StringRef Function) {
  StringRef Rest = Function;
  Rest.consume_back(" const");
  if (!Rest.ends_with(")"))
    return Function;
  unsigned Open = 0;
  for (size_t I = Rest.size(); I != 0; --I) {
    Open += Rest[I - 1] == ')';
    Open -= Rest[I - 1] == '(';
    if (Open == 0)
      return Rest.take_front(I - 1);
  }
  return Function;
}

bool Suppressions::covers(StringRef Check, StringRef Function) const {
  StringRef Name = withoutArguments(Function);
  return any_of(Rules, [&](const Rule &R) {
    return (R.Check == "*" || R.Check == Check) &&
           (R.Function.match(Function) || R.Function.match(Name));
  });
}

} // namespace tp
