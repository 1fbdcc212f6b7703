//===- DisassemblyView.h - Instructions for a client ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_DISASSEMBLYVIEW_H
#define TP_DEBUGGER_DAP_DISASSEMBLYVIEW_H

#include "debugger/dap/ClientSources.h"
#include "debugger/source/DebugInformation.h"
#include "simulator/loader/Disassembler.h"
#include "simulator/loader/ElfProgram.h"

#include "llvm/Support/JSON.h"

namespace tp::dap {

/// Shows a program's instructions with their lines.
class DisassemblyView {
public:
  /// What is passed must outlive the view.
  DisassemblyView(const ElfProgram &Program, DebugInformation &Information)
      : Program(Program), Information(Information) {}

  /// \p Count instructions from \p Address on; those outside of the text are
  /// marked as invalid.
  llvm::json::Array show(int64_t Address, uint32_t Count);

private:
  const ElfProgram &Program;
  DebugInformation &Information;
  Disassembler Printer;
  /// Rows name their file only where it changes.
  std::optional<SourceFileId> LastFile;

  llvm::json::Object instruction(uint32_t Address);
  void addPlace(llvm::json::Object &Row, uint32_t Address);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_DISASSEMBLYVIEW_H
