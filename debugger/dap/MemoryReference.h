//===- MemoryReference.h - Addresses as a client keeps them -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_MEMORYREFERENCE_H
#define TP_DEBUGGER_DAP_MEMORYREFERENCE_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tp::dap {

/// An address, and the thread whose local store it is in: `0x00010040` or
/// `0xffffff40@3`.
struct MemoryReference {
  uint32_t Address = 0;
  std::optional<uint32_t> Thread;

  std::string text() const;
};

/// The address as eight digits: `0x00010040`.
std::string addressText(uint32_t Address);

/// Reads what text() wrote, or an address that the user typed.
llvm::Expected<MemoryReference> parseMemoryReference(llvm::StringRef Text);

/// \p Address + \p Offset; the error says that it is outside of 32 bits.
llvm::Expected<uint32_t> addressPlus(uint32_t Address, int64_t Offset);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_MEMORYREFERENCE_H
