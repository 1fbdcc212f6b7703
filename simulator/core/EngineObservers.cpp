//===- EngineObservers.cpp - Who watches an engine ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/EngineObservers.h"
#include "simulator/core/TmRunner.h"

namespace tp {

static bool readByte(const Thread &T, const TmRunnerState &Runner,
                     uint32_t Address, uint8_t &Byte) {
  if (Runner.Chip.isLocal(Address)) {
    Byte = *reinterpret_cast<const uint8_t *>(T.LocalStoreBias + Address);
    return true;
  }
  if (!Runner.Chip.isGlobal(Address))
    return false;
  uint32_t Bits = Runner.Chip.Global[Address];
  Runner.forwardOwn(Address, 1, Bits);
  Byte = uint8_t(Bits);
  return true;
}

bool readAsThread(const Thread &T, const TmRunnerState &Runner,
                  uint32_t Address, std::span<uint8_t> Bytes) {
  for (uint8_t &Byte : Bytes)
    if (!readByte(T, Runner, Address++, Byte))
      return false;
  return true;
}

} // namespace tp
