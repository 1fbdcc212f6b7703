//===- InstructionTrace.cpp - A thread's instructions as text -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/InstructionTrace.h"

#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

llvm::Error InstructionTrace::start(FunctionalMachine &Machine,
                                    const ChipConfig &Chip,
                                    const Options &Request) {
  if (Request.TracedThread >= Chip.threadCount())
    return createStringError("--trace-instructions-thread " +
                             Twine(Request.TracedThread) + ": the chip has " +
                             Twine(Chip.threadCount()) + " threads");
  Path = Request.InstructionTraceOutput;
  std::error_code EC;
  File = std::make_unique<raw_fd_ostream>(Path, EC);
  if (EC)
    return createStringError("cannot write " + Path + ": " + EC.message());
  Machine.setStepObserver(
      Request.TracedThread,
      [this](uint32_t Pc, const auto &Registers) { write(Pc, Registers); });
  return llvm::Error::success();
}

void InstructionTrace::write(
    uint32_t Pc, const std::array<uint32_t, NumRegisters> &Registers) {
  *File << format_hex_no_prefix(Pc, 8);
  for (unsigned I = 0; I != NoRegister; ++I)
    if (Registers[I] != Before[I])
      *File << ' ' << (I < NumIntegerRegisters ? 'r' : 'f')
            << I % NumIntegerRegisters << '='
            << format_hex_no_prefix(Registers[I], 1);
  *File << '\n';
  Before = Registers;
}

llvm::Error InstructionTrace::finish() {
  if (!File)
    return llvm::Error::success();
  File->close();
  std::error_code EC = File->error();
  File->clear_error();
  if (EC)
    return createStringError("cannot write " + Path + ": " + EC.message());
  return llvm::Error::success();
}

} // namespace tp
