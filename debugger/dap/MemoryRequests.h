//===- MemoryRequests.h - Requests about memory and code --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_MEMORYREQUESTS_H
#define TP_DEBUGGER_DAP_MEMORYREQUESTS_H

#include "debugger/dap/Debuggee.h"
#include "debugger/dap/MemoryReference.h"

namespace tp::dap {

/// Answers readMemory, writeMemory and disassemble.
class MemoryRequests {
public:
  explicit MemoryRequests(Debuggee &Target) : Target(Target) {}

  void addTo(Dispatcher &Requests);

private:
  Debuggee &Target;

  Response readMemory(const ReadMemoryArguments &Arguments);
  Response writeMemory(const WriteMemoryArguments &Arguments);
  Response disassemble(const DisassembleArguments &Arguments);

  /// A place in the memory of a thread.
  struct Place {
    uint32_t Address = 0;
    const MachineAccess *Machine = nullptr;
  };
  llvm::Expected<Place> place(llvm::StringRef Reference, int64_t Offset);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_MEMORYREQUESTS_H
