//===- launch.h - What the host tells a program at its start ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One layout for the device, the native host twin and the simulator, which
// finds the block by the symbol `__tp_launch` and fills it before the start.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LAUNCH_H
#define TP_LAUNCH_H

#include <stdint.h>

namespace tp {

/// An address in the TP's 32-bit space. On the host it is an offset from the
/// start of the memory that the host twin offers as the TP's global memory.
using DeviceAddress = uint32_t;

/// Filled by the simulator (or the host twin) before the first instruction.
/// Addresses are 0 where the run has no such thing.
struct LaunchBlock {
  /// kLaunchBlockVersion of the writer.
  uint32_t Version;
  /// Number of program arguments and the address of an array of that many
  /// addresses of zero-terminated strings, followed by a zero.
  uint32_t ArgumentCount;
  DeviceAddress Arguments;
  /// Free global memory: [HeapBegin, HeapEnd).
  DeviceAddress HeapBegin;
  DeviceAddress HeapEnd;
  /// Flattened scene (kernels/common/SceneLayout.h).
  DeviceAddress Scene;
  /// Output, Width x Height pixels, one uint32_t each: red in the lowest byte,
  /// then green, blue, alpha. Row 0 is the top.
  DeviceAddress Framebuffer;
  uint32_t Width;
  uint32_t Height;
  uint32_t SamplesPerPixel;
  /// Bounces: 1 is primary rays with their shadow rays.
  uint32_t MaxDepth;
  /// Seed of the kernel's random numbers.
  uint32_t Seed;
  /// Array of one uint32_t per thread: rays that the thread has traced.
  DeviceAddress RayCounts;
  /// One uint32_t, zero at the start: how many pieces of the work have been
  /// taken, by atomic increment.
  DeviceAddress WorkCounter;
};

inline constexpr uint32_t kLaunchBlockVersion = 3;

static_assert(sizeof(LaunchBlock) == 14 * sizeof(uint32_t),
              "the launch block has one layout on every side");

#ifdef __tp__

extern "C" LaunchBlock __tp_launch;

/// The launch block of this run.
inline const LaunchBlock &launchBlock() { return __tp_launch; }

#else

const LaunchBlock &launchBlock();

#endif

} // namespace tp

#endif // TP_LAUNCH_H
