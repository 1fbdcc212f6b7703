//===- ThreadExit.h - What a thread does at its end -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_CRT_THREADEXIT_H
#define TP_RUNTIME_LIB_CRT_THREADEXIT_H

namespace tp {

/// One thing to do when this thread ends. The node lives until then and is the
/// caller's.
struct ThreadExit {
  void (*Function)(void *Argument);
  void *Argument;
  ThreadExit *Next;
};

/// Makes \p Node the first thing to do when this thread ends. A node is free to
/// be added again once its function runs.
void atThreadExit(ThreadExit &Node);

/// Does what was added, the last first, until nothing is left.
void runThreadExits();

} // namespace tp

#endif // TP_RUNTIME_LIB_CRT_THREADEXIT_H
