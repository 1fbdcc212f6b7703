//===- Disassembler.h - Instructions as text --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_LOADER_DISASSEMBLER_H
#define TP_SIMULATOR_LOADER_DISASSEMBLER_H

#include <cstdint>
#include <memory>
#include <string>

namespace tp {

/// Shows the instructions of a linked program as tp-objdump does.
class Disassembler {
public:
  Disassembler();
  ~Disassembler();

  /// The instruction \p Word at \p Pc: mnemonic, a space, operands; targets of
  /// branches as addresses. Of what is no instruction `.word` and its value.
  std::string print(uint32_t Word, uint32_t Pc);

private:
  struct Backend;
  std::unique_ptr<Backend> Implementation;
};

} // namespace tp

#endif // TP_SIMULATOR_LOADER_DISASSEMBLER_H
