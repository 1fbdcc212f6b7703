//===- Start.cpp - From reset to main -------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Every thread starts at `_start` with all registers zero and an empty local
// store: it gets a stack, its thread_local objects' initial values, and, once
// thread 0 has run the static constructors, calls main.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/FunctionArray.h"
#include "tp/barrier.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include "tp/thread.h"

extern "C" {

// The linker defines these; only their addresses mean something, and that of
// __tp_tdata_size is a number of bytes.
extern uint32_t __tp_tls_begin[];
extern const uint32_t __tp_tdata_image[];
extern const char __tp_tdata_size[];
extern const tp::SimpleFunction __init_array_start[];
extern const tp::SimpleFunction __init_array_end[];

// `main` may not be called by its name.
int tpUserMain(int ArgumentCount, char **Arguments) __asm__("main");
[[noreturn]] void exit(int Status);

/// The simulator finds this symbol and fills it before the start.
__attribute__((used)) tp::LaunchBlock __tp_launch = {};

[[noreturn]] __attribute__((used)) void __tp_start_thread() {
  uint32_t Bytes = reinterpret_cast<uint32_t>(__tp_tdata_size);
  for (uint32_t Word = 0; Word < (Bytes + 3) / 4; ++Word)
    __tp_tls_begin[Word] = __tp_tdata_image[Word];

  uintptr_t Constructors =
      tp::functionCount(__init_array_start, __init_array_end);
  if (Constructors != 0) {
    if (tp::threadId() == 0)
      for (uintptr_t I = 0; I != Constructors; ++I)
        __init_array_start[I]();
    tp::barrier();
  }

  const tp::LaunchBlock &Launch = tp::launchBlock();
  exit(tpUserMain(static_cast<int>(Launch.ArgumentCount),
                  tp::devicePointer<char *>(Launch.Arguments)));
}

} // extern "C"

__asm__(".text\n"
        ".globl _start\n"
        ".type _start,@function\n"
        "_start:\n"
        // Nobody called it.
        ".cfi_sections .debug_frame\n"
        ".cfi_startproc\n"
        ".cfi_undefined r31\n"
        "  lui r29, %hi(__tp_stack_top)\n"
        "  addi r29, r29, %lo(__tp_stack_top)\n"
        "  j __tp_start_thread\n"
        ".cfi_endproc\n"
        ".size _start, .-_start\n"
        // It takes nothing of the stack that it sets up, and calls nothing
        // through a register.
        ".pushsection .tp.frames, \"e\"\n"
        ".word _start, 0, 0, 0, 0\n"
        ".popsection\n");
