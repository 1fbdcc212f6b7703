// Threads wait for each other with std::atomic, std::latch and std::barrier.
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 4x32 --quiet %t.elf | FileCheck %s
// RUN: tpcc -O0 %s -o %t0.elf
// RUN: tpsim --chip 4x32 --quiet %t0.elf | FileCheck %s
// CHECK: 0 wrong of 128, 3 phases

#include <atomic>
#include <barrier>
#include <cstdio>
#include <latch>
#include <tp/thread.h>

std::atomic<int> Turn = 0;
std::atomic_flag Open = ATOMIC_FLAG_INIT;
std::atomic<float> Sum = 0.0f;
std::atomic<unsigned> Wrong = 0;

int main() {
  static int Phases = 0;
  int Threads = static_cast<int>(tp::threadCount());
  int Id = static_cast<int>(tp::threadId());
  static std::latch Added(Threads);
  static std::barrier Phase(Threads, [] { ++Phases; });

  // One after the other.
  for (int Now; (Now = Turn.load()) != Id;)
    Turn.wait(Now);
  Turn.store(Id + 1);
  Turn.notify_all();

  if (Id == Threads - 1) {
    Open.test_and_set();
    Open.notify_all();
  }
  Open.wait(false);
  Sum += static_cast<float>(Id);
  Added.arrive_and_wait();
  if (Sum != static_cast<float>(Threads * (Threads - 1) / 2))
    ++Wrong;

  static int Values[128];
  Values[Id] = Id;
  Phase.arrive_and_wait();
  Values[Id] += Phases == 1 ? 0 : 1;
  Phase.arrive_and_wait();
  if (Values[(Id + 17) % Threads] != (Id + 17) % Threads)
    ++Wrong;
  Phase.arrive_and_wait();
  if (Id == 0)
    std::printf("%u wrong of %d, %d phases\n", Wrong.load(), Threads, Phases);
}
