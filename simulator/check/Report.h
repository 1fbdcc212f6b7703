//===- Report.h - What a checker has found ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_REPORT_H
#define TP_SIMULATOR_CHECK_REPORT_H

#include "simulator/check/CallContexts.h"
#include "simulator/check/Suppressions.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/loader/Symbolizer.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Support/JSON.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace tp {

/// One of the places in the program that a report names: the access, the
/// allocation, the other thread's access.
struct ReportSide {
  /// Such as "store of 4 bytes" or "allocated".
  std::string What;
  /// Nothing if it was no thread: the loader.
  std::optional<uint32_t> Thread;
  /// Addresses of instructions: the place and the calls that led there, the
  /// innermost first. Empty if nobody knows.
  std::vector<uint32_t> Stack;
};

/// A fault of the program.
struct Report {
  /// The checker's name, as in --check=: "memory", "init", "stack", "race".
  std::string Check;
  /// What kind of fault, such as "heap-use-after-free".
  std::string Kind;
  /// The fault in one line, without thread and place.
  std::string Title;
  /// What the address is, such as "8 bytes behind the global 'table' of 40
  /// bytes"; empty if that says nothing.
  std::string Object;
  /// The access, if there is one.
  std::optional<uint32_t> Address;
  uint32_t Bytes = 0;
  /// The one that the fault was noticed at comes first.
  std::vector<ReportSide> Sides;
  /// What it has in common with others of its kind that are not worth another
  /// report; empty: the source lines of all sides.
  std::string Cause;
};

/// Writes reports as they come, each cause once, and keeps them for the end.
class Reports {
public:
  /// The arguments must outlive it.
  Reports(const ElfProgram &Program, const ChipConfig &Chip,
          const Suppressions &Suppressed, llvm::raw_ostream &OS);

  /// Whether a report of this kind, a literal, about these two places may be
  /// news. Cheap, for faults that come often; notes the places.
  bool isNew(const char *Kind, const CodePlace &Place,
             const CodePlace &Other = {}) {
    // Of several stacks some may be suppressed.
    const bool TellsStacksApart = !Suppressed.isEmpty();
    return Places
        .insert({Kind, Place.Pc, TellsStacksApart ? Place.Calls : 0, Other.Pc,
                 TellsStacksApart ? Other.Calls : 0})
        .second;
  }

  /// Writes \p R unless it is suppressed or another one of its kind had the
  /// same cause.
  void add(const Report &R);

  /// The functions, files and lines of an instruction, innermost first.
  const std::vector<SourceFrame> &frames(uint32_t Pc);

  /// What was written, and what the user did not want to see.
  size_t written() const { return Written; }
  size_t suppressed() const { return SuppressedCauses.size(); }
  /// The line about all of it at the end of the run.
  void writeSummary() const;
  /// All that was written.
  llvm::json::Value json() const;

private:
  using PlacePair = std::tuple<std::string_view, uint32_t, CallContext,
                               uint32_t, CallContext>;

  bool isSuppressed(const Report &R);
  /// Kind and cause.
  std::string causeOf(const Report &R);
  void write(const Report &R);
  void writeSide(const ReportSide &Side);
  /// \p Number is that of the next line.
  void writeStack(llvm::ArrayRef<uint32_t> Stack, unsigned &Number);
  llvm::json::Value json(const Report &R);

  const ChipConfig &Chip;
  const Suppressions &Suppressed;
  llvm::raw_ostream &OS;
  Symbolizer Symbols;
  std::map<uint32_t, std::vector<SourceFrame>> FramesOf;
  std::set<PlacePair> Places;
  llvm::StringSet<> Causes;
  llvm::StringSet<> SuppressedCauses;
  llvm::json::Array Kept;
  size_t Written = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_REPORT_H
