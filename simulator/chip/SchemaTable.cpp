//===- SchemaTable.cpp - The keys of a chip file as a table ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/SchemaTable.h"

#include "simulator/chip/ChipSchema.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Support/Format.h"

#include <vector>

using namespace llvm;

namespace tp {
namespace {

class TableWriter : public ChipVisitor {
public:
  explicit TableWriter(raw_ostream &OS) : OS(OS) {
    OS << "| key | meaning | allowed | default |\n|---|---|---|---|\n";
  }

  bool visitsAll() const override { return true; }

private:
  raw_ostream &OS;
  /// Of the open sections with their dots.
  std::vector<std::string> Prefixes{""};
  /// Sections and keys that stand for a family and are in the table.
  StringSet<> Families;

  std::string pathOf(const KeyInfo &Key) const {
    return Prefixes.back() + (Key.Family.empty() ? Key.Name : Key.Family).str();
  }

  /// Whether \p Key is one more of a family that has its row.
  bool isKnown(const KeyInfo &Key) {
    return !Key.Family.empty() && !Families.insert(pathOf(Key)).second;
  }

  void row(const KeyInfo &Key, StringRef Allowed, StringRef Default) {
    if (isKnown(Key))
      return;
    OS << "| `" << pathOf(Key) << "` | " << Key.Meaning << " | " << Allowed
       << " | ";
    if (Key.P == Presence::Optional && Key.Family.empty() && !Default.empty())
      OS << '`' << Default << "` ";
    OS << "|\n";
  }

  void visitInteger(const KeyInfo &Key, uint64_t &Value,
                    const IntegerRange &Range) override {
    std::string Allowed =
        number(Range.Min, Range) + " to " + number(Range.Max, Range);
    if (Range.Multiple > 1)
      Allowed += ", multiple of " + utostr(Range.Multiple);
    if (Range.PowerOfTwo)
      Allowed += ", power of two";
    row(Key, Allowed, number(Value, Range));
  }
  void visitNumber(const KeyInfo &Key, double &Value,
                   const NumberRange &Range) override {
    row(Key, number(Range.Min) + " to " + number(Range.Max), number(Value));
  }
  void visitChoice(const KeyInfo &Key, unsigned &Value,
                   ArrayRef<StringRef> Names) override {
    row(Key, "`" + join(Names, "`, `") + "`", Names[Value]);
  }
  void visitText(const KeyInfo &Key, std::string &Value) override {
    row(Key, "text", Value);
  }
  bool beginSection(const SectionInfo &Section, bool HasValue) override {
    const KeyInfo &Key = Section.Key;
    if (isKnown(Key))
      return false;
    OS << "| **`" << pathOf(Key) << "`** | " << Key.Meaning << " | ";
    if (!Section.Folder.empty())
      OS << "keys, the name of a file in `" << Section.Folder
         << "/`, or its path";
    OS << " | " << (HasValue ? "" : "none ") << "|\n";
    Prefixes.push_back(pathOf(Key) + ".");
    return true;
  }
  void endSection() override { Prefixes.pop_back(); }

  static std::string number(double Value) {
    std::string Text;
    raw_string_ostream(Text) << format("%g", Value);
    return Text;
  }
  static std::string number(uint64_t Value, const IntegerRange &Range) {
    static constexpr const char *Units[] = {"", " KiB", " MiB", " GiB"};
    unsigned Unit = 0;
    while (Range.IsBytes && Unit != 3 && Value && Value % 1024 == 0) {
      Value /= 1024;
      ++Unit;
    }
    return utostr(Value) + Units[Unit];
  }
};

} // namespace

void writeSchemaTable(raw_ostream &OS) {
  TableWriter Writer(OS);
  ChipConfig Chip = defaultChip();
  visitChip(Writer, Chip);
}

} // namespace tp
