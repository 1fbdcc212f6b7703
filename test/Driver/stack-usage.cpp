// -fstack-usage and -Wframe-larger-than=. The default limit is the local store
// of the simulator's default chip.
//
// RUN: rm -rf %t && mkdir %t
// RUN: tpcc -O2 -fstack-usage -c %s -o %t/x.o && FileCheck --check-prefix=USAGE %s < %t/x.su
// RUN: tpcc -O2 -fstack-usage %s -o %t/x.elf 2> %t/warnings.txt && FileCheck --check-prefix=USAGE %s < %t/x.elf.su
// RUN: FileCheck --check-prefix=WARNING --implicit-check-not=warning: %s < %t/warnings.txt
//
// RUN: tpcc -O2 -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=WARNING --implicit-check-not=warning: %s
// RUN: tpcc -O2 -fno-lto %s -o %t/x.elf 2>&1 | FileCheck --check-prefix=WARNING --implicit-check-not=warning: %s
// RUN: tpcc -O2 -g %s -o %t/x.elf 2>&1 | FileCheck --check-prefix=WARNING --implicit-check-not=warning: %s
// RUN: tpcc -O2 -Wframe-larger-than=100000 %s -o %t/x.elf 2>&1 | count 0
// RUN: tpcc -O2 -Wno-frame-larger-than %s -o %t/x.elf 2>&1 | count 0
// RUN: tpcc -O2 -w %s -o %t/x.elf 2>&1 | count 0
// RUN: tpcc -O2 -DSILENCED %s -o %t/x.elf 2>&1 | count 0
// RUN: not tpcc -O2 -Werror %s -o %t/none.elf 2>&1 | FileCheck --check-prefix=ERROR %s
// RUN: not tpcc -O2 -Werror=frame-larger-than -c %s -o %t/none.elf 2>&1 | FileCheck --check-prefix=ERROR %s
// RUN: not ls %t/none.elf
// RUN: tpcc -O2 -Wframe-larger-than=64 -Wframe-larger-than=32 %s -o %t/x.elf 2>&1 | FileCheck --check-prefixes=SMALL %s
//
// RUN: tpsim --print-chip %t/x.elf | grep -A1 local_store: > %t/limit.txt
// RUN: tpcc -### -c %s 2>&1 | tr ' ' '\n' | grep fwarn-stack-size >> %t/limit.txt
// RUN: FileCheck --check-prefix=DEFAULT %s < %t/limit.txt

// DEFAULT: bytes: [[BYTES:[0-9]+]]
// DEFAULT: -fwarn-stack-size=[[BYTES]]"

#ifdef SILENCED
#pragma clang diagnostic ignored "-Wframe-larger-than"
#endif

namespace {
// USAGE: stack-usage.cpp:[[@LINE+2]]:{{.*}}fill{{.*}} 0 static
__attribute__((noinline))
int fill(volatile int *Values, int Count) {
  for (int I = 0; I < Count; ++I)
    Values[I] = I;
  return Values[Count - 1];
}

// USAGE: stack-usage.cpp:[[@LINE+4]]:{{.*}}large{{.*}} 400{{[0-9]+}} static
// WARNING: stack-usage.cpp:[[@LINE+3]]:5: warning: stack frame size (400{{[0-9]+}}) exceeds limit (16384) in '(anonymous namespace)::large(int)' [-Wframe-larger-than]
// ERROR: stack-usage.cpp:[[@LINE+2]]:5: error: stack frame size (400{{[0-9]+}}) exceeds limit (16384) in '(anonymous namespace)::large(int)' [-Werror,-Wframe-larger-than]
__attribute__((noinline))
int large(int Count) {
  int Values[10000];
  return fill(Values, Count);
}

// USAGE: stack-usage.cpp:[[@LINE+3]]:{{.*}}dynamic{{.*}} {{[0-9]+}} dynamic
// SMALL: stack-usage.cpp:{{[0-9]+}}:5: warning: stack frame size ({{.*}}) exceeds limit (32) in 'small
__attribute__((noinline))
int dynamic(int Count) {
  return fill(static_cast<int *>(__builtin_alloca(Count * 4)), Count);
}
} // namespace

__attribute__((noinline))
int small() {
  int Values[12];
  return fill(Values, 12);
}

int main(int Count, char **) {
  return large(Count + 5) + dynamic(Count + 3) + small();
}
