//===- Locations.h - Places in a program by name ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_LOCATIONS_H
#define TP_DEBUGGER_SESSION_LOCATIONS_H

#include "debugger/source/DebugInformation.h"

#include "llvm/Support/Error.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// An instruction to stop at.
struct CodeLocation {
  uint32_t Address = 0;
  /// The line that it belongs to; unknown without debug information.
  SourcePosition Position;
  /// Index for SourceMap::function() of the function that was named. Another
  /// one that is inlined at its beginning may begin here too.
  std::optional<uint32_t> Function;
};

/// What a location may leave out.
struct LocationDefaults {
  SourcePosition Position;
  /// The selected frame; null if there is none.
  const FrameContext *Frame = nullptr;
};

/// The instructions that \p Text means: `FILE:LINE`, `LINE`, `+N`, `-N`,
/// `FUNCTION`, `FILE:FUNCTION`, `*ADDRESS`, or nothing for the selected frame's
/// own place. At least one; the error is in gdb's words.
llvm::Expected<std::vector<CodeLocation>>
findLocations(llvm::StringRef Text, DebugInformation &Information,
              const LocationDefaults &Defaults);

/// The line that \p Text means, as findLocations(), for `list`.
llvm::Expected<SourcePosition> findLine(llvm::StringRef Text,
                                        DebugInformation &Information,
                                        const LocationDefaults &Defaults);

/// Whether the code of a line begins at \p Pc: what is in front is of another.
bool beginsLine(const SourceMap &Map, uint32_t Pc);

} // namespace tp

#endif // TP_DEBUGGER_SESSION_LOCATIONS_H
