// malloc and its kin, new and delete, by one thread and by many at once.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf | FileCheck %s
// RUN: tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// CHECK: 0 wrong

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

struct alignas(64) Wide {
  uint32_t Words[16];
};

int main() {
  uint32_t Id = tp::threadId();
  unsigned char *Blocks[24];
  for (unsigned I = 0; I != 24; ++I) {
    Blocks[I] = static_cast<unsigned char *>(malloc(I * 7 + 1));
    check(Blocks[I] && reinterpret_cast<uint32_t>(Blocks[I]) % 8 == 0);
    memset(Blocks[I], static_cast<int>(Id + I), I * 7 + 1);
  }
  for (unsigned I = 0; I != 24; I += 2)
    free(Blocks[I]);
  for (unsigned I = 1; I < 24; I += 2) {
    Blocks[I] = static_cast<unsigned char *>(realloc(Blocks[I], I * 50));
    for (unsigned J = 0; J != I * 7 + 1; ++J)
      check(Blocks[I][J] == static_cast<unsigned char>(Id + I));
  }
  for (unsigned I = 1; I < 24; I += 2)
    free(Blocks[I]);
  auto *Zeros = static_cast<uint32_t *>(calloc(100, 4));
  for (unsigned I = 0; I != 100; ++I)
    check(Zeros[I] == 0);
  free(Zeros);
  Wide *W = new Wide[2];
  check(reinterpret_cast<uint32_t>(W) % 64 == 0);
  W[1].Words[15] = Id;
  check(W[1].Words[15] == Id);
  delete[] W;
  void *volatile Huge = malloc(0xF0000000u);
  check(Huge == nullptr);
  tp::barrier();
  if (Id == 0)
    printf("%u wrong\n", Wrong);
}
