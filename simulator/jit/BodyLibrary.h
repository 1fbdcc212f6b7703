//===- BodyLibrary.h - The instructions' bodies as bitcode ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_BODYLIBRARY_H
#define TP_SIMULATOR_JIT_BODYLIBRARY_H

#include "simulator/isa/FloatRules.h"
#include "simulator/isa/Instructions.h"

#include "llvm/IR/Module.h"
#include "llvm/Support/Error.h"

#include <memory>
#include <span>
#include <string>

namespace tp {

/// A module of step functions that was compiled with the simulator
/// (tp_add_bitcode() in CMakeLists.txt).
class BodyLibrary {
public:
  /// \p Bitcode must outlive the library.
  explicit BodyLibrary(std::span<const unsigned char> Bitcode)
      : Bitcode(Bitcode) {}

  /// A new module with all step functions, which nothing outside it can see:
  /// what is added to it may call them, and those not called vanish when it is
  /// optimized.
  llvm::Expected<std::unique_ptr<llvm::Module>>
  instantiate(llvm::LLVMContext &Context) const;

private:
  std::span<const unsigned char> Bitcode;
};

/// Name of an instruction's step function.
std::string stepName(Opcode Op, Subnormals Mode);

/// The cycle engine's step functions (Steps.cpp).
const BodyLibrary &cycleSteps();

} // namespace tp

#endif // TP_SIMULATOR_JIT_BODYLIBRARY_H
