//===- JsonBlocks.h - The larger blocks of the JSON -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each writes an attribute of the object at hand; docs/statistics.md lists the
// names.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_JSONBLOCKS_H
#define TP_SIMULATOR_STATS_JSONBLOCKS_H

#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/JSON.h"

namespace tp {

/// `area_mm2` and `area_sources`, if the chip says what its parts cost.
void writeArea(const RunSummary &Run, llvm::json::OStream &Json);

/// `energy`, likewise.
void writeEnergy(const RunSummary &Run, llvm::json::OStream &Json);

/// `memory`, if the chip has caches or DRAM.
void writeMemory(const RunSummary &Run, llvm::json::OStream &Json);

/// `instructions_by_pc`, if the summary has the instructions' sources.
void writePcs(const RunSummary &Run, llvm::json::OStream &Json);

/// `threads`.
void writeThreads(const RunSummary &Run, llvm::json::OStream &Json);

/// An array on one line: thousands of lines would bury the rest.
template <typename RangeT>
void writeFlatArray(llvm::StringRef Name, RangeT &&Values,
                    llvm::json::OStream &Json) {
  Json.attributeBegin(Name);
  Json.rawValue([&](llvm::raw_ostream &OS) {
    OS << '[';
    llvm::interleave(Values, OS, ",");
    OS << ']';
  });
  Json.attributeEnd();
}

} // namespace tp

#endif // TP_SIMULATOR_STATS_JSONBLOCKS_H
