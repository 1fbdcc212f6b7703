//===- EmbreeScene.h - A scene as Embree sees it ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_EMBREE_EMBREESCENE_H
#define TP_KERNELS_EMBREE_EMBREESCENE_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/SceneLayout.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace tp {

/// The triangles of a scene under the same numbers in Embree, which finds hits
/// with code of its own, in its robust mode.
class EmbreeScene {
public:
  explicit EmbreeScene(const SceneView &Scene);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene &) = delete;
  EmbreeScene &operator=(const EmbreeScene &) = delete;

  /// The first triangle that \p R meets.
  Hit findClosestHit(const Ray &R) const;
  /// Whether \p R meets any triangle before \p MaxDistance.
  bool isBlocked(const Ray &R, float MaxDistance) const;

private:
  RTCDeviceTy *Device;
  RTCSceneTy *World;
};

} // namespace tp

#endif // TP_KERNELS_EMBREE_EMBREESCENE_H
