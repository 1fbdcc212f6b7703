//===- WindowCommit.cpp - Accesses taking effect at a window's end --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/WindowCommit.h"
#include "simulator/core/HostServices.h"

#include <algorithm>

namespace tp {

void WindowCommit::add(const std::vector<GlobalAccess> &Log) {
  for (const GlobalAccess &Access : Log)
    Order.push_back({Access.Key, &Access});
}

uint32_t WindowCommit::load(uint32_t Address) const {
  uint32_t Value;
  std::memcpy(&Value, Space.Global + Address, sizeof(Value));
  return Value;
}

void WindowCommit::store(uint32_t Address, uint32_t Value, unsigned Bytes) {
  std::memcpy(Space.Global + Address, &Value, Bytes);
}

void WindowCommit::announce(const GlobalAccess &Access, uint64_t WindowStart,
                            uint32_t Address, uint32_t Bytes) const {
  if (Observer)
    Observer->writing({WindowStart + (Access.Key >> 32), Access.Owner->Number,
                       Access.Pc, Address, Bytes});
}

namespace {
/// Tells of each word before it changes.
template <class Function>
class AnnouncedStreamMemory final : public SharedStreamMemory {
public:
  AnnouncedStreamMemory(const AddressSpace &Space, uint32_t Descriptor,
                        Function Announce)
      : SharedStreamMemory(Space, Descriptor), Announce(std::move(Announce)) {}

  void store(uint32_t Address, uint32_t Value) override {
    if (!check(Address))
      return;
    Announce(Address);
    SharedStreamMemory::store(Address, Value);
  }

private:
  Function Announce;
};
} // namespace

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
      announce(Access, WindowStart, Access.Address, Access.Bytes);
      store(Access.Address, Access.Value, Access.Bytes);
      continue;
    case GlobalAccess::Atomic:
      announce(Access, WindowStart, Access.Address, 4);
      Result = load(Access.Address);
      store(Access.Address,
            Access.AtomicOperation(Result, Access.Value, Access.Extra), 4);
      break;
    case GlobalAccess::Stream: {
      AnnouncedStreamMemory Stream(
          Space, Access.Address,
          [&](uint32_t Address) { announce(Access, WindowStart, Address, 4); });
      Result = Access.StreamOperation(Stream, Access.Address, Access.Value);
      Failed = Stream.failed();
      Bad.Kind = Stream.kind();
      Bad.Address = Stream.address();
      break;
    }
    case GlobalAccess::HostCall: {
      std::optional<uint32_t> Answer = serveHostCall(
          {Access.Service, Access.Extra, Access.Address, Access.Value}, Space,
          Access.Owner->LocalStoreBias, Output, Bad);
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
