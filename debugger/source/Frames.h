//===- Frames.h - A thread's stack ------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_FRAMES_H
#define TP_DEBUGGER_SOURCE_FRAMES_H

#include "debugger/source/FrameContext.h"
#include "debugger/source/SourceFiles.h"

#include "llvm/DebugInfo/DWARF/LowLevel/DWARFUnwindTable.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace llvm {
class DWARFContext;
} // namespace llvm

namespace tp {

class SourceMap;

/// One line of a backtrace.
struct Frame {
  FrameContext Context;
  /// The canonical frame address: the stack pointer before the call. The same
  /// for the functions inlined at one place.
  uint32_t Cfa = 0;
  /// Index for SourceMap::function(); none if nothing is known of the place.
  std::optional<uint32_t> Function;
  SourcePosition Position;
  /// The function is inlined into that of the next frame.
  bool Inlined = false;
};

/// A stack as far as it can be followed.
struct Backtrace {
  /// Innermost first; never empty.
  std::vector<Frame> Frames;
  /// Why it ends before the outermost function; empty if it does not.
  std::string Problem;
};

/// Unwinds stacks by .debug_frame.
class Unwinder {
public:
  /// What is passed must outlive the unwinder.
  Unwinder(llvm::DWARFContext &Dwarf, const SourceMap &Map);
  ~Unwinder();

  /// The innermost \p Limit frames (inlined ones count) of the thread that is
  /// at \p Innermost.
  Backtrace backtrace(const FrameContext &Innermost,
                      size_t Limit = size_t(-1)) const;

  /// The frame that called that of \p Context, without regard to inlining:
  /// nothing for the outermost. The error says what is missing.
  llvm::Expected<std::optional<FrameContext>>
  caller(const FrameContext &Context) const;

  /// The canonical frame address.
  llvm::Expected<uint32_t> cfa(const FrameContext &Context) const;

  /// What \p Register holds in the body of the frame's function, as the base
  /// of its variables: also known while the frame is made and taken down.
  llvm::Expected<uint32_t> frameBase(const FrameContext &Context,
                                     unsigned Register) const;

private:
  struct Rules;

  const SourceMap &Map;
  std::unique_ptr<Rules> Table;

  llvm::Expected<uint32_t> cfaOf(const llvm::dwarf::UnwindRow &Row,
                                 const FrameContext &Context) const;
  llvm::Error restore(unsigned Register,
                      const llvm::dwarf::UnwindLocation &Rule, uint32_t Cfa,
                      const FrameContext &Callee, FrameContext &Caller) const;
  void addFrames(const FrameContext &Context, uint32_t Cfa, size_t Limit,
                 std::vector<Frame> &Frames) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_FRAMES_H
