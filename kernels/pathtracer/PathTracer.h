//===- PathTracer.h - The path tracer ---------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Every thread takes pixels until none is left. At each hit a shadow ray goes
// to a random point of the lights, then a cosine-weighted ray bounces on, until
// the path has the launch block's depth. Emission is seen directly by primary
// rays only; for all later vertices the shadow rays account for it.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PATHTRACER_PATHTRACER_H
#define TP_KERNELS_PATHTRACER_PATHTRACER_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/ColorEncoding.h"
#include "kernels/common/EarlyLoad.h"
#include "kernels/common/PixelQueue.h"
#include "kernels/common/Random.h"
#include "kernels/common/RayEvents.h"
#include "kernels/common/Sampling.h"
#include "kernels/common/SceneLayout.h"
#include "tp/barrier.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include "tp/thread.h"

namespace tp {

/// Beyond every scene, and finite.
inline constexpr float Farthest = 1e30f;

/// Where a path meets a surface.
struct Vertex {
  /// Off the surface by SceneHeader::SurfaceOffset, on the ray's side.
  Vector3 Origin;
  /// On the ray's side.
  Vector3 UnitNormal;
  Vector3 BaseColor;
};

/// A random point of the lights.
struct LightPoint {
  Vector3 Position;
  Vector3 UnitNormal;
  Vector3 Emission;
};

/// Keeps the load of \p Light where it stands (EarlyLoad.h).
TP_KERNEL_INLINE void loadHere(LightRecord &Light) {
  loadHere(Light.Vertex);
  loadHere(Light.Edges[0]);
  loadHere(Light.Edges[1]);
  loadHere(Light.UnitNormal);
  loadHere(Light.Emission);
}

/// One thread of the path tracer. \p RayTracer has
///   Hit findClosestHit(const Ray &R, float MaxDistance): the first triangle
///     that R meets before MaxDistance;
///   bool isBlocked(const Ray &R, float MaxDistance): whether there is any.
template <class RayTracer> class PathTracer {
public:
  /// \p Rays traces rays through \p Scene.
  PathTracer(const LaunchBlock &Launch, const SceneView &Scene,
             const RayTracer &Rays)
      : Rays(Rays), Scene(Scene), Camera(Scene.Header->Camera),
        LightCount(Scene.Header->LightCount),
        SurfaceOffset(Scene.Header->SurfaceOffset),
        LightScale(Scene.Header->LightScale),
        SamplesPerPixel(Launch.SamplesPerPixel), MaxDepth(Launch.MaxDepth),
        Seed(Launch.Seed),
        PixelWidth(2.0f / static_cast<float>(static_cast<int>(Launch.Width))),
        PixelHeight(2.0f / static_cast<float>(static_cast<int>(Launch.Height))),
        Aspect(static_cast<float>(static_cast<int>(Launch.Width)) /
               static_cast<float>(static_cast<int>(Launch.Height))) {}

  /// The mean radiance of a pixel's samples.
  Vector3 renderPixel(PixelPlace Place, uint32_t Pixel) {
    Vector3 Sum;
    for (uint32_t Sample = 0; Sample != SamplesPerPixel; ++Sample)
      Sum = Sum + tracePath(primaryRay(Place, Pixel, Sample), Pixel, Sample);
    return Sum * (1.0f / static_cast<float>(static_cast<int>(SamplesPerPixel)));
  }

  uint32_t rayCount() const { return RayCount; }

private:
  Ray primaryRay(PixelPlace Place, uint32_t Pixel, uint32_t Sample) const;
  Vector3 tracePath(Ray R, uint32_t Pixel, uint32_t Sample);
  Vertex makeVertex(const Ray &R, const Hit &Found, Vector3 Normal,
                    Vector3 BaseColor) const;
  LightPoint samplePoint(RandomWords Random) const;

  Vector3 reflectLight(const Vertex &At, const LightPoint &Light);

  RayTracer Rays;
  const SceneView Scene;
  const CameraRecord Camera;
  const uint32_t LightCount;
  const float SurfaceOffset;
  const float LightScale;
  const uint32_t SamplesPerPixel;
  const uint32_t MaxDepth;
  const uint32_t Seed;
  const float PixelWidth;
  const float PixelHeight;
  const float Aspect;
  uint32_t RayCount = 0;
};

/// A ray through a random point of the pixel.
template <class RayTracer>
inline Ray PathTracer<RayTracer>::primaryRay(PixelPlace Place, uint32_t Pixel,
                                             uint32_t Sample) const {
  const RandomWords Random = randomWords(Pixel, Sample, 0, Seed);
  const float Column = static_cast<float>(static_cast<int>(Place.X));
  const float Row = static_cast<float>(static_cast<int>(Place.Y));
  const float ScreenX =
      ((Column + unitFloat(Random.X)) * PixelWidth - 1.0f) * Aspect;
  const float ScreenY = 1.0f - (Row + unitFloat(Random.Y)) * PixelHeight;
  return {Camera.Position,
          Camera.Forward + Camera.Right * ScreenX + Camera.Up * ScreenY};
}

template <class RayTracer>
inline Vertex PathTracer<RayTracer>::makeVertex(const Ray &R, const Hit &Found,
                                                Vector3 Normal,
                                                Vector3 BaseColor) const {
  Vertex Result;
  Result.UnitNormal = dot(Normal, R.Direction) > 0.0f ? -Normal : Normal;
  Result.Origin = R.Origin + R.Direction * Found.Distance +
                  Result.UnitNormal * SurfaceOffset;
  Result.BaseColor = BaseColor;
  return Result;
}

/// A point of the lights, uniform by area.
template <class RayTracer>
inline LightPoint PathTracer<RayTracer>::samplePoint(RandomWords Random) const {
  const RandomChoice Cell = chooseIndex(Random.X, LightCount);
  LightChoice Choice = Scene.LightChoices[Cell.Index];
  // Without waiting for the choice: mostly it is this one.
  LightRecord Light = Scene.Lights[Cell.Index];
  loadHere(Choice.Keep);
  loadHere(Choice.Alias);
  loadHere(Light);
  if (Cell.Remainder >= Choice.Keep) {
    Light = Scene.Lights[Choice.Alias];
    loadHere(Light);
  }
  return {sampleTriangle(Light.Vertex, Light.Edges[0], Light.Edges[1], Random.Y,
                         Random.Z),
          Light.UnitNormal, Light.Emission};
}

/// The radiance of the light's point that the surface reflects if it is white.
/// The BRDF's 1 / pi and the density of the point are in LightScale.
template <class RayTracer>
inline Vector3 PathTracer<RayTracer>::reflectLight(const Vertex &At,
                                                   const LightPoint &Light) {
  const Ray Shadow{At.Origin, Light.Position - At.Origin};
  const float CosineHere = dot(At.UnitNormal, Shadow.Direction);
  const float CosineThere = fabs(dot(Light.UnitNormal, Shadow.Direction));
  const float DistanceSquared = dot(Shadow.Direction, Shadow.Direction);
  // Below the horizon, or the light seen from its edge. Both cosines still have
  // the distance as a factor.
  if (!(CosineHere > 0.0f && CosineThere > 0.0f))
    return {};
  // Ends before the light itself.
  constexpr float ShadowEnd = 0.999f;
  ++RayCount;
  rayEvent(RayEvent::RayBegin, kAnyHitRay);
  if (Rays.isBlocked(Shadow, ShadowEnd))
    return {};
  const float Geometry =
      CosineHere * CosineThere / (DistanceSquared * DistanceSquared);
  return Light.Emission * (Geometry * LightScale);
}

/// The radiance that arrives along \p R from the scene.
template <class RayTracer>
inline Vector3 PathTracer<RayTracer>::tracePath(Ray R, uint32_t Pixel,
                                                uint32_t Sample) {
  Vector3 Radiance;
  Vector3 Throughput = {1, 1, 1};
  for (uint32_t Depth = 1;; ++Depth) {
    ++RayCount;
    rayEvent(RayEvent::RayBegin, kClosestHitRay);
    const Hit Found = Rays.findClosestHit(R, Farthest);
    if (Found.Triangle == kNoTriangle)
      return Radiance;
    // Everything that a vertex may need is loaded before the first decision, to
    // wait for memory once. Dimension 0 is the camera's; there are two events
    // at each vertex.
    const TriangleRecord &Triangle = Scene.Triangles[Found.Triangle];
    Vector3 Normal = Triangle.UnitNormal;
    Vector3 BaseColor = Triangle.BaseColor;
    uint32_t Emitter = Triangle.Emitter;
    loadHere(Normal);
    loadHere(BaseColor);
    loadHere(Emitter);
    const LightPoint Light =
        samplePoint(randomWords(Pixel, Sample, 2 * Depth - 1, Seed));
    const Vertex At = makeVertex(R, Found, Normal, BaseColor);
    if (Depth == 1 && Emitter != kNoEmitter)
      Radiance = Scene.Materials[Emitter].Emission;

    Throughput = Throughput * At.BaseColor;
    if (Throughput.X + Throughput.Y + Throughput.Z == 0.0f)
      return Radiance;
    if (LightCount != 0)
      Radiance = Radiance + Throughput * reflectLight(At, Light);
    if (Depth == MaxDepth)
      return Radiance;
    const RandomWords Bounce = randomWords(Pixel, Sample, 2 * Depth, Seed);
    R = {At.Origin, sampleCosineHemisphere(At.UnitNormal, Bounce.X, Bounce.Y)};
  }
}

/// Renders the launch's picture of \p Scene; all threads call it, and leave it
/// together. \p Rays traces rays through the scene.
template <class RayTracer>
void renderPixels(const LaunchBlock &Launch, const SceneView &Scene,
                  const RayTracer &Rays) {
  PathTracer<RayTracer> Tracer(Launch, Scene, Rays);
  uint32_t *Framebuffer = devicePointer<uint32_t>(Launch.Framebuffer);
  PixelQueue Queue(Launch);
  for (PixelPlace Place; Queue.take(Place);) {
    const uint32_t Pixel = Place.Y * Launch.Width + Place.X;
    Framebuffer[Pixel] = encodePixel(Tracer.renderPixel(Place, Pixel));
  }
  devicePointer<uint32_t>(Launch.RayCounts)[threadId()] = Tracer.rayCount();
  barrier();
}

} // namespace tp

#endif // TP_KERNELS_PATHTRACER_PATHTRACER_H
