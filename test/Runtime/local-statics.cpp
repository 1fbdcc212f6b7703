// A local static object is made once, by the first thread that comes, while the
// others wait; its destructor runs once, at the end and in reverse order. A
// thread_local object of another file or of a function is made when a thread
// first uses it, and ends with the thread.
// RUN: split-file %s %t
// RUN: tpcc -O2 %t/main.cpp %t/other.cpp -o %t/2.elf
// RUN: tpsim --chip 4x32 --quiet %t/2.elf | FileCheck %s
// RUN: tpcc -O0 %t/main.cpp %t/other.cpp -o %t/0.elf
// RUN: tpsim --chip 4x32 --quiet %t/0.elf | FileCheck %s
// RUN: tpcc -O1 -fno-lto %t/main.cpp %t/other.cpp -o %t/1.elf
// RUN: tpsim --chip 4x32 --quiet %t/1.elf | FileCheck %s

// CHECK: 3 made by 128 threads, 256 local, 64 distant, 0 wrong
// CHECK-NEXT: 320 thread objects ended, 0 out of order
// CHECK-NEXT: outer ends
// CHECK-NEXT: inner ends
// CHECK-NEXT: early ends
// CHECK-NOT: {{.}}

//--- shared.h
#include <stdint.h>
#include <stdio.h>
#include <tp/atomic.h>
#include <tp/barrier.h>
#include <tp/thread.h>

inline uint32_t Wrong, ThreadEnds, OutOfOrder;

struct Distant {
  static inline uint32_t Made = 0;
  uint32_t Value;
  Distant() : Value(tp::threadId() + 1) { tp::atomicAdd(&Made, 1u); }
  ~Distant();
};
extern thread_local Distant Far;

//--- other.cpp
#include "shared.h"

thread_local Distant Far;

Distant::~Distant() { tp::atomicAdd(&ThreadEnds, 1u); }

//--- main.cpp
#include "shared.h"

uint32_t Made = 0;

struct Static {
  const char *Name;
  uint32_t Values[8];
  explicit Static(const char *Name) : Name(Name) {
    // Long enough for all others to arrive.
    for (uint32_t &Value : Values) {
      tp::sleep(500);
      Value = 7;
    }
    tp::atomicAdd(&Made, 1u);
  }
  ~Static() {
    if (Name[0] == 'o')
      printf("%u thread objects ended, %u out of order\n", ThreadEnds,
             OutOfOrder);
    printf("%s ends\n", Name);
  }
  uint32_t sum() const {
    uint32_t Sum = 0;
    for (uint32_t Value : Values)
      Sum += Value;
    return Sum;
  }
};

Static Early("early");

Static &inner() {
  static Static Inner("inner");
  return Inner;
}

// Its static object's maker makes another one.
Static &outer() {
  static Static Outer = (inner(), Static("outer"));
  return Outer;
}

inline uint32_t LocalMade = 0;

struct Local {
  uint32_t Number;
  explicit Local(uint32_t Number) : Number(Number) {
    tp::atomicAdd(&LocalMade, 1u);
  }
  ~Local();
};

thread_local uint32_t LastEnded = 1000;

Local::~Local() {
  tp::atomicAdd(&ThreadEnds, 1u);
  if (Number > LastEnded)
    tp::atomicAdd(&OutOfOrder, 1u);
  LastEnded = Number;
}

uint32_t local(uint32_t By) {
  thread_local uint32_t Sum = 100;
  thread_local Local First(1), Second(2);
  return Sum += By * (Second.Number - First.Number);
}

int main() {
  uint32_t Id = tp::threadId();
  bool Right = outer().sum() == 56 && inner().sum() == 56;
  Right = Right && local(Id) == 100 + Id && local(1) == 101 + Id;
  // Only every second thread makes the other object.
  if (Id % 2 == 0)
    Right = Right && Far.Value == Id + 1;
  if (!Right)
    tp::atomicAdd(&Wrong, 1u);
  tp::barrier();
  if (Id == 0)
    printf("%u made by %u threads, %u local, %u distant, %u wrong\n", Made,
           tp::threadCount(), LocalMade, Distant::Made, Wrong);
}
