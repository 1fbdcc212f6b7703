//===- ChipSettings.cpp - A chip with some other values -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipSettings.h"

#include "simulator/chip/ChipFile.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {
namespace {

/// A key of the chip with the place of its value in the tree.
struct Leaf {
  std::string Path;
  YamlValue *Value;
};

/// Lines of the tree from here on are numbers of settings.
constexpr unsigned FirstSetting = 1u << 30;

} // namespace

static void collectLeaves(YamlValue &Mapping, const std::string &Prefix,
                          std::vector<Leaf> &Leaves) {
  for (YamlEntry &Entry : Mapping.Entries) {
    std::string Path = Prefix + Entry.Key;
    if (Entry.Value.Is == YamlValue::Kind::Mapping)
      collectLeaves(Entry.Value, Path + ".", Leaves);
    else
      Leaves.push_back({Path, &Entry.Value});
  }
}

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

static std::string cureFor(StringRef Wanted, ArrayRef<Leaf> Leaves) {
  std::string Section = Wanted.str() + ".";
  std::vector<std::string> Keys;
  for (const Leaf &L : Leaves) {
    StringRef Rest = L.Path;
    if (!Rest.consume_front(Section))
      continue;
    std::string Key = Section + Rest.split('.').first.str();
    if (!is_contained(Keys, Key))
      Keys.push_back(Key);
  }
  if (!Keys.empty())
    return "is a section with " + join(Keys, ", ");
  const Leaf *Nearest = min_element(Leaves, [&](const Leaf &A, const Leaf &B) {
    return distance(Wanted, A.Path) < distance(Wanted, B.Path);
  });
  return "is no key of a chip; did you mean '" + Nearest->Path +
         "'? (--print-chip lists all)";
}

Expected<ChipConfig> withSettings(const ChipConfig &Base,
                                  ArrayRef<std::string> Settings) {
  // The file that says all of the chip has all of its keys.
  std::string Text;
  raw_string_ostream OS(Text);
  writeChip(Base, OS);
  Expected<YamlValue> Tree = parseYaml(Text, Base.Name);
  if (!Tree)
    return Tree.takeError();
  std::vector<Leaf> Leaves;
  collectLeaves(*Tree, "", Leaves);

  for (const auto &[Number, Setting] : enumerate(Settings)) {
    auto [Path, Value] = StringRef(Setting).split('=');
    if (Path.empty() || Value.empty())
      return createStringError(
          "--set '" + Setting +
          "': expected <path>=<value>, as in memory.latency_cycles=300");
    auto Found = find_if(
        Leaves, [&, &Path = Path](const Leaf &L) { return L.Path == Path; });
    if (Found == Leaves.end())
      return createStringError("--set '" + Setting + "': '" + Path + "' " +
                               cureFor(Path, Leaves));
    Found->Value->Text = Value.str();
    Found->Value->Line = FirstSetting + unsigned(Number);
  }
  YamlErrors Errors([&](unsigned Line) {
    return Line < FirstSetting
               ? "chip " + Base.Name
               : "--set '" + Settings[Line - FirstSetting] + "'";
  });
  return buildChip(*Tree, Errors, Base.Name);
}

} // namespace tp
