//===- LaunchSetup.h - Preparing a rendering kernel's run -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What the native runner and the simulator do alike: place scene, framebuffer
// and counters in the kernel's memory, fill the launch block, and read back the
// picture.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_LAUNCHSETUP_H
#define TP_KERNELS_COMMON_LAUNCHSETUP_H

#include "kernels/common/SceneFlattener.h"
#include "scenes/ErrorOr.h"
#include "scenes/image/Image.h"
#include "scenes/loader/Scene.h"
#include "tp/launch.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tp {

/// The kernel's global memory, seen from the host.
class LaunchMemory {
public:
  virtual ~LaunchMemory() = default;

  /// Zeroed memory at a multiple of \p Alignment (a power of two), or 0 if
  /// there is no room.
  virtual DeviceAddress allocate(size_t Bytes, uint32_t Alignment) = 0;
  /// Copies to and from memory that allocate() gave.
  virtual void write(DeviceAddress Address, const void *Source,
                     size_t Bytes) = 0;
  virtual void read(DeviceAddress Address, void *Target,
                    size_t Bytes) const = 0;
};

/// What the user may choose of a rendering.
struct RenderOptions {
  uint32_t Width = 256;
  uint32_t Height = 256;
  uint32_t SamplesPerPixel = 1;
  /// Surfaces that a path visits: 1 is primary rays with their shadow rays.
  uint32_t MaxDepth = 1;
  uint32_t Seed = 1;
  BvhOrigin Bvh = BvhOrigin::Host;
  /// Unused bytes behind each array of the scene and each other thing that the
  /// kernel gets.
  uint32_t PaddingBytes = 0;
};

inline constexpr uint32_t kMaxImageSide = 16384;
inline constexpr uint32_t kMaxSamplesPerPixel = 1u << 20;
inline constexpr uint32_t kMaxPathDepth = 1u << 16;

/// Fails, naming the option as `--size`, `--spp` or `--depth`, if a value is 0
/// or above its limit.
Status checkRenderOptions(const RenderOptions &Options);

/// Reads `WIDTHxHEIGHT` into \p Options; fails, naming `--size`, if \p Text is
/// not that or out of limits.
Status parseImageSize(std::string_view Text, RenderOptions &Options);

/// Reads `host` or `kernel` into \p Options; fails, naming `--bvh`, if \p Text
/// is neither.
Status parseBvhOrigin(std::string_view Text, RenderOptions &Options);

/// Places everything that a rendering kernel needs on \p ThreadCount threads
/// and returns a launch block with the version, the scene, the framebuffer, the
/// options and the counters filled in; arguments and heap are 0. Fails if
/// \p Memory has no room.
ErrorOr<LaunchBlock> setUpLaunch(const Scene &Source,
                                 const RenderOptions &Options,
                                 uint32_t ThreadCount, LaunchMemory &Memory);

/// The picture that a finished kernel left in its framebuffer.
Image readFramebuffer(const LaunchBlock &Launch, const LaunchMemory &Memory);

/// The rays that each of \p ThreadCount threads of a finished kernel traced.
std::vector<uint32_t> readRayCounts(const LaunchBlock &Launch,
                                    uint32_t ThreadCount,
                                    const LaunchMemory &Memory);

/// Pixels that \p ThreadCount threads have taken so far from their PixelQueue:
/// how far a running kernel is.
uint32_t readPixelsTaken(const LaunchBlock &Launch, uint32_t ThreadCount,
                         const LaunchMemory &Memory);

} // namespace tp

#endif // TP_KERNELS_COMMON_LAUNCHSETUP_H
