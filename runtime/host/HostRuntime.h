//===- HostRuntime.h - Running a kernel natively ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What a native runner of kernels needs beside the device API of tp/*.h: the
// memory that stands for the TP's global memory, and the threads that run the
// kernel's `main` (compiled with -Dmain=tpKernelMain).
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_HOST_HOSTRUNTIME_H
#define TP_RUNTIME_HOST_HOSTRUNTIME_H

#include "tp/launch.h"
#include <stdint.h>

namespace tp {
namespace host {

/// Takes \p Bytes of zeroed memory at a multiple of \p Alignment (a power of
/// two) out of the arena that stands for global memory: 32-bit addresses from
/// 0x00010000 on, as on the chip. Ends the process with a message when the
/// 4 GiB are used up.
DeviceAddress allocate(uint32_t Bytes, uint32_t Alignment = 16);

/// Where the arena's \p Address lies in the process; nullptr for 0.
void *hostPointer(DeviceAddress Address);

/// The arena's address of \p Pointer, which must point into it; 0 for nullptr.
DeviceAddress deviceAddress(const void *Pointer);

/// Forgets every allocation. The memory reads as zero again.
void resetMemory();

/// Bytes of each thread's local store if nobody sets them: those of the
/// report's chip.
inline constexpr uint32_t kDefaultLocalStoreBytes = 16 * 1024;

/// Gives each thread \p Bytes (a multiple of 16) of local store, all of it free
/// for the program (tp/local_store.h). Not while a kernel runs.
void setLocalStoreBytes(uint32_t Bytes);

} // namespace host

/// Runs \p KernelMain once on each of \p Threads threads with the ids 0 to
/// \p Threads - 1 (one TM with that many TPs) and the launch block \p Launch,
/// whose arguments it gets. One thread runs on the caller's own thread, so that
/// a debugger and the order of everything are plain. Returns the first non-zero
/// status in the order of the threads, else 0. Not reentrant.
int runOnHost(int (*KernelMain)(int ArgumentCount, char **Arguments),
              unsigned Threads, const LaunchBlock &Launch);
int runOnHost(int (*KernelMain)(), unsigned Threads, const LaunchBlock &Launch);

} // namespace tp

#endif // TP_RUNTIME_HOST_HOSTRUNTIME_H
