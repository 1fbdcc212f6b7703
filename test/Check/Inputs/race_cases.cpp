//===- race_cases.cpp - Programs with and without data races --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// For the chip and, with four threads of the host, for ThreadSanitizer. The
// argument is the name of a case; without one the names are printed, of those
// that race with "races" behind. ThreadSanitizer does not know fences.
//
//===----------------------------------------------------------------------===//

#include <atomic>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __tp__
#include "tp/barrier.h"
#include "tp/thread.h"
static void waitForAll() { tp::barrier(); }
static void giveWay() { tp::sleep(16); }
#else
#include <pthread.h>
#include <sched.h>
static pthread_barrier_t Barrier;
static void waitForAll() { pthread_barrier_wait(&Barrier); }
static void giveWay() { sched_yield(); }
#endif

using std::memory_order_acq_rel;
using std::memory_order_acquire;
using std::memory_order_relaxed;
using std::memory_order_release;

static constexpr unsigned NumThreads = 4;

static int Data[NumThreads];
static int More;
static uint8_t Bytes[8];
static std::atomic<uint32_t> Flag;
static std::atomic<uint32_t> Counter;
static std::atomic<uint32_t> Lock;
static std::atomic<uint64_t> Wide;
static std::atomic<float> Sum;
static struct {
  std::atomic<uint8_t> Atomic[2];
  uint8_t Plain[2];
} Mixed;
static struct {
  alignas(4) std::atomic<uint8_t> Atomic;
  uint8_t Plain[3];
} Aligned;
/// What is computed is used.
static std::atomic<int> Result;

static void use(int Value) { Result.fetch_add(Value, memory_order_relaxed); }
static void waitFor(uint32_t Value, std::memory_order Order) {
  while (Flag.load(Order) != Value)
    giveWay();
}
static void lock() {
  while (Lock.exchange(1, memory_order_acquire) != 0)
    giveWay();
}
static void unlock() { Lock.store(0, memory_order_release); }

//===----------------------------------------------------------------------===//
// Without races
//===----------------------------------------------------------------------===//

static void barrierBetween(unsigned Id) {
  if (Id == 0)
    Data[0] = 1;
  waitForAll();
  use(Data[0]);
  waitForAll();
  if (Id == 1)
    Data[0] = 2;
}

static void ownElements(unsigned Id) {
  Data[Id] = 1;
  Bytes[Id] = 2;
  waitForAll();
  if (Id == 3)
    use(Data[0] + Data[1] + Bytes[0] + Bytes[1]);
}

static void lockAround(unsigned) {
  for (int I = 0; I != 10; ++I) {
    lock();
    ++More;
    unlock();
  }
}

static void message(unsigned Id) {
  if (Id == 0) {
    More = 1;
    Flag.store(1, memory_order_release);
  } else {
    waitFor(1, memory_order_acquire);
    use(More);
  }
}

static void fences(unsigned Id) {
  if (Id == 0) {
    More = 1;
    std::atomic_thread_fence(memory_order_release);
    Flag.store(1, memory_order_relaxed);
  } else {
    waitFor(1, memory_order_relaxed);
    std::atomic_thread_fence(memory_order_acquire);
    use(More);
  }
}

static void lastOneSums(unsigned Id) {
  Data[Id] = 1;
  if (Counter.fetch_add(1, memory_order_acq_rel) == NumThreads - 1)
    use(Data[0] + Data[1] + Data[2] + Data[3]);
}

static void chain(unsigned Id) {
  if (Id == 0)
    More = 1;
  else
    waitFor(Id, memory_order_acquire);
  ++More;
  Flag.store(Id + 1, memory_order_release);
}

static void releaseSequence(unsigned Id) {
  if (Id == 0) {
    More = 1;
    Flag.store(1, memory_order_release);
  } else if (Id == 1) {
    waitFor(1, memory_order_relaxed);
    Flag.fetch_add(1, memory_order_relaxed);
  } else if (Id == 2) {
    waitFor(2, memory_order_acquire);
    use(More);
  }
}

static void relaxedCounter(unsigned) {
  for (int I = 0; I != 10; ++I)
    Counter.fetch_add(1, memory_order_relaxed);
  use(Counter.load(memory_order_relaxed));
}

static void bytesBesideAtomics(unsigned Id) {
  if (Id < 2)
    Mixed.Atomic[1].fetch_add(1, memory_order_relaxed);
  else
    for (int I = 0; I != 10; ++I)
      ++Mixed.Plain[Id - 2];
}

static void exchangedBytes(unsigned Id) {
  uint8_t Expected = 0;
  std::atomic<uint8_t> Own = 1;
  Own.fetch_add(1, memory_order_relaxed);
  if (!Mixed.Atomic[0].compare_exchange_strong(Expected, Own.load()))
    use(Expected);
}

static void bitsBesideBytes(unsigned Id) {
  if (Id == 3) {
    Aligned.Atomic.fetch_or(6, memory_order_relaxed);
    Aligned.Atomic.fetch_and(3, memory_order_relaxed);
    Aligned.Atomic.fetch_xor(7, memory_order_relaxed);
    Aligned.Atomic.fetch_add(1, memory_order_relaxed);
  } else {
    for (int I = 0; I != 10; ++I)
      ++Aligned.Plain[Id];
  }
}

static void wideAtomics(unsigned) {
  Wide.fetch_add(1, memory_order_relaxed);
  use(static_cast<int>(Wide.load(memory_order_relaxed)));
}

static void floatAtomics(unsigned) {
  for (int I = 0; I != 10; ++I)
    Sum.fetch_add(1.0f, memory_order_relaxed);
}

static int make() { return 5; }
static void localStatic(unsigned) {
  static const int Once = make() + Counter.load(memory_order_relaxed);
  use(Once);
}

static void heap(unsigned Id) {
  for (unsigned I = 1; I != 20; ++I) {
    char *Block = static_cast<char *>(malloc(I * 8 + Id));
    memset(Block, static_cast<int>(I), I * 8 + Id);
    use(Block[I]);
    free(Block);
  }
}

//===----------------------------------------------------------------------===//
// With races
//===----------------------------------------------------------------------===//

static void noBarrier(unsigned Id) {
  if (Id == 0)
    Data[0] = 1;
  else
    use(Data[0]);
}

static void barrierTooLate(unsigned Id) {
  if (Id == 2)
    Data[1] = 1;
  use(Data[1]);
  waitForAll();
}

static void sameElement(unsigned Id) {
  Data[Id / 2] = 1;
  waitForAll();
}

static void sameByte(unsigned Id) {
  Bytes[Id % 3] = 1;
  waitForAll();
}

static void halfOfALock(unsigned Id) {
  if (Id != 0)
    return lockAround(Id);
  use(More);
}

static void afterTheLock(unsigned) {
  lock();
  ++More;
  unlock();
  asm volatile("" : : : "memory");
  use(More);
}

static void relaxedStore(unsigned Id) {
  if (Id == 0) {
    More = 1;
    Flag.store(1, memory_order_relaxed);
  } else {
    waitFor(1, memory_order_acquire);
    use(More);
  }
}

static void relaxedLoad(unsigned Id) {
  if (Id == 0) {
    More = 1;
    Flag.store(1, memory_order_release);
  } else {
    waitFor(1, memory_order_relaxed);
    use(More);
  }
}

static void afterTheRelease(unsigned Id) {
  if (Id == 0) {
    Flag.store(1, memory_order_release);
    More = 1;
  } else {
    waitFor(1, memory_order_acquire);
    use(More);
  }
}

static void atomicAndPlain(unsigned Id) {
  auto *Plain = reinterpret_cast<uint32_t *>(&Counter);
  if (Id == 0)
    *Plain = 7;
  else
    Counter.fetch_add(1, memory_order_relaxed);
}

static void bitsAndPlain(unsigned Id) {
  if (Id == 3)
    Aligned.Atomic.fetch_or(6, memory_order_relaxed);
  else if (Id == 2)
    *reinterpret_cast<uint8_t *>(&Aligned.Atomic) = 1;
}

static void volatileFlag(unsigned Id) {
  auto *Ready = reinterpret_cast<volatile int *>(&More);
  if (Id == 0) {
    Data[0] = 1;
    *Ready = 1;
  } else {
    while (*Ready == 0)
      giveWay();
    use(Data[0]);
  }
}

static void sumTooEarly(unsigned Id) {
  Data[Id] = 1;
  if (Counter.fetch_add(1, memory_order_relaxed) == NumThreads - 1)
    use(Data[0] + Data[1] + Data[2] + Data[3]);
}

//===----------------------------------------------------------------------===//

struct Case {
  const char *Name;
  void (*Run)(unsigned Id);
  bool Races;
};

static const Case Cases[] = {
    {"barrier", barrierBetween, false},
    {"own-elements", ownElements, false},
    {"lock", lockAround, false},
    {"message", message, false},
    {"fences", fences, false},
    {"last-one-sums", lastOneSums, false},
    {"chain", chain, false},
    {"release-sequence", releaseSequence, false},
    {"relaxed-counter", relaxedCounter, false},
    {"bytes-beside-atomics", bytesBesideAtomics, false},
    {"exchanged-bytes", exchangedBytes, false},
    {"bits-beside-bytes", bitsBesideBytes, false},
    {"wide-atomics", wideAtomics, false},
    {"float-atomics", floatAtomics, false},
    {"local-static", localStatic, false},
    {"heap", heap, false},
    {"no-barrier", noBarrier, true},
    {"barrier-too-late", barrierTooLate, true},
    {"same-element", sameElement, true},
    {"same-byte", sameByte, true},
    {"half-of-a-lock", halfOfALock, true},
    {"after-the-lock", afterTheLock, true},
    {"relaxed-store", relaxedStore, true},
    {"relaxed-load", relaxedLoad, true},
    {"after-the-release", afterTheRelease, true},
    {"atomic-and-plain", atomicAndPlain, true},
    {"bits-and-plain", bitsAndPlain, true},
    {"volatile-flag", volatileFlag, true},
    {"sum-too-early", sumTooEarly, true},
};

static const Case *findCase(const char *Name) {
  for (const Case &C : Cases)
    if (strcmp(C.Name, Name) == 0)
      return &C;
  return nullptr;
}

static int listCases() {
  for (const Case &C : Cases)
    printf("%s%s\n", C.Name, C.Races ? " races" : "");
  return 0;
}

#ifdef __tp__

int main(int Count, char **Arguments) {
  if (Count < 2)
    return tp::threadId() == 0 ? listCases() : 0;
  findCase(Arguments[1])->Run(tp::threadId());
  return 0;
}

#else

static const Case *Chosen;

static void *runThread(void *Id) {
  Chosen->Run(static_cast<unsigned>(reinterpret_cast<uintptr_t>(Id)));
  return nullptr;
}

int main(int Count, char **Arguments) {
  if (Count < 2)
    return listCases();
  Chosen = findCase(Arguments[1]);
  pthread_barrier_init(&Barrier, nullptr, NumThreads);
  pthread_t Threads[NumThreads];
  for (uintptr_t Id = 0; Id != NumThreads; ++Id)
    pthread_create(&Threads[Id], nullptr, runThread,
                   reinterpret_cast<void *>(Id));
  for (pthread_t Thread : Threads)
    pthread_join(Thread, nullptr);
  return 0;
}

#endif
