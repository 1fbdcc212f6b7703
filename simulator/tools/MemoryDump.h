//===- MemoryDump.h - Writes variables of a finished run --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_MEMORYDUMP_H
#define TP_SIMULATOR_TOOLS_MEMORYDUMP_H

#include "simulator/core/Memory.h"
#include "simulator/loader/ElfProgram.h"

#include "llvm/Support/Error.h"

#include <string>

namespace tp {

/// A variable whose bytes are wanted, by its name in the symbol table or in
/// C++, and the file that gets them.
struct MemoryDumpRequest {
  std::string Symbol;
  std::string Path;
};

/// The place of such a variable.
struct MemoryDump {
  std::string Path;
  uint32_t Address;
  uint64_t Bytes;
};

/// Looks a variable up; an error if \p Program does not have it in \p Global.
llvm::Expected<MemoryDump> locate(const MemoryDumpRequest &Request,
                                  const ElfProgram &Program,
                                  const Memory &Global);

/// Writes a variable's bytes to its file.
llvm::Error write(const MemoryDump &Dump, const Memory &Global);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_MEMORYDUMP_H
