//===- SceneFlattener.h - From a scene to its memory block ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_SCENEFLATTENER_H
#define TP_KERNELS_COMMON_SCENEFLATTENER_H

#include "scenes/loader/Scene.h"

#include <cstdint>
#include <vector>

namespace tp {

/// Who builds a scene's BVH: the host before the start, or the kernel, in the
/// scene's BvhWorkspace.
enum class BvhOrigin : uint8_t { Host, Kernel };

/// The scene as SceneLayout.h describes it, with its BVH or a BvhWorkspace. The
/// block must be placed at a multiple of kSceneAlignment. Behind each array are
/// at least \p PaddingBytes that nobody uses.
std::vector<uint8_t> flattenScene(const Scene &Source,
                                  BvhOrigin Origin = BvhOrigin::Host,
                                  uint32_t PaddingBytes = 0);

} // namespace tp

#endif // TP_KERNELS_COMMON_SCENEFLATTENER_H
