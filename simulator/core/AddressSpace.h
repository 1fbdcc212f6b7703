//===- AddressSpace.h - What a thread may access ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ADDRESSSPACE_H
#define TP_SIMULATOR_CORE_ADDRESSSPACE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/LocalStore.h"
#include "simulator/core/Memory.h"
#include "simulator/core/Program.h"
#include "simulator/isa/TrapKind.h"

#include <cstdint>

namespace tp {

/// The addresses of a program on a chip, made for one comparison per access.
struct AddressSpace {
  /// Host address of simulated address 0 of global memory.
  uint8_t *Global = nullptr;
  uint32_t TextBegin = 0;
  uint32_t TextWords = 0;
  /// From TextBegin on.
  uint32_t ReadOnlyBytes = 0;
  /// From kGlobalMemoryBegin on.
  uint32_t GlobalBytes = 0;
  uint32_t LocalBegin = 0;
  uint32_t LocalBytes = 0;

  AddressSpace() = default;
  AddressSpace(const ChipConfig &Chip, const Program &Text, Memory &Memory)
      : Global(Memory.data()), TextBegin(Text.textBegin()),
        TextWords(uint32_t(Text.instructions().size())),
        ReadOnlyBytes(Text.readOnlyEnd() - Text.textBegin()),
        GlobalBytes(uint32_t(Memory.size() - kGlobalMemoryBegin)) {
    LocalStoreRange Local(Chip.LocalStoreBytes);
    LocalBegin = Local.Begin;
    LocalBytes = Local.Size;
  }

  /// Of the first byte of an aligned access.
  bool isLocal(uint32_t At) const { return At - LocalBegin < LocalBytes; }
  bool isGlobal(uint32_t At) const {
    return At - kGlobalMemoryBegin < GlobalBytes;
  }
  bool isReadOnly(uint32_t At) const { return At - TextBegin < ReadOnlyBytes; }
  bool isWritable(uint32_t At) const { return isGlobal(At) && !isReadOnly(At); }

  /// Why an access to neither kind of memory traps.
  static TrapKind badAddress(uint32_t At) {
    return At < kGlobalMemoryBegin ? TrapKind::NullAccess
                                   : TrapKind::AddressOutOfRange;
  }
  /// Why a store traps that is not isLocal() and not isWritable().
  TrapKind badStore(uint32_t At) const {
    return isGlobal(At) ? TrapKind::StoreToReadOnly : badAddress(At);
  }
};

/// Distance of the threads' local stores in the host's memory. Threads use the
/// same addresses at the same time: a few cache lines more than a power of two
/// keep them in different sets of the host's caches.
inline uintptr_t localStoreStride(const ChipConfig &Chip) {
  return Chip.LocalStoreBytes + 5 * 64;
}

/// Host address that simulated address 0 of thread \p Number would have if all
/// of the address space were as its local store is; \p Stores holds the local
/// stores of all threads.
inline uintptr_t localStoreBias(const ChipConfig &Chip, const HostPages &Stores,
                                uint32_t Number) {
  return reinterpret_cast<uintptr_t>(Stores.data()) +
         Number * localStoreStride(Chip) -
         LocalStoreRange(Chip.LocalStoreBytes).Begin;
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_ADDRESSSPACE_H
