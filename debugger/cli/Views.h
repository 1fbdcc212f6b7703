//===- Views.h - Texts that several commands print --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_CLI_VIEWS_H
#define TP_DEBUGGER_CLI_VIEWS_H

#include "debugger/cli/Shell.h"

namespace tp {

/// `name = value`, a line each.
void printVariables(Shell &S, const std::vector<VariableInfo> &Variables,
                    const FrameContext &Frame, llvm::StringRef Indent = "");

/// The innermost \p Limit frames of the selected thread.
void printStack(Shell &S, size_t Limit, bool WithLocals);

/// All threads, those at one place in one line.
void printThreads(Shell &S);

/// The selected thread's time: cycle, why it waits, what is under way.
void printTiming(Shell &S);

/// The chip's threads by what they do in this cycle.
void printChip(Shell &S);

/// Ends the display \p Number, or all if it is empty.
llvm::Error undisplay(Shell &S, llvm::StringRef Number);

/// Lets it print or not.
llvm::Error enableDisplays(Shell &S, llvm::StringRef Number, bool IsEnabled);

/// Source lines \p First to \p Last of a file.
llvm::Error printLines(Shell &S, SourceFileId File, uint32_t First,
                       uint32_t Last);

} // namespace tp

#endif // TP_DEBUGGER_CLI_VIEWS_H
