//===- ChipLimits.h - What chips may be -------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPLIMITS_H
#define TP_SIMULATOR_CHIP_CHIPLIMITS_H

#include <cstdint>

namespace tp {

inline constexpr uint32_t MaxThreads = 1u << 20;
inline constexpr uint32_t MaxTpsPerTm = 1024;
inline constexpr uint32_t MaxUnitCount = 1024;
inline constexpr uint32_t MaxUnitInterval = 1024;
inline constexpr uint32_t MaxLatency = 4096;
inline constexpr uint32_t MaxIcacheBanks = 64;
inline constexpr uint32_t MaxIcachePorts = 1024;
/// The topmost MiB of the address space belongs to the local stores. Below them
/// at least another MiB traps, so that a stack that overflows does not run into
/// global memory.
inline constexpr uint32_t MaxLocalStoreBytes = 1u << 20;
inline constexpr uint64_t MaxMemoryBytes =
    (1ull << 32) - 2 * uint64_t(MaxLocalStoreBytes);
/// The first 64 KiB trap; a program needs some memory behind them.
inline constexpr uint64_t MinMemoryBytes = 128 << 10;

inline constexpr uint32_t MaxStoreBufferEntries = 64;
inline constexpr uint64_t MaxCacheBytes = 1ull << 30;
inline constexpr uint32_t MaxLineBytes = 4096;
inline constexpr uint32_t MinSectorBytes = 4;
inline constexpr uint32_t MaxSectorsPerLine = 16;
inline constexpr uint32_t MaxCacheWays = 1024;
inline constexpr uint32_t MaxCacheBanks = 64;
inline constexpr uint32_t MaxMissRegisters = 65535;
inline constexpr uint32_t MaxPortBytes = 1024;
inline constexpr uint32_t MaxDramChannels = 256;
/// Of a channel: its controller has a bit for each.
inline constexpr uint32_t MaxDramBanks = 64;
inline constexpr uint32_t MaxDramTicks = 1u << 20;
inline constexpr uint32_t MaxDramQueue = 4096;

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPLIMITS_H
