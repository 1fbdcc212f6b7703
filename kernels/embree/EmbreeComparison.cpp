//===- EmbreeComparison.cpp - Embree against the kernels, ray by ray ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Traces the primary rays of a picture with the kernels' own code, baseline and
// cached, and with Embree. Both must hit the same triangle, or two at the same
// distance, else the exit status is 1.
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LaunchSetup.h"
#include "kernels/embree/EmbreeScene.h"
#include "kernels/embree/ExactHits.h"
#include "kernels/embree/RecordingRayTracer.h"
#include "kernels/native/HostMemory.h"
#include "kernels/native/NativeRunner.h"
#include "kernels/native/RunnerOptions.h"
#include "kernels/pathtracer/MemoryRayTracer.h"
#include "kernels/pathtracer/PathTracer.h"
#include "kernels/treecache/CachedRayTracer.h"
#include "kernels/treecache/HighestBranch.h"
#include "scenes/loader/SceneLoader.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace tp;

/// Two triangles hit at distances that differ by less, relatively, tie.
static constexpr float TieTolerance = 1e-5f;
/// Disagreements that are described.
static constexpr unsigned MaxDescribed = 10;

namespace {

struct Counts {
  unsigned Same = 0, Ties = 0, Misses = 0, Disagreements = 0;
};

} // namespace

/// The picture's primary rays, row by row, as \p Rays traces them.
template <class RayTracer>
static std::vector<TracedRay> tracePrimaryRays(const LaunchBlock &Launch,
                                               const SceneView &Scene,
                                               RayTracer Rays) {
  std::vector<TracedRay> Record;
  using Recorder = RecordingRayTracer<RayTracer>;
  PathTracer<Recorder> Tracer(Launch, Scene, Recorder(Rays, Record));
  for (uint32_t Y = 0; Y != Launch.Height; ++Y)
    for (uint32_t X = 0; X != Launch.Width; ++X)
      Tracer.renderPixel({X, Y}, Y * Launch.Width + X);
  return Record;
}

static bool agree(const Hit &A, const Hit &B) {
  if (A.Triangle == B.Triangle)
    return true;
  return A.Triangle != kNoTriangle && B.Triangle != kNoTriangle &&
         std::abs(A.Distance - B.Distance) <=
             TieTolerance * std::max(A.Distance, B.Distance);
}

static void describeHit(const char *Whose, const SceneView &Scene, const Ray &R,
                        const Hit &Found) {
  if (Found.Triangle == kNoTriangle) {
    std::printf("    %-7s nothing\n", Whose);
    return;
  }
  const ExactPassage Passage = passTriangle(Scene.Triangles[Found.Triangle], R);
  std::printf("    %-7s triangle %u at %.9g, %.3g %s its edge\n", Whose,
              Found.Triangle, double(Found.Distance), std::abs(Passage.Margin),
              Passage.Margin < 0 ? "outside" : "inside");
}

/// Who is right about \p Traced.
static void describe(const LaunchBlock &Launch, const SceneView &Scene,
                     size_t Pixel, const TracedRay &Traced,
                     const Hit &Expected) {
  const Hit Exact = findExactHit(Scene, Traced.R);
  std::printf("  pixel (%zu, %zu): %s\n", Pixel % Launch.Width,
              Pixel / Launch.Width,
              agree(Traced.Found, Exact) ? "the kernel is right"
              : agree(Expected, Exact)   ? "Embree is right"
                                         : "neither is right");
  describeHit("kernel", Scene, Traced.R, Traced.Found);
  describeHit("Embree", Scene, Traced.R, Expected);
  describeHit("exact", Scene, Traced.R, Exact);
}

/// Compares and prints; true if all rays agree.
static bool compare(const char *Kernel, const LaunchBlock &Launch,
                    const SceneView &Scene, const EmbreeScene &Oracle,
                    const std::vector<TracedRay> &Record) {
  Counts Found;
  std::printf("%s kernel:\n", Kernel);
  for (size_t Pixel = 0; Pixel != Record.size(); ++Pixel) {
    const Hit &Ours = Record[Pixel].Found;
    const Hit Theirs = Oracle.findClosestHit(Record[Pixel].R);
    if (!agree(Ours, Theirs)) {
      if (++Found.Disagreements <= MaxDescribed)
        describe(Launch, Scene, Pixel, Record[Pixel], Theirs);
    } else if (Ours.Triangle == kNoTriangle) {
      ++Found.Misses;
    } else {
      ++(Ours.Triangle == Theirs.Triangle ? Found.Same : Found.Ties);
    }
  }
  std::printf("  %zu rays: %u hit the same triangle, %u tie, %u miss, "
              "%u disagree\n",
              Record.size(), Found.Same, Found.Ties, Found.Misses,
              Found.Disagreements);
  return Found.Disagreements == 0;
}

static bool compareKernels(const LaunchBlock &Launch, const SceneView &Scene,
                           uint32_t LocalStoreBytes) {
  const EmbreeScene Oracle(Scene);
  std::vector<TraversalStack::Entry> Entries(
      traversalEntries(Scene.Header->BvhDepth));
  const bool Baseline =
      compare("baseline", Launch, Scene, Oracle,
              tracePrimaryRays(Launch, Scene,
                               MemoryRayTracer<>(Scene, Entries.data())));
  using Tracer = CachedRayTracer<FullSlots, HighestBranch>;
  std::vector<char> Memory(LocalStoreBytes);
  const Tracer::Cache Slots(Memory.data(),
                            Tracer::Cache::slotsIn(Memory.size()),
                            FullNodes::root(Scene));
  const bool Cached = compare(
      "cached", Launch, Scene, Oracle,
      tracePrimaryRays(Launch, Scene, Tracer(Scene, Slots, Entries.data())));
  return Baseline && Cached;
}

int main(int ArgumentCount, char **Arguments) {
  const char *Program = baseName(Arguments[0]);
  ErrorOr<RunnerOptions> Options = parseRunnerOptions(ArgumentCount, Arguments);
  if (!Options)
    return fail(Program, Options.message());
  if (Options->Help) {
    std::fputs(runnerUsage(Program).c_str(), stdout);
    return 0;
  }
  if (Options->ScenePath.empty())
    return fail(Program, "no scene; give one with --scene FILE");
  const ErrorOr<Scene> Source = loadScene(Options->ScenePath);
  if (!Source)
    return fail(Program, Source.message());
  HostMemory Memory;
  // Primary rays only, one for each pixel.
  Options->Render.SamplesPerPixel = 1;
  Options->Render.MaxDepth = 1;
  const ErrorOr<LaunchBlock> Launch =
      setUpLaunch(*Source, Options->Render, 1, Memory);
  if (!Launch)
    return fail(Program, Launch.message());
  const SceneView View(devicePointer<const void>(Launch->Scene));
  return compareKernels(*Launch, View, Options->LocalStoreBytes) ? 0 : 1;
}
