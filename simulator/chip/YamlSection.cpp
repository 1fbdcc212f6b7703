//===- YamlSection.cpp - Checked access to a mapping ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/YamlSection.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MathExtras.h"
#include "llvm/Support/raw_ostream.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace llvm;

namespace tp {

std::string YamlPlaces::of(unsigned Line) const {
  const Place &P = Places[Line / LinesEach];
  return P.HasLines ? P.Name + ":" + utostr(Line % LinesEach) : P.Name;
}

Error YamlErrors::take(const YamlPlaces &Places) {
  if (Found.empty())
    return Error::success();
  std::string All;
  for (const auto &[Line, Message] : Found)
    All += (All.empty() ? "" : "\n") + Places.of(Line) + ": " + Message;
  return createStringError(All);
}

YamlSection::YamlSection(YamlErrors &Errors, const YamlValue &Mapping,
                         unsigned Line, std::string Path, bool Absent)
    : Errors(Errors), Mapping(Mapping), Line(Line), Path(std::move(Path)),
      Absent(Absent) {}

std::string YamlSection::pathOf(StringRef Key) const {
  return Path.empty() ? Key.str() : Path + "." + Key.str();
}

void YamlSection::allow(StringRef Key) {
  if (!is_contained(Allowed, Key))
    Allowed.push_back(Key.str());
}

bool YamlSection::has(StringRef Key) {
  allow(Key);
  return Mapping.find(Key) != nullptr;
}

void YamlSection::missing(StringRef Key, const Twine &Wanted) {
  if (!Absent)
    Errors.add(Line, "key '" + pathOf(Key) + "' is missing; give it " + Wanted);
}

void YamlSection::bad(const YamlEntry &Entry, const Twine &Wanted) {
  std::string Got = "'" + Entry.Value.Text + "'";
  if (Entry.Value.Is == YamlValue::Kind::Mapping)
    Got = "a section";
  else if (Entry.Value.Is == YamlValue::Kind::Sequence)
    Got = "a list";
  else if (Entry.Value.Text.empty())
    Got = "nothing";
  Errors.add(Entry.Value.Line,
             "'" + pathOf(Entry.Key) + "' is " + Got + "; give it " + Wanted);
}

const YamlEntry *YamlSection::scalar(StringRef Key, const Twine &Wanted,
                                     Presence P) {
  allow(Key);
  const YamlEntry *Entry = Mapping.find(Key);
  if (!Entry) {
    if (P == Presence::Required)
      missing(Key, Wanted);
    return nullptr;
  }
  if (Entry->Value.Is != YamlValue::Kind::Scalar) {
    bad(*Entry, Wanted);
    return nullptr;
  }
  return Entry;
}

/// Reads `<number>` and, of bytes, `<number> KiB|MiB|GiB`.
static std::optional<uint64_t> parseInteger(StringRef Text, bool IsBytes) {
  unsigned Shift = 0;
  if (IsBytes && Text.consume_back("KiB"))
    Shift = 10;
  else if (IsBytes && Text.consume_back("MiB"))
    Shift = 20;
  else if (IsBytes && Text.consume_back("GiB"))
    Shift = 30;
  if (Shift)
    Text = Text.rtrim(' ');
  uint64_t Value;
  if (Text.getAsInteger(10, Value) || Value > (UINT64_MAX >> Shift))
    return std::nullopt;
  return Value << Shift;
}

uint64_t YamlSection::integer(StringRef Key, const IntegerRange &Range,
                              uint64_t Default, Presence P) {
  std::string Wanted = rangeText(Range);
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Default;
  std::optional<uint64_t> Value =
      parseInteger(Entry->Value.Text, Range.IsBytes);
  if (!Value || *Value < Range.Min || *Value > Range.Max ||
      *Value % Range.Multiple != 0 ||
      (Range.PowerOfTwo && !isPowerOf2_64(*Value))) {
    bad(*Entry, Wanted);
    return Default;
  }
  return *Value;
}

double YamlSection::number(StringRef Key, const NumberRange &Range,
                           double Default, Presence P) {
  std::string Wanted = rangeText(Range);
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Default;
  double Value;
  if (StringRef(Entry->Value.Text).getAsDouble(Value) ||
      !std::isfinite(Value) || Value < Range.Min || Value > Range.Max) {
    bad(*Entry, Wanted);
    return Default;
  }
  return Value;
}

unsigned YamlSection::choice(StringRef Key, ArrayRef<StringRef> Names,
                             unsigned Default, Presence P) {
  std::string Wanted = join(Names, " or ");
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Default;
  const StringRef *Name = find(Names, Entry->Value.Text);
  if (Name == Names.end()) {
    bad(*Entry, Wanted);
    return Default;
  }
  return unsigned(Name - Names.begin());
}

std::string YamlSection::text(StringRef Key, Presence P) {
  const YamlEntry *Entry = scalar(Key, "a text", P);
  if (Entry && P == Presence::Required && Entry->Value.Text.empty())
    bad(*Entry, "a text");
  return Entry ? Entry->Value.Text : "";
}

YamlSection YamlSection::section(StringRef Key, Presence P) {
  static const YamlValue Empty = [] {
    YamlValue Value;
    Value.Is = YamlValue::Kind::Mapping;
    return Value;
  }();
  allow(Key);
  const YamlEntry *Entry = Mapping.find(Key);
  if (!Entry) {
    if (P == Presence::Required)
      missing(Key, "a section of `key: value` lines");
    return YamlSection(Errors, Empty, Line, pathOf(Key), /*Absent=*/true);
  }
  if (Entry->Value.Is != YamlValue::Kind::Mapping) {
    bad(*Entry, "a section of `key: value` lines");
    return YamlSection(Errors, Empty, Entry->Line, pathOf(Key),
                       /*Absent=*/true);
  }
  return YamlSection(Errors, Entry->Value, Entry->Line, pathOf(Key));
}

void YamlSection::exclude(StringRef Key, StringRef Other) {
  allow(Key);
  if (const YamlEntry *Entry = Mapping.find(Key))
    Errors.add(Entry->Value.Line, "'" + pathOf(Key) +
                                      "' does nothing on a chip with " + Other +
                                      "; leave one of them out");
}

void YamlSection::finish() {
  for (const YamlEntry &Entry : Mapping.Entries) {
    if (is_contained(Allowed, Entry.Key))
      continue;
    StringRef Nearest;
    unsigned NearestDistance = 1 + Entry.Key.size() / 3;
    for (const std::string &Key : Allowed) {
      unsigned Distance =
          StringRef(StringRef(Entry.Key).lower())
              .edit_distance(StringRef(Key).lower(), true, NearestDistance);
      if (Distance <= NearestDistance &&
          (Nearest.empty() || Distance < NearestDistance)) {
        Nearest = Key;
        NearestDistance = Distance;
      }
    }
    std::string Cure =
        Nearest.empty() ? "" : "; did you mean '" + Nearest.str() + "'?";
    Errors.add(Entry.Line, "unknown key '" + pathOf(Entry.Key) + "'" + Cure +
                               " (allowed here: " + join(Allowed, ", ") + ")");
  }
}

} // namespace tp
