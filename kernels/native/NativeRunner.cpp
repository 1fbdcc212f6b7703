//===- NativeRunner.cpp - Runs a rendering kernel on the host -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NativeRunner.h"

#include "kernels/common/BuiltBvh.h"
#include "kernels/common/LaunchArguments.h"
#include "kernels/native/HostMemory.h"
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

  const ErrorOr<Scene> Source = loadScene(Options->ScenePath);
  if (!Source)
    return fail(Program, Source.message());
  for (const std::string &Warning : Source->Warnings)
    std::fprintf(stderr, "%s: warning: %s: %s\n", Program,
                 Options->ScenePath.c_str(), Warning.c_str());
  HostMemory Memory;
  ErrorOr<LaunchBlock> Launch =
      setUpLaunch(*Source, Options->Render, Options->Threads, Memory);
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
  const std::vector<uint32_t> Counts =
      readRayCounts(*Launch, Options->Threads, Memory);
  reportSpeed(std::accumulate(Counts.begin(), Counts.end(), uint64_t(0)),
              Elapsed.count());
  if (Options->RayProfile)
    if (const Status Reported = reportRays(Rays); !Reported)
      return fail(Program, Reported.message());

  if (Options->Render.Bvh == BvhOrigin::Kernel) {
    const ErrorOr<std::string> Tree =
        checkBuiltBvh(*Launch, Memory, Options->BvhOutputPath);
    if (!Tree)
      return fail(Program, Tree.message());
    std::fprintf(stderr, "%s\n", Tree->c_str());
  }
  if (Options->OutputPath.empty())
    return 0;
  const Image Picture = readFramebuffer(*Launch, Memory);
  if (Status Written = writePng(Options->OutputPath, Picture); !Written)
    return fail(Program, Written.message());
  return 0;
}

} // namespace tp
