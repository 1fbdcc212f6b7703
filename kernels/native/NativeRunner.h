//===- NativeRunner.h - Runs a kernel on the host ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_NATIVE_NATIVERUNNER_H
#define TP_KERNELS_NATIVE_NATIVERUNNER_H

#include <string>

namespace tp {

using KernelMain = int (*)(int ArgumentCount, char **Arguments);

/// Runs the kernel whose `main` is \p Kernel as the command line in
/// \p Arguments (with the program's name first) asks, with or without a scene
/// to render. Errors name \p Program; \p Usage is how the usage text begins.
/// Returns the exit status.
int runNatively(KernelMain Kernel, const char *Program,
                const std::string &Usage, int ArgumentCount, char **Arguments);

/// The last part of \p Path.
const char *baseName(const char *Path);

/// Prints an error and returns 1.
int fail(const char *Program, const std::string &Message);

} // namespace tp

#endif // TP_KERNELS_NATIVE_NATIVERUNNER_H
