//===- DeletionRecorder.h - One deletion, before and after ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_DELETIONRECORDER_H
#define TP_KERNELS_PROFILE_DELETIONRECORDER_H

#include "kernels/profile/CacheMirror.h"

namespace tp {

/// Which deletion is to be recorded.
struct DeletionRequest {
  uint32_t Thread = 0;
  /// Its number among those of the thread, from 1.
  uint64_t Deletion = 1;
};

/// A deletion in the cache of one thread.
struct DeletionRecord {
  CacheMirror Before;
  CacheMirror After;
  /// The thread's ray in which it happened, from 1.
  uint64_t Ray = 0;
  /// In the order of the deletion; the first is the top of the branch.
  std::vector<uint16_t> Freed;
  /// From the root to the node whose child is loaded next; empty if something
  /// else comes next.
  std::vector<uint16_t> Path;
};

/// Watches the events of one thread for the deletion to be recorded.
class DeletionRecorder {
public:
  explicit DeletionRecorder(uint64_t Deletion) : Countdown(Deletion) {}

  /// What was recorded, if the deletion has come and is complete.
  const std::optional<DeletionRecord> &record() const { return Complete; }

  /// The events of all deletions, with the cache as it is when they are
  /// reported.
  void begin(const CacheMirror &Cache, uint64_t Ray) {
    if (Countdown == 0)
      return;
    --Countdown;
    if (Countdown == 0)
      Partial.emplace(DeletionRecord{Cache, Cache, Ray, {}, {}});
  }
  void freeSlot(uint16_t Slot) {
    if (Partial)
      Partial->Freed.push_back(Slot);
  }
  void end(const CacheMirror &Cache) {
    if (!Partial)
      return;
    Partial->After = Cache;
    Complete = std::move(*Partial);
    Partial.reset();
    AwaitsPath = true;
  }
  /// A load into a slot that the word at \p ParentWord will name.
  void load(const CacheMirror &Cache, uint32_t ParentWord) {
    if (AwaitsPath && Complete)
      Complete->Path = Cache.pathTo(ParentWord);
    AwaitsPath = false;
  }
  /// A visit without a load.
  void visit() { AwaitsPath = false; }

  /// \p Shape is that of the thread's cache, if it has one.
  template <class Archive> void serialize(Archive &A, const CacheShape &Shape) {
    A(Countdown);
    A(AwaitsPath);
    serialize(A, Shape, Partial);
    serialize(A, Shape, Complete);
  }

private:
  template <class Archive>
  static void serialize(Archive &A, const CacheShape &Shape,
                        std::optional<DeletionRecord> &Record) {
    bool Present = Record.has_value();
    A(Present);
    if (!Present)
      return Record.reset();
    if (!Record)
      Record.emplace(
          DeletionRecord{CacheMirror(Shape), CacheMirror(Shape), 0, {}, {}});
    A(Record->Before);
    A(Record->After);
    A(Record->Ray);
    A(Record->Freed);
    A(Record->Path);
  }

  uint64_t Countdown;
  std::optional<DeletionRecord> Partial;
  std::optional<DeletionRecord> Complete;
  bool AwaitsPath = false;
};

} // namespace tp

#endif // TP_KERNELS_PROFILE_DELETIONRECORDER_H
