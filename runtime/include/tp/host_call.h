//===- host_call.h - Services of the host to a program ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The numbers of the hostcall instruction that programs and the simulator
// share.
//
//===----------------------------------------------------------------------===//

#ifndef TP_HOST_CALL_H
#define TP_HOST_CALL_H

namespace tp {

/// The one service so far: write(file descriptor 1 or 2, address, bytes).
inline constexpr unsigned kHostCallWrite = 0;

} // namespace tp

#endif // TP_HOST_CALL_H
