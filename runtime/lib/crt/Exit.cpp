//===- Exit.cpp - The end of a thread and of the program ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// exit() ends the calling thread. The last thread that ends also runs what was
// given to atexit() and the destructors of static objects.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/FunctionArray.h"
#include "runtime/lib/crt/SpinLock.h"
#include "runtime/lib/crt/ThreadExit.h"
#include "tp/thread.h"
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

extern "C" {
extern const tp::SimpleFunction __fini_array_start[];
extern const tp::SimpleFunction __fini_array_end[];
}

namespace tp {

namespace {

thread_local ThreadExit *FirstThreadExit = nullptr;

struct ProgramExit {
  void (*Function)(void *Argument);
  void *Argument;
  ProgramExit *Next;
};

/// The C standard's minimum needs no heap.
constexpr uint32_t NumReserved = 32;
ProgramExit Reserved[NumReserved];
uint32_t NumReservedUsed = 0;
ProgramExit *FirstProgramExit = nullptr;
SpinLock ProgramExitLock;
uint32_t NumEndedThreads = 0;

bool atProgramExit(void (*Function)(void *), void *Argument) {
  LockGuard Guard(ProgramExitLock);
  ProgramExit *Node;
  if (NumReservedUsed != NumReserved)
    Node = &Reserved[NumReservedUsed++];
  else
    Node = static_cast<ProgramExit *>(malloc(sizeof(ProgramExit)));
  if (!Node)
    return false;
  *Node = {Function, Argument, FirstProgramExit};
  FirstProgramExit = Node;
  return true;
}

void runProgramExits() {
  while (ProgramExit *Node = FirstProgramExit) {
    FirstProgramExit = Node->Next;
    Node->Function(Node->Argument);
  }
  for (uintptr_t Count = functionCount(__fini_array_start, __fini_array_end);
       Count != 0; --Count)
    __fini_array_start[Count - 1]();
}

} // namespace

void atThreadExit(ThreadExit &Node) {
  Node.Next = FirstThreadExit;
  FirstThreadExit = &Node;
}

void runThreadExits() {
  while (ThreadExit *Node = FirstThreadExit) {
    FirstThreadExit = Node->Next;
    Node->Function(Node->Argument);
  }
}

} // namespace tp

extern "C" {

/// Identifies the program among the shared objects that a TP never has.
void *__dso_handle = nullptr;

int __cxa_atexit(void (*Function)(void *), void *Argument, void *) {
  return tp::atProgramExit(Function, Argument) ? 0 : -1;
}

int atexit(void (*Function)(void)) {
  auto Call = [](void *Argument) {
    reinterpret_cast<void (*)(void)>(Argument)();
  };
  return tp::atProgramExit(Call, reinterpret_cast<void *>(Function)) ? 0 : -1;
}

int __cxa_thread_atexit(void (*Function)(void *), void *Argument, void *) {
  auto *Node = static_cast<tp::ThreadExit *>(malloc(sizeof(tp::ThreadExit)));
  if (!Node)
    return -1;
  *Node = {Function, Argument, nullptr};
  tp::atThreadExit(*Node);
  return 0;
}

void _Exit(int Status) {
  tp::sync();
  __builtin_tp_halt(Status);
}

void exit(int Status) {
  tp::runThreadExits();
  uint32_t Ended =
      tp::atomicAdd(&tp::NumEndedThreads, 1u, __ATOMIC_ACQ_REL) + 1;
  if (Ended == tp::threadCount()) {
    tp::runProgramExits();
    tp::runThreadExits();
  }
  _Exit(Status);
}

void abort(void) {
  fflush(nullptr);
  __builtin_tp_trap_break(1);
}

} // extern "C"
