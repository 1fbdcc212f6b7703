//===- RecordingRayTracer.h - Remembers rays and their hits -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_EMBREE_RECORDINGRAYTRACER_H
#define TP_KERNELS_EMBREE_RECORDINGRAYTRACER_H

#include "kernels/bvh/Ray.h"

#include <vector>

namespace tp {

/// A ray and what the kernel found along it.
struct TracedRay {
  Ray R;
  Hit Found;
};

/// Traces rays with another tracer and remembers the closest hits.
template <class RayTracer> class RecordingRayTracer {
public:
  /// Both must outlive this and its copies.
  RecordingRayTracer(RayTracer &Rays, std::vector<TracedRay> &Record)
      : Rays(&Rays), Record(&Record) {}

  Hit findClosestHit(const Ray &R, float MaxDistance) {
    const Hit Found = Rays->findClosestHit(R, MaxDistance);
    Record->push_back({R, Found});
    return Found;
  }
  bool isBlocked(const Ray &R, float MaxDistance) {
    return Rays->isBlocked(R, MaxDistance);
  }

private:
  RayTracer *Rays;
  std::vector<TracedRay> *Record;
};

} // namespace tp

#endif // TP_KERNELS_EMBREE_RECORDINGRAYTRACER_H
