//===- CodeGenerator.h - Who compiles hot code for the engine ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The engine runs without one: then the interpreter's handlers do everything.
// Generated code is a handler in the slot of the instruction that it begins
// with. Whatever it does not do itself it leaves to the interpreter's handler
// of the instruction at hand, so it changes nothing but speed.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_CODEGENERATOR_H
#define TP_SIMULATOR_CORE_CODEGENERATOR_H

#include "simulator/core/Program.h"
#include "simulator/core/ResourceLayout.h"
#include "simulator/core/TmRunner.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// The engine as generated code sees it. What it points to outlives the
/// generator's code.
struct CodeSubject {
  const Program *Text = nullptr;
  const ChipContext *Context = nullptr;
  bool FlushToZero = false;
  /// Whether loads ask TmRunnerState::Memory.
  bool HasMemorySystem = false;
  /// The bits of a resource word that say that a limit is exceeded. Each
  /// 64-bit part of a word can be used and tested without the others.
  WideWord Guards = 0;
  /// The array of Slot<Word>: its address, the size of an element, and the
  /// place of the handler in it. A handler is a preserve_none function of
  /// (Thread *, const Slot *, uint64_t Cycle, Word *Free, TmRunner *).
  const void *Slots = nullptr;
  size_t SlotBytes = 0;
  size_t HandlerOffset = 0;
  /// Bytes of the resource word.
  size_t WordBytes = 0;
  /// Of each slot the interpreter's handler; null where only the interpreter
  /// can do what has to be done.
  std::vector<const void *> Interpreter;
  /// The line of each word of the text if instruction caches can miss, else
  /// empty: code for a word may not go on to a word of another line but by that
  /// word's handler in Slots.
  std::vector<uint32_t> LineOf;
  /// Of each slot what it takes of its cycle's resources, and the ready word of
  /// its result, to which the cycle of issue is added.
  std::vector<WideWord> Uses;
  std::vector<ReadyWord> Results;
  /// The handler that charges a taken branch, which is the thread's LastWord,
  /// and goes on at its target.
  const void *WaitForTarget = nullptr;
};

/// A handler that has been generated.
struct GeneratedHandler {
  /// Number of the slot that it is for.
  uint32_t Word = 0;
  const void *Entry = nullptr;
};

/// Generates code for one engine. The engine calls it between windows, when no
/// host thread simulates.
class CodeGenerator {
public:
  virtual ~CodeGenerator() = default;

  /// Called once, before the first update().
  virtual void start(CodeSubject Subject) = 0;

  /// Sees what was counted so far, and gives the handlers that are ready since
  /// the last call.
  virtual std::vector<GeneratedHandler>
  update(std::span<const TmRunnerState *const> Counters) = 0;

  /// The number of elements that TmRunnerState::CodeCounts must have now.
  virtual size_t numCounts() const = 0;

  /// Adds what the code has counted in \p Runner to its other counts, and
  /// begins anew.
  virtual void fold(TmRunnerState &Runner) = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_CODEGENERATOR_H
