//===- EmbreeScene.cpp - A scene as Embree sees it ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/embree/EmbreeScene.h"

#include <cstring>
#include <embree3/rtcore.h>
#include <limits>

namespace tp {

EmbreeScene::EmbreeScene(const SceneView &Scene)
    : Device(rtcNewDevice("threads=1")), World(rtcNewScene(Device)) {
  RTCGeometry Geometry = rtcNewGeometry(Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const size_t Count = Scene.Header->TriangleCount;
  auto *Corners = static_cast<Vector3 *>(
      rtcSetNewGeometryBuffer(Geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                              RTC_FORMAT_FLOAT3, sizeof(Vector3), 3 * Count));
  auto *Indices = static_cast<uint32_t *>(
      rtcSetNewGeometryBuffer(Geometry, RTC_BUFFER_TYPE_INDEX, 0,
                              RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), Count));
  for (size_t Triangle = 0; Triangle != Count; ++Triangle)
    std::memcpy(Corners + 3 * Triangle, Scene.Triangles[Triangle].Corners,
                3 * sizeof(Vector3));
  for (size_t Corner = 0; Corner != 3 * Count; ++Corner)
    Indices[Corner] = uint32_t(Corner);
  rtcCommitGeometry(Geometry);
  rtcAttachGeometry(World, Geometry);
  rtcReleaseGeometry(Geometry);
  rtcSetSceneFlags(World, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(World);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(World);
  rtcReleaseDevice(Device);
}

static RTCRay makeRay(const Ray &R, float MaxDistance) {
  RTCRay Result{};
  Result.org_x = R.Origin.X;
  Result.org_y = R.Origin.Y;
  Result.org_z = R.Origin.Z;
  Result.dir_x = R.Direction.X;
  Result.dir_y = R.Direction.Y;
  Result.dir_z = R.Direction.Z;
  Result.tfar = MaxDistance;
  Result.mask = ~0u;
  return Result;
}

Hit EmbreeScene::findClosestHit(const Ray &R) const {
  RTCRayHit Query{makeRay(R, std::numeric_limits<float>::infinity()), {}};
  Query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext Context;
  rtcInitIntersectContext(&Context);
  rtcIntersect1(World, &Context, &Query);
  if (Query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    return {Query.ray.tfar, kNoTriangle};
  return {Query.ray.tfar, Query.hit.primID};
}

bool EmbreeScene::isBlocked(const Ray &R, float MaxDistance) const {
  RTCRay Query = makeRay(R, MaxDistance);
  RTCIntersectContext Context;
  rtcInitIntersectContext(&Context);
  rtcOccluded1(World, &Context, &Query);
  return Query.tfar < 0;
}

} // namespace tp
