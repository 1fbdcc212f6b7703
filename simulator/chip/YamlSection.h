//===- YamlSection.h - Checked access to a mapping --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_YAMLSECTION_H
#define TP_SIMULATOR_CHIP_YAMLSECTION_H

#include "simulator/chip/YamlTree.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/Twine.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace tp {

/// Collects what is wrong with a file, so that all of it is reported at once.
class YamlErrors {
public:
  /// Errors begin with `<FileName>:<line>`.
  explicit YamlErrors(llvm::StringRef FileName)
      : Place([Name = FileName.str()](unsigned Line) {
          return Name + ":" + std::to_string(Line);
        }) {}
  /// Errors begin with what \p PlaceOfLine says of their line.
  explicit YamlErrors(std::function<std::string(unsigned Line)> PlaceOfLine)
      : Place(std::move(PlaceOfLine)) {}

  void add(unsigned Line, const llvm::Twine &What);
  /// All errors, a line each, in the order of the file's lines; success if
  /// there are none.
  llvm::Error take();

private:
  std::function<std::string(unsigned Line)> Place;
  /// By line; errors of one line in the order in which they were found.
  std::multimap<unsigned, std::string> Found;
};

/// Whether a key may be left out.
enum class Presence { Required, Optional };

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

  /// A whole number in [Min, Max]. Sizes accept `KiB`, `MiB` and `GiB` behind
  /// the number.
  uint64_t integer(llvm::StringRef Key, uint64_t Min, uint64_t Max,
                   uint64_t Default, Presence P = Presence::Required);
  uint64_t bytes(llvm::StringRef Key, uint64_t Min, uint64_t Max,
                 uint64_t Multiple, Presence P = Presence::Required);
  /// A decimal number in [Min, Max].
  double number(llvm::StringRef Key, double Min, double Max, double Default,
                Presence P = Presence::Required);
  bool boolean(llvm::StringRef Key, bool Default);
  std::string text(llvm::StringRef Key);
  /// A mapping. If it is missing, an empty one, reported once if required.
  YamlSection section(llvm::StringRef Key, Presence P = Presence::Required);

  /// Line of the value of \p Key, or of the section if it has no such key.
  unsigned lineOf(llvm::StringRef Key) const;
  /// True if the file gives \p Key.
  bool has(llvm::StringRef Key) const { return find(Key) != nullptr; }

  /// Reports every key that no other function was called with.
  void finish();

private:
  YamlErrors &Errors;
  const YamlValue &Mapping;
  unsigned Line;
  std::string Path;
  bool Absent;
  llvm::SmallVector<std::string, 16> Allowed;

  const YamlEntry *find(llvm::StringRef Key) const;
  const YamlEntry *scalar(llvm::StringRef Key, const llvm::Twine &Wanted,
                          Presence P);
  void missing(llvm::StringRef Key, const llvm::Twine &Wanted);
  void bad(const YamlEntry &Entry, const llvm::Twine &Wanted);
  std::string pathOf(llvm::StringRef Key) const;
};

} // namespace tp

#endif // TP_SIMULATOR_CHIP_YAMLSECTION_H
