//===- FloatCheck.cpp - A failed floating-point check on the host ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"
#include "tp/thread.h"
#include <cstdio>
#include <cstdlib>
#include <mutex>

/// What natively compiled code with floating-point checks (the plug-in's
/// -tp-fp-check) calls when one fails: a code and values as in CheckFailure.h,
/// and the place in the source. Says so on standard error and ends the process
/// with status 1. A program may have a function of its own instead; it must not
/// return.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" [[noreturn, gnu::weak]] void
__tp_fp_check_failed(uint32_t Code, uint64_t Result, uint64_t First,
                     uint64_t Second, const char *Place) {
  // The first thread that fails speaks for all.
  static std::mutex Failing;
  Failing.lock();
  std::string What =
      tp::CheckFailure::fromCode(Code).describe({Result, First, Second});
  std::fflush(stdout);
  std::fprintf(stderr, "error: thread %u trapped: %s\n  %s\n",
               unsigned(tp::threadId()), What.c_str(), Place);
  std::_Exit(1);
}
