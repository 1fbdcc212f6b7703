//===- memory.h - Pointers and 32-bit addresses -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Shared structures hold 32-bit addresses, never pointers, so that the host and
// the chip lay them out alike. These functions turn one into the other.
//
//===----------------------------------------------------------------------===//

#ifndef TP_MEMORY_H
#define TP_MEMORY_H

#include "tp/launch.h"

namespace tp {

#ifdef __tp__

/// A pointer to the object at \p Address of global memory.
template <typename T> inline T *devicePointer(DeviceAddress Address) {
  return reinterpret_cast<T *>(Address);
}

/// The address of the object that \p Pointer points to.
inline DeviceAddress deviceAddress(const void *Pointer) {
  return reinterpret_cast<DeviceAddress>(Pointer);
}

#else

namespace host {
void *hostPointer(DeviceAddress Address);
DeviceAddress deviceAddress(const void *Pointer);
} // namespace host

template <typename T> inline T *devicePointer(DeviceAddress Address) {
  return static_cast<T *>(host::hostPointer(Address));
}

inline DeviceAddress deviceAddress(const void *Pointer) {
  return host::deviceAddress(Pointer);
}

#endif

} // namespace tp

#endif // TP_MEMORY_H
