//===- Scene.h - A scene as triangles in world space ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_LOADER_SCENE_H
#define TP_SCENES_LOADER_SCENE_H

#include "kernels/common/Vector3.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// A diffuse surface. Colours are linear RGB.
struct Material {
  std::string Name;
  /// Share of the light that is reflected; glTF's baseColorFactor.
  Vector3 BaseColor = {1, 1, 1};
  /// Emitted radiance, from both sides; emissiveFactor x emissiveStrength.
  Vector3 Emission = {0, 0, 0};

  bool isEmissive() const {
    return Emission.X > 0 || Emission.Y > 0 || Emission.Z > 0;
  }
};

/// A triangle in world space, counter-clockwise seen from its front. Its area
/// is not zero.
struct Triangle {
  Vector3 Vertices[3];
  /// Index into Scene::Materials.
  uint32_t Material = 0;
};

/// A pinhole camera. Right, Up and Forward are an orthonormal frame in world
/// space.
struct Camera {
  Vector3 Position;
  Vector3 Right = {1, 0, 0};
  Vector3 Up = {0, 1, 0};
  Vector3 Forward = {0, 0, -1};
  /// Vertical field of view in radians.
  float VerticalFieldOfView = 1;
};

/// What there is to render. Triangles and Materials are not empty.
struct Scene {
  std::vector<Triangle> Triangles;
  std::vector<Material> Materials;
  tp::Camera Camera;
  /// What the file asked for and the renderer does not do, one sentence each.
  std::vector<std::string> Warnings;
};

} // namespace tp

#endif // TP_SCENES_LOADER_SCENE_H
