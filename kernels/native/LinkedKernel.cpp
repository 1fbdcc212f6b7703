//===- LinkedKernel.cpp - A runner with its kernel built in ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NativeRunner.h"

/// The kernel's `main`, compiled with -Dmain=tpKernelMain.
int tpKernelMain();

int main(int ArgumentCount, char **Arguments) {
  const char *Program = tp::baseName(Arguments[0]);
  return tp::runNatively(tpKernelMain, Program, Program, ArgumentCount,
                         Arguments);
}
