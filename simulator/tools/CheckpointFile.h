//===- CheckpointFile.h - The state of a run in a file ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A checkpoint is: "TPCHKPT" and the format's version (8 bytes), the XXH3 hash
// of all that follows (8 bytes), the text of the run's identity, the kind of
// compression, the size of the state, and the state. Numbers are little-endian
// 64-bit words, texts and the state have their length before them.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_CHECKPOINTFILE_H
#define TP_SIMULATOR_TOOLS_CHECKPOINTFILE_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// What a run's state depends on: names and values in one line each. A
/// checkpoint can be restored only into an equal run.
using RunIdentity = std::vector<std::pair<std::string, std::string>>;

/// Replaces the file at \p Path at once: whatever happens, it is either the old
/// or the new one.
llvm::Error writeCheckpoint(llvm::StringRef Path, const RunIdentity &Identity,
                            llvm::ArrayRef<uint8_t> State);

/// Fails if the file is damaged, no checkpoint or one of another run.
llvm::Expected<std::vector<uint8_t>>
readCheckpoint(llvm::StringRef Path, const RunIdentity &Identity);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_CHECKPOINTFILE_H
