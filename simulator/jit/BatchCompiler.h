//===- BatchCompiler.h - Compiles segments ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_BATCHCOMPILER_H
#define TP_SIMULATOR_JIT_BATCHCOMPILER_H

#include "simulator/jit/CodeSession.h"
#include "simulator/jit/SegmentCode.h"

#include <memory>
#include <span>
#include <vector>

namespace tp {

/// Segments that have been compiled together.
struct Batch {
  std::vector<GeneratedHandler> Handlers;
  /// Of each handler; together their counts follow those of earlier batches.
  std::vector<SegmentCounts> Counts;
};

/// Compiles segments of one engine's text, one batch after another.
class BatchCompiler {
public:
  BatchCompiler(std::unique_ptr<CodeSession> Session, CodeSubject Subject)
      : Session(std::move(Session)), Subject(std::move(Subject)) {}

  llvm::Expected<Batch> compile(std::span<const Segment> Segments);

  const CodeSubject &subject() const { return Subject; }

private:
  std::unique_ptr<CodeSession> Session;
  const CodeSubject Subject;
  size_t NumCounts = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_JIT_BATCHCOMPILER_H
