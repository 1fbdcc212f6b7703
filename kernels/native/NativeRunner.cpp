//===- NativeRunner.cpp - Runs a kernel on the host -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NativeRunner.h"

#include "kernels/common/BuiltBvh.h"
#include "kernels/common/LaunchArguments.h"
#include "kernels/native/HostMemory.h"
#include "kernels/native/NullAccess.h"
#include "kernels/native/RunnerOptions.h"
#include "kernels/profile/RayProfileText.h"
#include "kernels/profile/RayProfiler.h"
#include "scenes/image/PngWriter.h"
#include "scenes/loader/SceneLoader.h"

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <numeric>

namespace tp {

const char *baseName(const char *Path) {
  const char *Slash = std::strrchr(Path, '/');
  return Slash ? Slash + 1 : Path;
}

int fail(const char *Program, const std::string &Message) {
  std::fprintf(stderr, "%s: error: %s\n", Program, Message.c_str());
  return 1;
}

static void reportSpeed(uint64_t Rays, double Seconds) {
  std::fprintf(stderr,
               "%" PRIu64 " rays in %.3f s: %.2f million rays per second\n",
               Rays, Seconds, double(Rays) / Seconds / 1e6);
}

/// Prints what the rays of a finished kernel did.
static Status reportRays(const RayProfiler &Rays) {
  if (Status Checked = Rays.check(); !Checked)
    return Checked;
  const std::optional<RayProfile> Sum = sumOf(Rays.threads());
  if (!Sum)
    return Error{"--ray-profile: the kernel reports no rays"};
  std::fputs(describe(*Sum).c_str(), stderr);
  return success();
}

/// The launch block of a run without a scene: arguments are all it has.
static LaunchBlock launchWithoutScene() {
  LaunchBlock Launch{};
  Launch.Version = kLaunchBlockVersion;
  return Launch;
}

/// Loads the scene, if there is one, and places it in \p Memory.
static ErrorOr<LaunchBlock> prepareLaunch(const char *Program,
                                          const RunnerOptions &Options,
                                          HostMemory &Memory) {
  if (Options.ScenePath.empty()) {
    reportNullAccess(Program);
    return launchWithoutScene();
  }
  const ErrorOr<Scene> Source = loadScene(Options.ScenePath);
  if (!Source)
    return Error{Source.message()};
  for (const std::string &Warning : Source->Warnings)
    std::fprintf(stderr, "%s: warning: %s: %s\n", Program,
                 Options.ScenePath.c_str(), Warning.c_str());
  return setUpLaunch(*Source, Options.Render, Options.Threads, Memory);
}

/// Reports the speed of a rendering, checks the tree that its kernel built and
/// writes the picture.
static Status finishRendering(const RunnerOptions &Options,
                              const LaunchBlock &Launch,
                              const HostMemory &Memory, double Seconds) {
  const std::vector<uint32_t> Counts =
      readRayCounts(Launch, Options.Threads, Memory);
  reportSpeed(std::accumulate(Counts.begin(), Counts.end(), uint64_t(0)),
              Seconds);
  if (Options.Render.Bvh == BvhOrigin::Kernel) {
    const ErrorOr<std::string> Tree =
        checkBuiltBvh(Launch, Memory, Options.BvhOutputPath);
    if (!Tree)
      return Error{Tree.message()};
    std::fprintf(stderr, "%s\n", Tree->c_str());
  }
  if (Options.OutputPath.empty())
    return success();
  return writePng(Options.OutputPath, readFramebuffer(Launch, Memory));
}

int runNatively(KernelMain Kernel, const char *Program,
                const std::string &Usage, int ArgumentCount, char **Arguments) {
  const ErrorOr<RunnerOptions> Options =
      parseRunnerOptions(ArgumentCount, Arguments);
  if (!Options)
    return fail(Program, Options.message());
  if (Options->Help) {
    std::fputs(runnerUsage(Usage).c_str(), stdout);
    return 0;
  }

  HostMemory Memory;
  ErrorOr<LaunchBlock> Launch = prepareLaunch(Program, *Options, Memory);
  if (!Launch)
    return fail(Program, Launch.message());
  std::vector<std::string> KernelArguments = {Program};
  KernelArguments.insert(KernelArguments.end(),
                         Options->KernelArguments.begin(),
                         Options->KernelArguments.end());
  if (Status Placed = placeArguments(KernelArguments, Memory, *Launch); !Placed)
    return fail(Program, Placed.message());
  host::setLocalStoreBytes(Options->LocalStoreBytes);

  RayProfiler Rays(Options->Threads);
  CurrentProfileObserver = Options->RayProfile ? &Rays : nullptr;
  const auto Start = std::chrono::steady_clock::now();
  if (const int Status = runOnHost(Kernel, Options->Threads, *Launch))
    return Status;
  const std::chrono::duration<double> Elapsed =
      std::chrono::steady_clock::now() - Start;
  if (!Options->ScenePath.empty())
    if (const Status Finished =
            finishRendering(*Options, *Launch, Memory, Elapsed.count());
        !Finished)
      return fail(Program, Finished.message());
  if (Options->RayProfile)
    if (const Status Reported = reportRays(Rays); !Reported)
      return fail(Program, Reported.message());
  return 0;
}

} // namespace tp
