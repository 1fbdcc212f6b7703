// Atomic operations of 128 threads on shared words of every width.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// RUN: tpcc -O0 %s -o %t0.elf
// RUN: tpsim --chip 4x32 --quiet %t0.elf | FileCheck %s

// CHECK: sum 8128 min -127 max 127 or ffffffff and 0 xor 0
// CHECK-NEXT: compare-exchange 128, exchange sum 8128
// CHECK-NEXT: 64 bits: 35184372088960, 8 bits: 128, 16 bits: 128
// CHECK-NEXT: one static object: 1
// CHECK-NEXT: streams: 8128, left 0

#include <stdint.h>
#include <stdio.h>
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/stream.h>
#include <tp/thread.h>

uint32_t Sum, Max, Or, And = ~0u, Xor, Counted, Last, ExchangeSum;
int32_t Min;
uint64_t Wide;
uint8_t Byte;
uint16_t Half[2];
uint32_t Made, PopSum, Left;

struct {
  tp::Stream Head;
  uint32_t Words[256];
} Queue;

struct Once {
  uint32_t Value;
  Once() : Value(tp::atomicAdd(&Made, 1u) + 1) {}
};

uint32_t once() {
  static Once Object;
  return Object.Value;
}

int main() {
  uint32_t Id = tp::threadId();
  if (Id == 0)
    tp::streamCreate(&Queue, 256);
  tp::barrier();
  tp::atomicAdd(&Sum, Id);
  tp::atomicMax(&Max, Id);
  tp::atomicMin(&Min, -static_cast<int32_t>(Id));
  tp::atomicOr(&Or, 1u << (Id % 32));
  tp::atomicAnd(&And, ~(1u << (Id % 32)));
  tp::atomicXor(&Xor, 1u << (Id % 32));
  for (uint32_t Old = 0;;) {
    uint32_t Seen = tp::atomicCompareExchange(&Counted, Old, Old + 1);
    if (Seen == Old)
      break;
    Old = Seen;
  }
  uint32_t Previous = tp::atomicExchange(&Last, Id);
  tp::atomicAdd(&ExchangeSum, Previous);
  __atomic_fetch_add(&Wide, (uint64_t(1) << 38) + 1, __ATOMIC_RELAXED);
  __atomic_fetch_add(&Byte, uint8_t(1), __ATOMIC_RELAXED);
  __atomic_fetch_add(&Half[1], uint16_t(1), __ATOMIC_RELAXED);
  if (once() != 1)
    return 1;
  if (!tp::streamPush(&Queue.Head, Id))
    return 2;
  tp::barrier();
  uint32_t Popped = tp::streamPop(&Queue.Head);
  tp::atomicAdd(&PopSum, Popped);
  tp::barrier();
  if (Id == 0) {
    printf("sum %u min %d max %u or %x and %x xor %x\n", Sum, Min, Max, Or, And,
           Xor);
    printf("compare-exchange %u, exchange sum %u\n", Counted,
           ExchangeSum + Last);
    printf("64 bits: %llu, 8 bits: %u, 16 bits: %u\n", (unsigned long long)Wide,
           Byte, Half[1]);
    printf("one static object: %u\n", Made);
    printf("streams: %u, left %u\n", PopSum, Queue.Head.Tail - Queue.Head.Head);
  }
}
