//===- ThreadName.h - Threads by number or place ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_THREADNAME_H
#define TP_DEBUGGER_SESSION_THREADNAME_H

#include "simulator/chip/ChipConfig.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <string>

namespace tp {

/// `TM.TP` of a thread.
std::string threadPlace(uint32_t Thread, const ChipConfig &Chip);

/// The thread that `17` or `2.1` names.
llvm::Expected<uint32_t> parseThread(llvm::StringRef Text,
                                     const ChipConfig &Chip);

/// `0-31, 40` for ascending numbers.
std::string threadList(llvm::ArrayRef<uint32_t> Threads);

} // namespace tp

#endif // TP_DEBUGGER_SESSION_THREADNAME_H
