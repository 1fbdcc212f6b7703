//===- ChipSchema.h - The keys of a chip file -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Every key stands once, in visitChip(): its name, where its value is kept,
// what is allowed and what it means. Reading, writing, --set and the table of
// docs/chip-files.md are visitors of it.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPSCHEMA_H
#define TP_SIMULATOR_CHIP_CHIPSCHEMA_H

#include "simulator/chip/ChipConfig.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ADT/StringRef.h"

namespace tp {

/// Whether a key may be left out.
enum class Presence { Required, Optional };

/// A key or a section.
struct KeyInfo {
  llvm::StringRef Name;
  /// What it is, with its unit; a part of a sentence.
  llvm::StringRef Meaning;
  /// Of an optional key: without it the value is what ChipConfig has.
  Presence P = Presence::Required;
  /// What stands in the documentation for the name of several keys of one
  /// kind, such as `UNIT`; empty for all others.
  llvm::StringRef Family = {};
};

/// The whole numbers that a key allows.
struct IntegerRange {
  uint64_t Min;
  uint64_t Max;
  uint64_t Multiple = 1;
  bool PowerOfTwo = false;
  /// `KiB`, `MiB` and `GiB` may follow the number.
  bool IsBytes = false;
};

/// The decimal numbers that a key allows.
struct NumberRange {
  double Min;
  double Max;
};

/// What a key allows, as in `a whole number from 1 to 64`.
std::string rangeText(const IntegerRange &Range);
std::string rangeText(const NumberRange &Range);

/// A section of keys.
struct SectionInfo {
  KeyInfo Key;
  /// Instead of the section, the file may give the name of a file
  /// `<Folder>/<name>.yaml` that has its keys, or a path; empty if not.
  llvm::StringRef Folder = {};
  /// Written on one line.
  bool OneLine = false;
};

/// Does something with every key of a chip.
class ChipVisitor {
public:
  virtual ~ChipVisitor() = default;

  template <class Int>
  void integer(const KeyInfo &Key, Int &Value, const IntegerRange &Range) {
    uint64_t Number = Value;
    visitInteger(Key, Number, Range);
    Value = Int(Number);
  }
  void number(const KeyInfo &Key, double &Value, const NumberRange &Range) {
    visitNumber(Key, Value, Range);
  }
  /// One of \p Names, of which the first stands for 0.
  template <class Enum>
  void choice(const KeyInfo &Key, Enum &Value,
              llvm::ArrayRef<llvm::StringRef> Names) {
    unsigned Index = unsigned(Value);
    visitChoice(Key, Index, Names);
    Value = Enum(Index);
  }
  void text(const KeyInfo &Key, std::string &Value) { visitText(Key, Value); }

  void section(const SectionInfo &Section, llvm::function_ref<void()> Keys) {
    if (!beginSection(Section, /*HasValue=*/true))
      return;
    Keys();
    endSection();
  }
  /// A section that is there if \p Value has one.
  template <class T>
  void section(const SectionInfo &Section, std::optional<T> &Value,
               llvm::function_ref<void(T &)> Keys) {
    if (!beginSection(Section, Value.has_value()))
      return;
    if (!Value)
      Value.emplace();
    Keys(*Value);
    endSection();
  }

  /// Whether keys that exclude each other are all to be visited.
  virtual bool visitsAll() const { return false; }
  /// Key \p Name is of no use here, because the chip has \p Other.
  virtual void exclude(llvm::StringRef Name, llvm::StringRef Other) {}

private:
  virtual void visitInteger(const KeyInfo &Key, uint64_t &Value,
                            const IntegerRange &Range) = 0;
  virtual void visitNumber(const KeyInfo &Key, double &Value,
                           const NumberRange &Range) = 0;
  virtual void visitChoice(const KeyInfo &Key, unsigned &Value,
                           llvm::ArrayRef<llvm::StringRef> Names) = 0;
  virtual void visitText(const KeyInfo &Key, std::string &Value) = 0;
  /// Whether the section's keys are to be visited, and endSection() called
  /// after them. \p HasValue: the chip has the section.
  virtual bool beginSection(const SectionInfo &Section, bool HasValue) = 0;
  virtual void endSection() = 0;
};

/// Visits all keys in the order of a file. A visitor that reads gets a \p Chip
/// made by defaultChip().
void visitChip(ChipVisitor &Visitor, ChipConfig &Chip);

/// A chip whose optional keys have the values that hold if a file lacks them.
ChipConfig defaultChip();

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPSCHEMA_H
