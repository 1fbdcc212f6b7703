//===- HostServices.cpp - Streams and host calls --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/HostServices.h"

#include "runtime/include/tp/host_call.h"

#include <algorithm>

namespace tp {

/// Longer writes write this much.
static constexpr uint32_t MaxHostCallWrite = 4096;

uint32_t SharedStreamMemory::load(uint32_t Address) {
  if (!check(Address))
    return 0;
  uint32_t Value;
  std::memcpy(&Value, Space.Global + Address, sizeof(Value));
  return Value;
}

void SharedStreamMemory::store(uint32_t Address, uint32_t Value) {
  if (check(Address))
    std::memcpy(Space.Global + Address, &Value, sizeof(Value));
}

/// Whether all of [Address, Address + Bytes) is global memory.
static bool isAllGlobal(const AddressSpace &Space, uint32_t Address,
                        uint32_t Bytes) {
  return Space.isGlobal(Address) &&
         Bytes <= Space.GlobalBytes - (Address - kGlobalMemoryBegin);
}

bool SharedStreamMemory::check(uint32_t Address) {
  if (!isAllGlobal(Space, Address, 4))
    fail(TrapKind::AddressOutOfRange, Address);
  else if (Space.isReadOnly(Address))
    fail(TrapKind::StoreToReadOnly, Address);
  return !Failed;
}

void SharedStreamMemory::fail(TrapKind NewKind, uint32_t NewAddress) {
  if (Failed)
    return;
  Failed = true;
  Kind = NewKind;
  Address = NewAddress;
}

/// Host address of [Address, Address + Bytes) as the thread sees it, or null.
static const uint8_t *hostAddress(const AddressSpace &Space,
                                  uintptr_t LocalStoreBias, uint32_t Address,
                                  uint32_t Bytes) {
  if (isAllGlobal(Space, Address, Bytes))
    return Space.Global + Address;
  if (Space.isLocal(Address) &&
      Bytes <= Space.LocalBytes - (Address - Space.LocalBegin))
    return reinterpret_cast<const uint8_t *>(LocalStoreBias + Address);
  return nullptr;
}

std::optional<uint32_t> serveHostCall(const HostCall &Call,
                                      const AddressSpace &Space,
                                      uintptr_t LocalStoreBias,
                                      const OutputFunction &Output, Trap &Bad) {
  uint32_t Fd = Call.First;
  if (Call.Service != kHostCallWrite || (Fd != 1 && Fd != 2)) {
    Bad.Kind = TrapKind::BadHostCall;
    Bad.Address = Call.Service;
    return std::nullopt;
  }
  uint32_t Bytes = std::min(Call.Third, MaxHostCallWrite);
  if (Bytes == 0)
    return 0;
  const uint8_t *Source =
      hostAddress(Space, LocalStoreBias, Call.Second, Bytes);
  if (!Source) {
    Bad.Kind = AddressSpace::badAddress(Call.Second);
    Bad.Address = Call.Second;
    return std::nullopt;
  }
  if (Output)
    Output(int(Fd),
           std::string_view(reinterpret_cast<const char *>(Source), Bytes));
  return Bytes;
}

} // namespace tp
