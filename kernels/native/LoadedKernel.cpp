//===- LoadedKernel.cpp - A runner that loads its kernel ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// tp-native: runs a kernel that is a shared library of its own, so that its
// float flags reach nothing else, above all not what verifies its results.
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NativeRunner.h"

#include <cstring>
#include <dlfcn.h>

using namespace tp;

int main(int ArgumentCount, char **Arguments) {
  const char *Program = baseName(Arguments[0]);
  const std::string Usage = std::string(Program) + " KERNEL.so";
  if (ArgumentCount < 2)
    return fail(Program, "no kernel; usage: " + Usage + " [options]");
  if (std::strcmp(Arguments[1], "--help") == 0)
    return runNatively(nullptr, Program, Usage, ArgumentCount, Arguments);
  // Without a slash, dlopen() would look in the system's folders.
  std::string Path = Arguments[1];
  if (Path.find('/') == std::string::npos)
    Path = "./" + Path;
  void *Library = dlopen(Path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!Library)
    return fail(Program, dlerror());
  void *Main = dlsym(Library, "main");
  if (!Main)
    return fail(Program, Path + ": has no main");
  Arguments[1] = Arguments[0];
  return runNatively(reinterpret_cast<tp::KernelMain>(Main), Program, Usage,
                     ArgumentCount - 1, Arguments + 1);
}
