//===- WindowCommit.cpp - Accesses taking effect at a window's end --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowCommit.h"
#include "runtime/include/tp/host_call.h"
#include "simulator/core/LocalStore.h"

#include <algorithm>

namespace tp {

/// Longer writes write this much.
static constexpr uint32_t MaxHostCallWrite = 4096;

/// Global memory for stream operations; remembers the first bad access.
class WindowCommit::SharedStreamMemory final : public StreamMemory {
public:
  SharedStreamMemory(WindowCommit &Commit, uint32_t Descriptor)
      : Commit(Commit), Descriptor(Descriptor) {}

  uint32_t load(uint32_t Address) override {
    return check(Address) ? Commit.load(Address) : 0;
  }

  void store(uint32_t Address, uint32_t Value) override {
    if (check(Address))
      Commit.store(Address, Value, 4);
  }

  void reject() override { fail(TrapKind::BadStream, Descriptor); }

  bool failed() const { return Failed; }
  TrapKind kind() const { return Kind; }
  uint32_t address() const { return Address; }

private:
  bool check(uint32_t Address) {
    if (!Commit.Global.contains(Address, 4))
      fail(TrapKind::AddressOutOfRange, Address);
    else if (Address - Commit.Text.textBegin() <
             Commit.Text.readOnlyEnd() - Commit.Text.textBegin())
      fail(TrapKind::StoreToReadOnly, Address);
    return !Failed;
  }

  void fail(TrapKind NewKind, uint32_t NewAddress) {
    if (Failed)
      return;
    Failed = true;
    Kind = NewKind;
    Address = NewAddress;
  }

  WindowCommit &Commit;
  uint32_t Descriptor;
  bool Failed = false;
  TrapKind Kind = TrapKind::BadStream;
  uint32_t Address = 0;
};

WindowCommit::WindowCommit(Memory &Global, const Program &Text,
                           uint32_t LocalStoreBytes)
    : Global(Global), Text(Text), LocalStoreBytes(LocalStoreBytes) {}

void WindowCommit::add(const std::vector<GlobalAccess> &Log) {
  for (const GlobalAccess &Access : Log)
    Order.push_back({Access.Key, &Access});
}

uint32_t WindowCommit::load(uint32_t Address) const {
  uint32_t Value;
  std::memcpy(&Value, Global.data() + Address, sizeof(Value));
  return Value;
}

void WindowCommit::store(uint32_t Address, uint32_t Value, unsigned Bytes) {
  std::memcpy(Global.data() + Address, &Value, Bytes);
}

const uint8_t *WindowCommit::hostAddress(const Thread &Owner, uint32_t Address,
                                         uint32_t Bytes) const {
  if (Global.contains(Address, Bytes))
    return Global.data() + Address;
  LocalStoreRange Local(LocalStoreBytes);
  if (Local.contains(Address, Bytes))
    return reinterpret_cast<const uint8_t *>(Owner.LocalStoreBias + Address);
  return nullptr;
}

std::optional<uint32_t> WindowCommit::hostCall(const GlobalAccess &Access,
                                               Trap &Bad) {
  uint32_t Fd = Access.Extra;
  if (Access.Service != kHostCallWrite || (Fd != 1 && Fd != 2)) {
    Bad.Kind = TrapKind::BadHostCall;
    Bad.Address = Access.Service;
    return std::nullopt;
  }
  uint32_t Bytes = std::min(Access.Value, MaxHostCallWrite);
  if (Bytes == 0)
    return 0;
  const uint8_t *Source = hostAddress(*Access.Owner, Access.Address, Bytes);
  if (!Source) {
    Bad.Kind = Access.Address < kGlobalMemoryBegin
                   ? TrapKind::NullAccess
                   : TrapKind::AddressOutOfRange;
    Bad.Address = Access.Address;
    return std::nullopt;
  }
  if (Output)
    Output(int(Fd),
           std::string_view(reinterpret_cast<const char *>(Source), Bytes));
  return Bytes;
}

void WindowCommit::commit(uint64_t WindowStart,
                          std::optional<PendingTrap> &FirstTrap) {
  std::sort(Order.begin(), Order.end());
  for (const Entry &E : Order) {
    const GlobalAccess &Access = *E.Access;
    uint32_t Result = 0;
    Trap Bad;
    bool Failed = false;
    switch (Access.Kind) {
    case GlobalAccess::Store:
      store(Access.Address, Access.Value, Access.Bytes);
      continue;
    case GlobalAccess::Atomic:
      Result = load(Access.Address);
      store(Access.Address,
            Access.AtomicOperation(Result, Access.Value, Access.Extra), 4);
      break;
    case GlobalAccess::Stream: {
      SharedStreamMemory Stream(*this, Access.Address);
      Result = Access.StreamOperation(Stream, Access.Address, Access.Value);
      Failed = Stream.failed();
      Bad.Kind = Stream.kind();
      Bad.Address = Stream.address();
      break;
    }
    case GlobalAccess::HostCall: {
      std::optional<uint32_t> Answer = hostCall(Access, Bad);
      Failed = !Answer;
      Result = Answer.value_or(0);
      break;
    }
    }
    if (Failed) {
      Bad.Thread = Access.Owner->Number;
      Bad.Pc = Access.Pc;
      Bad.Cycle = WindowStart + (Access.Key >> 32);
      keepFirst(FirstTrap, {Access.Key, Bad});
    } else if (Access.Owner->Ready[Access.Destination] == Access.Ready) {
      Access.Owner->Registers[Access.Destination] = Result;
    }
  }
  Order.clear();
}

} // namespace tp
