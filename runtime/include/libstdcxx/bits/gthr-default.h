//===- gthr-default.h - No threads for libstdc++ ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The TP's threads are all there from the start; std::thread and std::mutex are
// not offered. std::atomic is.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_GTHR_DEFAULT_H
#define TP_LIBSTDCXX_GTHR_DEFAULT_H

#include <bits/gthr-single.h>

#undef _GLIBCXX_HAS_GTHREADS

#endif // TP_LIBSTDCXX_GTHR_DEFAULT_H
