//===- ChipSettings.cpp - A chip with some other values -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipSettings.h"

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipReader.h"
#include "simulator/chip/SchemaPaths.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {
/// Letters to change in \p Wanted to make \p Path of it, where \p Wanted may be
/// the beginning or the end of the path, and have underscores for its dots.
static unsigned distance(StringRef Wanted, StringRef Path) {
  auto Plain = [](StringRef Text) {
    std::string Lower = Text.lower();
    replace(Lower, '.', '_');
    return Lower;
  };
  std::string Given = Plain(Wanted);
  // What is left out is worse than nothing wrong.
  unsigned Nearest =
      StringRef(Given).edit_distance(Plain(Path.substr(0, Wanted.size()))) +
      (Wanted.size() < Path.size() ? 1 : 0);
  for (StringRef End = Path; !End.empty(); End = End.split('.').second)
    Nearest = std::min(Nearest, StringRef(Given).edit_distance(Plain(End)));
  return Nearest;
}

/// What to write instead of the unknown or incomplete \p Wanted.
static std::string cureFor(StringRef Wanted, ArrayRef<SchemaPath> Paths) {
  std::string Section = Wanted.str() + ".";
  std::vector<std::string> Keys;
  for (const SchemaPath &P : Paths) {
    StringRef Rest = P.Text;
    if (!Rest.consume_front(Section))
      continue;
    std::string Key = Section + Rest.split('.').first.str();
    if (!is_contained(Keys, Key))
      Keys.push_back(Key);
  }
  if (!Keys.empty())
    return "is a section with " + join(Keys, ", ");
  const SchemaPath *Nearest = nullptr;
  for (const SchemaPath &P : Paths)
    if (!P.IsSection && (!Nearest || distance(Wanted, P.Text) <
                                         distance(Wanted, Nearest->Text)))
      Nearest = &P;
  return "is no key of a chip; did you mean '" + Nearest->Text +
         "'? (--print-chip-schema lists all)";
}

/// The entry at \p Path, which the schema has; made if the chip lacks it.
static YamlEntry &makeEntry(YamlValue &Mapping, StringRef Path, unsigned Line) {
  auto [Key, Rest] = Path.split('.');
  YamlEntry *Entry = Mapping.find(Key);
  if (!Entry) {
    Mapping.Entries.push_back({Key.str(), Line, {}});
    Entry = &Mapping.Entries.back();
    Entry->Value.Line = Line;
  }
  if (Rest.empty())
    return *Entry;
  Entry->Value.Is = YamlValue::Kind::Mapping;
  return makeEntry(Entry->Value, Rest, Line);
}

static void removeEntry(YamlValue &Mapping, StringRef Path) {
  auto [Parent, Key] = Path.rsplit('.');
  YamlEntry *Entry = Key.empty() ? nullptr : findPath(Mapping, Parent);
  if (!Key.empty() && !Entry)
    return;
  YamlValue &Section = Entry ? Entry->Value : Mapping;
  erase_if(Section.Entries, [Key = Key.empty() ? Parent : Key](
                                const YamlEntry &E) { return E.Key == Key; });
}

Expected<ChipConfig> withSettings(const ChipConfig &Base,
                                  ArrayRef<std::string> Settings,
                                  ArrayRef<std::string> Folders) {
  std::string Text;
  raw_string_ostream OS(Text);
  writeChip(Base, OS);
  Expected<YamlValue> Tree = parseYaml(Text, Base.Name);
  if (!Tree)
    return Tree.takeError();
  YamlErrors Errors;
  YamlPlaces Places;
  shiftLines(*Tree, Places.addText("chip " + Base.Name));
  std::vector<SchemaPath> Paths = schemaPaths();

  for (const std::string &Setting : Settings) {
    auto [Path, Value] = StringRef(Setting).split('=');
    if (Path.empty() || Value.empty())
      return createStringError(
          "--set '" + Setting +
          "': expected <path>=<value>, as in memory.latency_cycles=300");
    bool IsNone = Value == "none";
    auto Known = find_if(Paths, [&, &Path = Path](const SchemaPath &P) {
      return P.Text == Path && (!P.IsSection || !P.Folder.empty() ||
                                (IsNone && P.P == Presence::Optional));
    });
    if (Known == Paths.end())
      return createStringError("--set '" + Setting + "': '" + Path + "' " +
                               cureFor(Path, Paths));
    if (IsNone && Known->P == Presence::Optional) {
      removeEntry(*Tree, Path);
      continue;
    }
    unsigned Line = Places.addText("--set '" + Setting + "'");
    YamlEntry &Entry = makeEntry(*Tree, Path, Line);
    Entry.Value = YamlValue();
    Entry.Value.Text = Value.str();
    Entry.Value.Line = Line;
    // The chip's own latency gives way to the DRAM's.
    if (Path == "memory.dram")
      removeEntry(*Tree, "memory.latency_cycles");
    insertNamedFiles(*Tree, Folders, Places, Errors);
    if (Error E = Errors.take(Places))
      return E;
  }
  return buildChip(std::move(*Tree), Base.Name, Folders, Places, Errors);
}

} // namespace tp
