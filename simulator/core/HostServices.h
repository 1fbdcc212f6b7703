//===- HostServices.h - Streams and host calls ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_HOSTSERVICES_H
#define TP_SIMULATOR_CORE_HOSTSERVICES_H

#include "simulator/core/AddressSpace.h"
#include "simulator/core/Engine.h"
#include "simulator/isa/StreamAccess.h"

#include <optional>

namespace tp {

/// Global memory for a stream operation; remembers the first bad access.
class SharedStreamMemory : public StreamMemory {
public:
  SharedStreamMemory(const AddressSpace &Space, uint32_t Descriptor)
      : Space(Space), Descriptor(Descriptor) {}

  uint32_t load(uint32_t Address) override;
  void store(uint32_t Address, uint32_t Value) override;
  void reject() override { fail(TrapKind::BadStream, Descriptor); }
  /// Whether the word may be accessed; if not, the operation has failed.
  bool check(uint32_t Address);

  bool failed() const { return Failed; }
  TrapKind kind() const { return Kind; }
  uint32_t address() const { return Address; }

private:
  void fail(TrapKind NewKind, uint32_t NewAddress);

  const AddressSpace &Space;
  uint32_t Descriptor;
  bool Failed = false;
  TrapKind Kind = TrapKind::BadStream;
  uint32_t Address = 0;
};

/// A host call and its three arguments.
struct HostCall {
  uint32_t Service;
  uint32_t First;
  uint32_t Second;
  uint32_t Third;
};

/// Does \p Call for the thread with this local store. Gives its result, or
/// nothing if it is bad; then \p Bad says why.
std::optional<uint32_t> serveHostCall(const HostCall &Call,
                                      const AddressSpace &Space,
                                      uintptr_t LocalStoreBias,
                                      const OutputFunction &Output, Trap &Bad);

} // namespace tp

#endif // TP_SIMULATOR_CORE_HOSTSERVICES_H
