//===- YamlSection.cpp - Checked access to a mapping ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/YamlSection.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/raw_ostream.h"

#include <algorithm>
#include <cmath>
#include <optional>

using namespace llvm;

namespace tp {

void YamlErrors::add(unsigned Line, const Twine &What) {
  Found.emplace(Line, (Place(Line) + ": " + What).str());
}

Error YamlErrors::take() {
  if (Found.empty())
    return Error::success();
  std::string All;
  for (const auto &[Line, Message] : Found) {
    if (!All.empty())
      All += '\n';
    All += Message;
  }
  return createStringError(All);
}

YamlSection::YamlSection(YamlErrors &Errors, const YamlValue &Mapping,
                         unsigned Line, std::string Path, bool Absent)
    : Errors(Errors), Mapping(Mapping), Line(Line), Path(std::move(Path)),
      Absent(Absent) {}

std::string YamlSection::pathOf(StringRef Key) const {
  return Path.empty() ? Key.str() : Path + "." + Key.str();
}

const YamlEntry *YamlSection::find(StringRef Key) const {
  for (const YamlEntry &Entry : Mapping.Entries)
    if (Entry.Key == Key)
      return &Entry;
  return nullptr;
}

unsigned YamlSection::lineOf(StringRef Key) const {
  const YamlEntry *Entry = find(Key);
  return Entry ? Entry->Value.Line : Line;
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
  Allowed.push_back(Key.str());
  const YamlEntry *Entry = find(Key);
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

uint64_t YamlSection::integer(StringRef Key, uint64_t Min, uint64_t Max,
                              uint64_t Default, Presence P) {
  std::string Wanted =
      "a whole number from " + utostr(Min) + " to " + utostr(Max);
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Default;
  uint64_t Value;
  if (StringRef(Entry->Value.Text).getAsInteger(10, Value) || Value < Min ||
      Value > Max) {
    bad(*Entry, Wanted);
    return Default;
  }
  return Value;
}

/// Reads `<number>` or `<number> KiB|MiB|GiB`.
static std::optional<uint64_t> parseBytes(StringRef Text) {
  unsigned Shift = 0;
  if (Text.consume_back("KiB"))
    Shift = 10;
  else if (Text.consume_back("MiB"))
    Shift = 20;
  else if (Text.consume_back("GiB"))
    Shift = 30;
  uint64_t Value;
  if (Text.rtrim(' ').getAsInteger(10, Value) || Value > (UINT64_MAX >> Shift))
    return std::nullopt;
  return Value << Shift;
}

uint64_t YamlSection::bytes(StringRef Key, uint64_t Min, uint64_t Max,
                            uint64_t Multiple, Presence P) {
  std::string Wanted = "a number of bytes from " + utostr(Min) + " to " +
                       utostr(Max) + " (KiB, MiB and GiB may follow it)";
  if (Multiple > 1)
    Wanted += ", a multiple of " + utostr(Multiple);
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Min;
  std::optional<uint64_t> Value = parseBytes(Entry->Value.Text);
  if (!Value || *Value < Min || *Value > Max || *Value % Multiple != 0) {
    bad(*Entry, Wanted);
    return Min;
  }
  return *Value;
}

double YamlSection::number(StringRef Key, double Min, double Max,
                           double Default, Presence P) {
  std::string Wanted;
  raw_string_ostream(Wanted)
      << "a number from " << format("%g", Min) << " to " << format("%g", Max);
  const YamlEntry *Entry = scalar(Key, Wanted, P);
  if (!Entry)
    return Default;
  double Value;
  if (StringRef(Entry->Value.Text).getAsDouble(Value) ||
      !std::isfinite(Value) || Value < Min || Value > Max) {
    bad(*Entry, Wanted);
    return Default;
  }
  return Value;
}

bool YamlSection::boolean(StringRef Key, bool Default) {
  const char *Wanted = "true or false";
  const YamlEntry *Entry = scalar(Key, Wanted, Presence::Optional);
  if (!Entry)
    return Default;
  if (Entry->Value.Text != "true" && Entry->Value.Text != "false") {
    bad(*Entry, Wanted);
    return Default;
  }
  return Entry->Value.Text == "true";
}

std::string YamlSection::text(StringRef Key) {
  const YamlEntry *Entry = scalar(Key, "a text", Presence::Optional);
  return Entry ? Entry->Value.Text : "";
}

YamlSection YamlSection::section(StringRef Key, Presence P) {
  static const YamlValue Empty = [] {
    YamlValue Value;
    Value.Is = YamlValue::Kind::Mapping;
    return Value;
  }();
  Allowed.push_back(Key.str());
  const YamlEntry *Entry = find(Key);
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
