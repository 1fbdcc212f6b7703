//===- TreeCacheChecker.cpp - Verifies a cache as it runs -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/treecache/TreeCacheChecker.h"

#include "tp/atomic.h"
#include "tp/thread.h"

#include <stdio.h>
#include <stdlib.h>

namespace tp {

/// By all threads.
static uint32_t VerifiedDeletions = 0;

/// Stops all threads: those that wait at a barrier, too.
[[noreturn]] static void stop(const char *Message) {
  fprintf(stderr, "error: tree cache: thread %u: %s\n", unsigned(threadId()),
          Message);
#ifdef __tp__
  abort();
#else
  fflush(nullptr);
  _Exit(1);
#endif
}

void TreeCacheChecker::verifyDeletion(const TreeCacheLayout &Layout,
                                      const TreeCacheState &State,
                                      const TreeCacheSource &Source,
                                      const TreeCachePath &Path) {
  ++DeletionCount;
  auto *Scratch = static_cast<uint32_t *>(
      malloc(treeCacheVerifierWords(State.SlotCount) * sizeof(uint32_t)));
  if (!Scratch)
    stop("no memory to verify the cache in");
  const TreeCacheViolation Found =
      verifyTreeCache(Layout, State, Source, &Path, Scratch);
  free(Scratch);
  if (Found.isClean()) {
    atomicAdd(&VerifiedDeletions, 1u);
    return;
  }
  char Sentence[160], Message[200];
  describeViolation(Found, Sentence, sizeof(Sentence));
  snprintf(Message, sizeof(Message), "after deletion %u: %s",
           unsigned(DeletionCount), Sentence);
  stop(Message);
}

void reportVerifiedDeletions() {
  if (threadId() == 0)
    fprintf(stderr, "tree cache: %u deletions verified\n",
            unsigned(atomicLoad(&VerifiedDeletions)));
}

} // namespace tp
