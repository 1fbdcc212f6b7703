//===- RunReader.h - The files that runs are read from ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_COMPARE_RUNREADER_H
#define TP_SIMULATOR_COMPARE_RUNREADER_H

#include "simulator/compare/ComparedRun.h"

#include "llvm/Support/JSON.h"

namespace tp {

/// Reads thread-cycles lost by reason.
bool readLost(const llvm::json::Value &Json, CycleCounts &Counts,
              llvm::json::Path Path);

/// Lets \p Read have the object \p Name of \p Parent.
template <typename Reader>
bool readObject(const llvm::json::Object &Parent, llvm::StringRef Name,
                llvm::json::Path Path, Reader Read) {
  const llvm::json::Value *Value = Parent.get(Name);
  if (!Value) {
    Path.field(Name).report("missing value");
    return false;
  }
  llvm::json::ObjectMapper Object(*Value, Path.field(Name));
  return Object && Read(Object);
}

/// Reads what `tpsim --stats` has written.
bool readStatistics(const llvm::json::Value &Json, ComparedRun &Run,
                    llvm::json::Path Path);

/// Takes the figures that are there of what `tpsim --stats` has written.
void readFigures(const llvm::json::Object &Statistics, ComparedRun &Run);

/// Reads what `tpsim --profile` has written. Errors begin with \p Name.
llvm::Expected<ComparedRun> readProfileRun(llvm::StringRef Text,
                                           llvm::StringRef Name);

} // namespace tp

#endif // TP_SIMULATOR_COMPARE_RUNREADER_H
