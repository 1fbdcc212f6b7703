//===- FunctionMap.h - The functions of a text ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_FUNCTIONMAP_H
#define TP_SIMULATOR_CORE_FUNCTIONMAP_H

#include "simulator/core/Program.h"

#include <cstdint>
#include <vector>

namespace tp {

/// Which function of the text a word belongs to. A function reaches to the next
/// one.
class FunctionMap {
public:
  /// Functions begin at these words of \p Text, at its entry, and where direct
  /// calls go.
  FunctionMap(const Program &Text, std::vector<uint32_t> Entries);

  /// The number of a word's function.
  uint32_t functionOf(uint32_t Word) const { return FunctionOfWord[Word]; }
  /// The first word of a function.
  uint32_t entryOf(uint32_t Function) const { return Entries[Function]; }

private:
  std::vector<uint32_t> Entries;
  std::vector<uint32_t> FunctionOfWord;
};

/// What an instruction may do to the chain of calls of a thread.
enum class Transfer : uint8_t {
  /// Nothing.
  None,
  /// It calls if it goes to its target.
  Call,
  /// It goes back to behind a call.
  Return,
  /// It may leave the function for another without a way back.
  Jump,
};

/// Of each word of the text.
std::vector<Transfer> transfersOf(const Program &Text,
                                  const FunctionMap &Functions);

} // namespace tp

#endif // TP_SIMULATOR_CORE_FUNCTIONMAP_H
