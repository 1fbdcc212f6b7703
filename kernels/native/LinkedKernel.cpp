//===- LinkedKernel.cpp - A runner with its kernel built in ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NativeRunner.h"

/// The kernel's `main`, compiled with -Dmain=tpKernelMain: one of the two.
[[gnu::weak]] int tpKernelMain();
[[gnu::weak]] int tpKernelMain(int ArgumentCount, char **Arguments);

static int runKernel(int ArgumentCount, char **Arguments) {
  if (int (*Main)(int, char **) = tpKernelMain)
    return Main(ArgumentCount, Arguments);
  return tpKernelMain();
}

int main(int ArgumentCount, char **Arguments) {
  const char *Program = tp::baseName(Arguments[0]);
  return tp::runNatively(runKernel, Program, Program, ArgumentCount, Arguments);
}
