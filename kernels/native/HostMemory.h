//===- HostMemory.h - The host runtime's arena as launch memory -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_NATIVE_HOSTMEMORY_H
#define TP_KERNELS_NATIVE_HOSTMEMORY_H

#include "kernels/common/LaunchSetup.h"
#include "runtime/host/HostRuntime.h"

#include <cstring>

namespace tp {

/// The memory that natively compiled kernels see.
class HostMemory : public LaunchMemory {
public:
  DeviceAddress allocate(size_t Bytes, uint32_t Alignment) override {
    return Bytes <= UINT32_MAX ? host::allocate(uint32_t(Bytes), Alignment) : 0;
  }
  void write(DeviceAddress Address, const void *Source, size_t Bytes) override {
    std::memcpy(host::hostPointer(Address), Source, Bytes);
  }
  void read(DeviceAddress Address, void *Target, size_t Bytes) const override {
    std::memcpy(Target, host::hostPointer(Address), Bytes);
  }
};

} // namespace tp

#endif // TP_KERNELS_NATIVE_HOSTMEMORY_H
