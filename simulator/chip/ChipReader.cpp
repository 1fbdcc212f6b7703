//===- ChipReader.cpp - A chip from the tree of its file ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipReader.h"

#include "simulator/chip/ChipChecks.h"
#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipSchema.h"
#include "simulator/chip/SchemaPaths.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"

#include <deque>

using namespace llvm;

namespace tp {
namespace {

/// Fills a chip from the values of a file.
class Reader : public ChipVisitor {
public:
  Reader(const YamlValue &Tree, YamlErrors &Errors) {
    Open.emplace_back(Errors, Tree, Tree.Line, "");
  }

  void finish() { Open.back().finish(); }

  void exclude(StringRef Name, StringRef Other) override {
    Open.back().exclude(Name, Other);
  }

private:
  /// The sections around the place of reading.
  std::deque<YamlSection> Open;

  void visitInteger(const KeyInfo &Key, uint64_t &Value,
                    const IntegerRange &Range) override {
    Value = Open.back().integer(Key.Name, Range, Value, Key.P);
  }
  void visitNumber(const KeyInfo &Key, double &Value,
                   const NumberRange &Range) override {
    Value = Open.back().number(Key.Name, Range, Value, Key.P);
  }
  void visitChoice(const KeyInfo &Key, unsigned &Value,
                   ArrayRef<StringRef> Names) override {
    Value = Open.back().choice(Key.Name, Names, Value, Key.P);
  }
  void visitText(const KeyInfo &Key, std::string &Value) override {
    if (Open.back().has(Key.Name) || Key.P == Presence::Required)
      Value = Open.back().text(Key.Name, Key.P);
  }
  bool beginSection(const SectionInfo &Section, bool HasValue) override {
    const KeyInfo &Key = Section.Key;
    if (!HasValue && !Open.back().has(Key.Name))
      return false;
    Open.push_back(Open.back().section(Key.Name, Key.P));
    return true;
  }
  void endSection() override {
    Open.back().finish();
    Open.pop_back();
  }
};

/// Finds and reads the files that a chip file names.
class NamedFiles {
public:
  NamedFiles(ArrayRef<std::string> Folders, YamlPlaces &Places,
             YamlErrors &Errors)
      : Folders(Folders), Places(Places), Errors(Errors) {}

  /// Puts the file in place that \p Entry names.
  void insert(YamlEntry &Entry, StringRef Path, StringRef Folder) {
    std::string File = find(Entry.Value.Text, Folder);
    ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer =
        MemoryBuffer::getFile(File, /*IsText=*/true);
    if (!Buffer) {
      Errors.add(Entry.Value.Line, "'" + Path + "' is '" + Entry.Value.Text +
                                       "': " + cure(File, Folder, Buffer));
      return;
    }
    unsigned Offset = Places.addFile(File);
    Expected<YamlValue> Tree = parseYaml((*Buffer)->getBuffer(), File);
    if (!Tree) {
      Errors.add(Entry.Value.Line, toString(Tree.takeError()));
      return;
    }
    shiftLines(*Tree, Offset);
    Entry.Value = std::move(*Tree);
    Entry.Line = Entry.Value.Line;
  }

private:
  ArrayRef<std::string> Folders;
  YamlPlaces &Places;
  YamlErrors &Errors;

  static bool isPath(StringRef Name) {
    return Name.contains('/') || Name.ends_with(".yaml");
  }

  /// The path of the file, which need not exist.
  std::string find(StringRef Name, StringRef Folder) const {
    SmallString<256> Path;
    if (isPath(Name)) {
      if (!sys::path::is_absolute(Name) && !Folders.empty())
        Path = Folders.front();
      sys::path::append(Path, Name);
      return std::string(Path);
    }
    for (const std::string &Parent : Folders) {
      Path = Parent;
      sys::path::append(Path, Folder, Name + ".yaml");
      if (sys::fs::exists(Path))
        break;
    }
    return std::string(Path);
  }

  std::string cure(StringRef File, StringRef Folder,
                   const ErrorOr<std::unique_ptr<MemoryBuffer>> &Failed) const {
    std::vector<std::string> Names;
    for (const std::string &Parent : Folders) {
      SmallString<256> Path(Parent);
      sys::path::append(Path, Folder);
      append_range(Names, chipNames(Path));
    }
    llvm::sort(Names);
    Names.erase(llvm::unique(Names), Names.end());
    return ("cannot read " + File + ": " + Failed.getError().message() +
            (Names.empty() ? "" : "; give it one of: " + join(Names, ", ")))
        .str();
  }
};

} // namespace

void insertNamedFiles(YamlValue &Tree, ArrayRef<std::string> Folders,
                      YamlPlaces &Places, YamlErrors &Errors) {
  for (const SchemaPath &Path : schemaPaths()) {
    if (Path.Folder.empty())
      continue;
    YamlEntry *Entry = findPath(Tree, Path.Text);
    if (Entry && Entry->Value.Is == YamlValue::Kind::Scalar)
      NamedFiles(Folders, Places, Errors)
          .insert(*Entry, Path.Text, Path.Folder);
  }
}

Expected<ChipConfig> buildChip(YamlValue Tree, StringRef Name,
                               ArrayRef<std::string> Folders,
                               YamlPlaces &Places, YamlErrors &Errors) {
  insertNamedFiles(Tree, Folders, Places, Errors);
  if (Error E = Errors.take(Places))
    return E;
  ChipConfig Chip = defaultChip();
  Chip.Name = Name.str();
  Reader R(Tree, Errors);
  visitChip(R, Chip);
  R.finish();
  if (Errors.empty())
    checkChip(Chip, Tree, Errors);
  if (Error E = Errors.take(Places))
    return E;
  return Chip;
}

} // namespace tp
