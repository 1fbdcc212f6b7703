//===- RunnerOptions.h - Command line of the native runner ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_NATIVE_RUNNEROPTIONS_H
#define TP_KERNELS_NATIVE_RUNNEROPTIONS_H

#include "kernels/common/LaunchSetup.h"
#include "runtime/host/HostRuntime.h"
#include "scenes/ErrorOr.h"

#include <string>
#include <vector>

namespace tp {

/// What the command line of the native runner says.
struct RunnerOptions {
  /// Print the usage and do nothing else.
  bool Help = false;
  /// The scene to render; none if empty.
  std::string ScenePath;
  RenderOptions Render;
  /// Threads of the host, at least 1.
  unsigned Threads = 1;
  /// Of each thread; a multiple of 16.
  uint32_t LocalStoreBytes = host::kDefaultLocalStoreBytes;
  /// Print what the kernel's rays did.
  bool RayProfile = false;
  /// What the kernel's main() gets behind the program's name.
  std::vector<std::string> KernelArguments;
  /// PNG to write; none if empty.
  std::string OutputPath;
  /// File for the tree that the kernel built; none if empty.
  std::string BvhOutputPath;
};

/// The text of `--help`. \p Program is how the command line begins.
std::string runnerUsage(const std::string &Program);

/// Reads the command line. Fails, naming the option, if it is unknown, lacks
/// its value or has a bad one, or means nothing without a scene.
ErrorOr<RunnerOptions> parseRunnerOptions(int ArgumentCount,
                                          char *const *Arguments);

} // namespace tp

#endif // TP_KERNELS_NATIVE_RUNNEROPTIONS_H
