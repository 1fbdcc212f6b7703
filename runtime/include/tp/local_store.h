//===- local_store.h - The free part of the local store ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A thread's stack and thread_local objects lie at the end of its local store.
// What is left is memory of one cycle for any use of the program's own.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LOCAL_STORE_H
#define TP_LOCAL_STORE_H

#include "tp/thread.h"
#include <stdint.h>

namespace tp {

/// Bytes of the calling thread's local store, at a multiple of 16. Other
/// threads cannot reach them.
struct LocalStoreSpace {
  char *Begin;
  /// A multiple of 16.
  uint32_t Bytes;
};

#ifdef __tp__

/// The linker defines it: the lowest address that the stack may reach.
extern "C" char __tp_stack_limit[];

/// The part of this thread's local store that neither its stack nor its
/// thread_local objects can use. The linker finds the bound of the stack; a
/// program whose stack it cannot bound needs -Wl,-z,stack-size=<bytes>. On the
/// host: memory of the size that the runner was given, with any content.
inline LocalStoreSpace freeLocalStore() {
  uint32_t Begin = 0u - localStoreBytes();
  return {reinterpret_cast<char *>(Begin),
          reinterpret_cast<uint32_t>(__tp_stack_limit) - Begin};
}

#else

LocalStoreSpace freeLocalStore();

#endif

} // namespace tp

#endif // TP_LOCAL_STORE_H
