// The heap joins free neighbours and splits large blocks: memory in pieces of
// any size, given back in any order, is whole again. Every thread does so at
// once. Each operator new and delete takes part.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf | FileCheck %s
// RUN: tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// RUN: tpcc -O0 %s -o %t0.elf
// RUN: tpsim --chip 1x1 --quiet %t0.elf | FileCheck %s
// CHECK: 0 wrong
// RUN: tpcc -O1 -DTWICE %s -o %t.twice.elf
// RUN: not tpsim --chip 1x1 --quiet %t.twice.elf 2>&1 \
// RUN:   | FileCheck --check-prefix=TWICE %s
// TWICE: heap: memory given back is not in use, or was written past its end

#include <initializer_list>
#include <new>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>

uint32_t Wrong;

void check(bool Right) {
  if (!Right)
    tp::atomicAdd(&Wrong, 1u);
}

uint32_t addressOf(const void *Memory) {
  return reinterpret_cast<uint32_t>(Memory);
}

/// Takes all memory in blocks of \p Bytes and gives it back, every second block
/// first. Returns how much it was.
uint32_t fill(uint32_t Bytes) {
  void **First = nullptr, **Second = nullptr;
  uint32_t Count = 0;
  while (void **Memory = static_cast<void **>(malloc(Bytes))) {
    void **&List = Count++ & 1 ? First : Second;
    *Memory = List;
    List = Memory;
  }
  for (void **List : {First, Second})
    while (List) {
      void **Next = static_cast<void **>(*List);
      free(List);
      List = Next;
    }
  return Count * Bytes;
}

struct alignas(256) Wide {
  uint32_t Words[64];
  ~Wide() {}
};

struct Small {
  uint32_t Value;
  ~Small() {}
};

void useOperators(uint32_t Id) {
  Wide *One = new Wide, *Many = new Wide[3];
  auto *Quiet = new (std::nothrow) Wide;
  auto *QuietMany = new (std::nothrow) Small[5];
  for (Wide *W : {One, Many, Quiet})
    check(addressOf(W) % 256 == 0);
  memset(static_cast<void *>(Many), static_cast<int>(Id), 3 * sizeof(Wide));
  QuietMany[4].Value = Id;
  alignas(Small) unsigned char Place[sizeof(Small)];
  auto *Placed = new (Place) Small{Id};
  check(addressOf(Placed) == addressOf(Place) && Placed->Value == Id);
  Placed->~Small();
  delete One;
  check(Many[2].Words[63] == (Id & 0xFF) * 0x01010101u);
  check(QuietMany[4].Value == Id);
  delete[] Many;
  delete Quiet;
  delete[] QuietMany;
  ::operator delete(::operator new(40), 40u);
  ::operator delete(::operator new(40, std::nothrow), std::nothrow);
  ::operator delete[](::operator new[](40, std::align_val_t(64)), 40u,
                      std::align_val_t(64));
  void *volatile Huge = ::operator new(0xE0000000u, std::nothrow);
  check(!Huge);
  Huge = ::operator new(0xE0000000u, std::align_val_t(64), std::nothrow);
  check(!Huge);
}

void *Reserve = nullptr;

/// Random steps; each block is filled with a pattern of its own.
void churn(uint32_t Id) {
  constexpr uint32_t Slots = 24;
  struct Slot {
    uint8_t *Memory;
    uint32_t Bytes;
    uint8_t Pattern;
  } Held[Slots] = {};
  uint32_t State = Id * 77 + 1;
  auto Next = [&](uint32_t Bound) {
    State = State * 1664525u + 1013904223u;
    return (State >> 8) % Bound;
  };
  auto CheckPattern = [&](const Slot &S, uint32_t Bytes) {
    for (uint32_t I = 0; I < Bytes; I += 13)
      check(S.Memory[I] == S.Pattern);
    check(Bytes == 0 || S.Memory[Bytes - 1] == S.Pattern);
  };
  for (uint32_t Step = 0; Step != 150; ++Step) {
    Slot &S = Held[Next(Slots)];
    uint32_t Bytes = Next(4) == 0 ? Next(2000) : Next(60);
    if (!S.Memory) {
      uint32_t Alignment = 1u << Next(8);
      S.Memory = static_cast<uint8_t *>(
          Next(2) ? malloc(Bytes) : aligned_alloc(Alignment, Bytes));
    } else if (Next(2)) {
      CheckPattern(S, S.Bytes);
      free(S.Memory);
      S.Memory = nullptr;
      continue;
    } else {
      CheckPattern(S, S.Bytes);
      S.Memory = static_cast<uint8_t *>(realloc(S.Memory, Bytes));
      CheckPattern(S, S.Bytes < Bytes ? S.Bytes : Bytes);
    }
    check(S.Memory && addressOf(S.Memory) % 8 == 0);
    S.Bytes = Bytes;
    S.Pattern = static_cast<uint8_t>(Id + Step);
    memset(S.Memory, S.Pattern, Bytes);
  }
  for (Slot &S : Held)
    free(S.Memory);
}

int main() {
  uint32_t Id = tp::threadId();
#ifdef TWICE
  void *volatile Memory = malloc(Id + 8);
  free(Memory);
  free(Memory);
#endif
  useOperators(Id);
  churn(Id);
  tp::barrier();
  if (Id != 0)
    return 0;
  // Nothing is new any more: large blocks are joined small ones.
  uint32_t All = fill(100'000);
  check(All != 0 && fill(3 << 20) > All / 8 * 7);
  void *Large = malloc(All < 0x40000000 ? All / 8 * 7 : 0x3FFFFFFF);
  check(Large);
  free(Large);
  // The handler gives back what it has until there is enough.
  Reserve = malloc(All < 0x40000000 ? All / 4 * 3 : 0x3FFFFFFF);
  std::set_new_handler([] {
    check(Reserve);
    free(Reserve);
    Reserve = nullptr;
    std::set_new_handler(nullptr);
  });
  uint32_t Most = All < 0x40000000 ? All / 2 : 0x3FFFFFFF;
  void *Rest[8] = {};
  for (void *&Memory : Rest) {
    Memory = ::operator new(Most, std::nothrow);
    if (!Reserve)
      break;
  }
  check(!Reserve && !std::get_new_handler());
  for (void *Memory : Rest)
    ::operator delete(Memory);
  // A block grows into free memory behind it and shrinks in place.
  auto *Grown = static_cast<uint8_t *>(malloc(1000));
  void *Barrier = malloc(16);
  void *Moved = realloc(Grown, 400);
  check(Moved == Grown);
  Moved = realloc(Moved, 900);
  check(Moved == Grown);
  free(Barrier);
  free(Moved);
  volatile uint32_t NoPower = 24;
  check(!aligned_alloc(NoPower, 8) && !aligned_alloc(NoPower - 24, 8));
  printf("%u wrong\n", Wrong);
}
