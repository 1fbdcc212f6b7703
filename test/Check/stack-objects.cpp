// With -ftp-check-objects, accesses outside of objects of the stack and after
// their lives are found.
//
// RUN: tpcc -O0 -g -ftp-check-objects %s -o %t.0.elf
// RUN: tpcc -O2 -g -ftp-check-objects %s -o %t.2.elf
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- behind 2>&1 \
// RUN:   | FileCheck %s --check-prefix=BEHIND
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- behind 2>&1 \
// RUN:   | FileCheck %s --check-prefix=BEHIND
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- before 2>&1 \
// RUN:   | FileCheck %s --check-prefix=BEFORE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- scope 2>&1 \
// RUN:   | FileCheck %s --check-prefix=SCOPE
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.2.elf -- unwritten 2>&1 \
// RUN:   | FileCheck %s --check-prefix=UNWRITTEN
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- variable 2>&1 \
// RUN:   | FileCheck %s --check-prefix=VARIABLE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- variable 2>&1 \
// RUN:   | FileCheck %s --check-prefix=VARIABLE
// RUN: tpsim --chip 1x1 --quiet --check=all %t.0.elf 2>&1 | count 0
// RUN: tpsim --chip 1x1 --quiet --check=all %t.2.elf 2>&1 | count 0

#include <string.h>

[[gnu::noinline]] static int get(const int *Values, int Number) {
  return Values[Number];
}

[[gnu::noinline]] static void fill(int *Values, int Count) {
  for (int I = 0; I != Count; ++I)
    Values[I] = I;
}

static int *volatile Kept;
static volatile int Sink;

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  int values[10];
  fill(values, strcmp(Fault, "unwritten") ? 10 : 9);
  if (!strcmp(Fault, "behind"))
    // BEHIND: error: stack-out-of-bounds: load of 4 bytes at 0x
    // BEHIND-NEXT: right behind the stack object 'values' of 40 bytes
    // BEHIND: in get(int const*, int) at {{.*}}stack-objects.cpp:26:
    // BEHIND: in main at {{.*}}stack-objects.cpp:[[@LINE+3]]:
    // BEHIND: the object began to live by thread 0
    // BEHIND: in main at
    Sink = get(values, 10);
  if (!strcmp(Fault, "before"))
    // BEFORE: error: stack-out-of-bounds: load of 4 bytes
    // BEFORE-NEXT: 8 bytes before the stack object 'values' of 40 bytes
    Sink = get(values, -2);
  {
    int inner[4];
    fill(inner, 4);
    Kept = inner;
  }
  if (!strcmp(Fault, "scope"))
    // SCOPE: error: stack-use-after-scope: load of 4 bytes
    // SCOPE-NEXT: 8 bytes into the stack object 'inner' of 16 bytes
    Sink = get(Kept, 2);
  for (int Count = ArgumentCount; Count != ArgumentCount + 4; ++Count) {
    int variable[Count];
    fill(variable, Count);
    Sink = get(variable, Count - 1);
    if (Count == 5 && !strcmp(Fault, "variable"))
      // VARIABLE: error: stack-out-of-bounds: load of 4 bytes
      // VARIABLE-NEXT: right behind the stack object 'variable' of 20 bytes
      // VARIABLE: in main at {{.*}}stack-objects.cpp:[[@LINE+1]]:
      Sink = get(variable, 5);
  }
  // UNWRITTEN: error: undefined-branch: a branch depends on an undefined value
  // UNWRITTEN-NEXT: 36 bytes into the stack object 'values' of 40 bytes
  // UNWRITTEN: in main at {{.*}}stack-objects.cpp:[[@LINE+3]]:
  // UNWRITTEN: loaded from there by thread 0
  // UNWRITTEN: in get(int const*, int) at
  if (get(values, 9) == 1)
    Sink = 1;
  return 0;
}
