//===- TmRunner.cpp - What one host thread works on -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/TmRunner.h"

#include <algorithm>

namespace tp {

/// The bytes of [Address, Address + Bytes) that [Other, Other + OtherBytes)
/// covers, as a bit mask from the lowest address on.
static unsigned overlap(uint32_t Address, unsigned Bytes, uint32_t Other,
                        unsigned OtherBytes) {
  unsigned Mask = 0;
  for (unsigned I = 0; I != Bytes; ++I)
    Mask |= unsigned(Address + I - Other < OtherBytes) << I;
  return Mask;
}

void TmRunnerState::growLog() {
  Log.reserve(std::max<size_t>(256, 2 * Log.capacity()));
}

void TmRunnerState::countMarker(uint32_t Number) {
  if (Number >= Markers.size())
    Markers.resize(Number + 1);
  ++Markers[Number];
}

std::optional<Opcode> TmRunnerState::forwardOwn(uint32_t Address,
                                                unsigned Bytes,
                                                uint32_t &Value) const {
  unsigned Missing = (1u << Bytes) - 1;
  for (size_t I = Log.size(); I != OwnLogBegin && Missing != 0; --I) {
    const GlobalAccess &Access = Log[I - 1];
    switch (Access.Kind) {
    case GlobalAccess::HostCall:
      break;
    case GlobalAccess::Stream:
      return ready::producerOf(Access.Ready);
    case GlobalAccess::Atomic:
      if (overlap(Address, Bytes, Access.Address, 4) & Missing)
        return ready::producerOf(Access.Ready);
      break;
    case GlobalAccess::Store: {
      unsigned Found =
          overlap(Address, Bytes, Access.Address, Access.Bytes) & Missing;
      for (unsigned Byte = 0; Byte != Bytes; ++Byte) {
        if (!(Found >> Byte & 1))
          continue;
        uint32_t From = (Address + Byte - Access.Address) * 8;
        uint32_t Stored = Access.Value >> From & 0xFF;
        Value = (Value & ~(0xFFu << Byte * 8)) | Stored << Byte * 8;
      }
      Missing &= ~Found;
      break;
    }
    }
  }
  return std::nullopt;
}

} // namespace tp
