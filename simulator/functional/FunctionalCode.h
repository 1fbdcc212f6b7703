//===- FunctionalCode.h - Generated code, functional mode -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCODE_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCODE_H

#include "simulator/core/Program.h"
#include "simulator/functional/FunctionalHandlers.h"

#include <vector>

namespace tp {

/// What code is generated for. All of it outlives the generator.
struct FunctionalSubject {
  const Program *Text = nullptr;
  const FunctionalRunner *Runner = nullptr;
  /// The interpreter's handler of each slot.
  std::vector<FunctionalHandler> Interpreter;
  /// Ends the turn before the instruction at hand.
  FunctionalHandler EndTurn = nullptr;
  bool FlushToZero = false;
};

/// Generates handlers that do many instructions at once, with the counts and
/// the ends of turns of the interpreter's.
class FunctionalCodeGenerator {
public:
  /// A handler and the word of the text in whose slot it belongs.
  struct Handler {
    uint32_t Word;
    FunctionalHandler Execute;
  };

  virtual ~FunctionalCodeGenerator() = default;

  /// Before everything else, once.
  virtual void start(FunctionalSubject Subject) = 0;

  /// Between two turns: what is to be put into the slots.
  virtual std::vector<Handler> update() = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALCODE_H
