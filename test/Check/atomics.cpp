// Undefined values are followed through atomic operations and streams, and what
// these have written is defined.
//
// RUN: tpcc -std=c++20 -O1 -g %s -o %t.elf
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- load 2>&1 \
// RUN:   | FileCheck %s --check-prefix=LOAD
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- add 2>&1 \
// RUN:   | FileCheck %s --check-prefix=ADD
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- exchange 2>&1 \
// RUN:   | FileCheck %s --check-prefix=EXCHANGE
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- stream 2>&1 \
// RUN:   | FileCheck %s --check-prefix=STREAM
// RUN: tpsim --chip 1x1 --quiet --check=all %t.elf 2>&1 | count 0

#include "tp/stream.h"
#include <atomic>
#include <stdlib.h>
#include <string.h>

using Word = std::atomic<unsigned>;

static volatile unsigned Sink;

template <class T> static T *make(unsigned Count) {
  return static_cast<T *>(malloc(Count * sizeof(T)));
}

/// What is written before it is looked at is no fault.
[[gnu::noinline]] static bool isClean() {
  auto *Words = make<Word>(8);
  Words[0].exchange(3);
  Words[1].fetch_or(16);
  Words[2].fetch_and(~32u);
  Words[3].store(4);
  Words[3].fetch_add(1);
  unsigned Expected = 5;
  const bool HasChanged = Words[3].compare_exchange_strong(Expected, 6);
  auto *Bytes = reinterpret_cast<std::atomic<unsigned char> *>(&Words[4]);
  Bytes[1].store(7);
  Bytes[1].fetch_add(1);
  Bytes[2].exchange(9);
  return Words[0] == 3 && (Words[1] & 16) && !(Words[2] & 32) && HasChanged &&
         Words[3] == 6 && Bytes[1] == 8 && Bytes[2] == 9;
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  auto is = [&](const char *Name) { return !strcmp(Fault, Name); };
  if (!isClean())
    return 1;
  auto *Words = make<Word>(8);
  // LOAD: error: undefined-branch: a branch depends on an undefined value
  // LOAD-NEXT: 4 bytes into a heap block of 32 bytes
  // LOAD: in main at {{.*}}atomics.cpp:[[@LINE+1]]:
  if (is("load") && Words[1].load(std::memory_order_acquire) == 3)
    Sink = 1;
  if (is("add")) {
    Words[2].fetch_add(2);
    // ADD: error: undefined-branch: a branch depends on an undefined value
    // ADD-NEXT: 8 bytes into a heap block of 32 bytes
    // ADD: in main at {{.*}}atomics.cpp:[[@LINE+1]]:
    if (Words[2] > 7)
      Sink = 2;
  }
  // EXCHANGE: error: undefined-branch: a branch depends on an undefined value
  // EXCHANGE: in main at {{.*}}atomics.cpp:[[@LINE+1]]:
  if (is("exchange") && Words[3].exchange(1) == 3)
    Sink = 3;
  tp::Stream *Stream = tp::streamCreate(malloc(tp::streamBytes(4)), 4);
  tp::streamPush(Stream, Words[4]);
  tp::streamPush(Stream, 5);
  // STREAM: error: undefined-branch: a branch depends on an undefined value
  // STREAM-NEXT: 16 bytes into a heap block of 32 bytes
  // STREAM: in main at {{.*}}atomics.cpp:[[@LINE+4]]:
  // STREAM: checks: 1 fault
  const unsigned Popped = tp::streamPop(Stream);
  if (is("stream"))
    if (Sink = 4; Popped == 1)
      Sink = 5;
  return tp::streamPop(Stream) != 5;
}
