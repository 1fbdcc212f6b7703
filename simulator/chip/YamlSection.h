//===- YamlSection.h - Checked access to a mapping --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_YAMLSECTION_H
#define TP_SIMULATOR_CHIP_YAMLSECTION_H

#include "simulator/chip/ChipSchema.h"
#include "simulator/chip/YamlTree.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/Twine.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tp {

/// Numbers the lines of several files, so that one number tells file and line.
class YamlPlaces {
public:
  /// What to add to the lines of a file called \p Name.
  unsigned addFile(llvm::StringRef Name) {
    return add(Name, /*HasLines=*/true);
  }
  /// The line that stands for \p Name, which is no file.
  unsigned addText(llvm::StringRef Name) {
    return add(Name, /*HasLines=*/false);
  }
  /// `<name>:<line>` of a file, or the text.
  std::string of(unsigned Line) const;

private:
  static constexpr unsigned LinesEach = 1u << 20;
  struct Place {
    std::string Name;
    bool HasLines;
  };
  std::vector<Place> Places;

  unsigned add(llvm::StringRef Name, bool HasLines) {
    Places.push_back({Name.str(), HasLines});
    return unsigned(Places.size() - 1) * LinesEach;
  }
};

/// Collects what is wrong with a file and those it names, so that all of it is
/// reported at once.
class YamlErrors {
public:
  void add(unsigned Line, const llvm::Twine &What) {
    Found.emplace(Line, What.str());
  }
  bool empty() const { return Found.empty(); }
  /// All errors, a line each with its place, in the order of the files' lines;
  /// success if there are none.
  llvm::Error take(const YamlPlaces &Places);

private:
  /// By line; errors of one line in the order in which they were found.
  std::multimap<unsigned, std::string> Found;
};

/// A mapping of a YAML file whose keys are fetched by name. The keys that were
/// asked for are the allowed ones: finish() refuses all others. A value that
/// is missing or wrong is reported, and the default comes back.
class YamlSection {
public:
  /// \p Path names the section in messages, e.g. `units.FPADD`; it is empty for
  /// the outermost one. Of a section that the file lacks (\p Absent) no missing
  /// keys are reported.
  YamlSection(YamlErrors &Errors, const YamlValue &Mapping, unsigned Line,
              std::string Path, bool Absent = false);

  uint64_t integer(llvm::StringRef Key, const IntegerRange &Range,
                   uint64_t Default, Presence P);
  double number(llvm::StringRef Key, const NumberRange &Range, double Default,
                Presence P);
  /// Index of the one of \p Names.
  unsigned choice(llvm::StringRef Key, llvm::ArrayRef<llvm::StringRef> Names,
                  unsigned Default, Presence P);
  std::string text(llvm::StringRef Key, Presence P);
  /// A mapping. If it is missing, an empty one, reported once if required.
  YamlSection section(llvm::StringRef Key, Presence P);

  /// True if the file gives \p Key. Counts as asking for it.
  bool has(llvm::StringRef Key);

  /// Reports \p Key, if the file gives it: \p Other makes it useless.
  void exclude(llvm::StringRef Key, llvm::StringRef Other);

  /// Reports every key that no other function was called with.
  void finish();

private:
  YamlErrors &Errors;
  const YamlValue &Mapping;
  unsigned Line;
  std::string Path;
  bool Absent;
  llvm::SmallVector<std::string, 16> Allowed;

  void allow(llvm::StringRef Key);
  const YamlEntry *scalar(llvm::StringRef Key, const llvm::Twine &Wanted,
                          Presence P);
  void missing(llvm::StringRef Key, const llvm::Twine &Wanted);
  void bad(const YamlEntry &Entry, const llvm::Twine &Wanted);
  std::string pathOf(llvm::StringRef Key) const;
};

} // namespace tp

#endif // TP_SIMULATOR_CHIP_YAMLSECTION_H
