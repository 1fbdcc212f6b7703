// With -ftp-check-objects, accesses behind globals are found.
//
// RUN: tpcc -O0 -g -ftp-check-objects %s -o %t.0.elf
// RUN: tpcc -O2 -g -ftp-check-objects %s -o %t.2.elf
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- read 2>&1 \
// RUN:   | FileCheck %s --check-prefix=READ
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- read 2>&1 \
// RUN:   | FileCheck %s --check-prefix=READ
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- write 2>&1 \
// RUN:   | FileCheck %s --check-prefix=WRITE
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- own 2>&1 \
// RUN:   | FileCheck %s --check-prefix=OWN
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- own 2>&1 \
// RUN:   | FileCheck %s --check-prefix=OWN
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.0.elf -- literal 2>&1 \
// RUN:   | FileCheck %s --check-prefix=LITERAL
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.2.elf -- literal 2>&1 \
// RUN:   | FileCheck %s --check-prefix=LITERAL
// RUN: tpsim --chip 1x1 --quiet --check=all %t.0.elf 2>&1 | count 0
// RUN: tpsim --chip 1x1 --quiet --check=all %t.2.elf 2>&1 | count 0
// RUN: tpcc -O1 -c -fno-lto -g -ftp-check-objects %s -o %t.o
// RUN: tpcc -O1 %t.o -o %t.o.elf
// RUN: not tpsim --chip 1x1 --quiet --check=memory %t.o.elf -- read 2>&1 \
// RUN:   | FileCheck %s --check-prefix=READ

#include <string.h>

int Numbers[10] = {1, 2, 3};
static char Text[13];
static volatile int Sink;
static thread_local int Own[5] = {1, 2, 3};
static thread_local char OwnText[11];

[[clang::optnone]] [[gnu::noinline]] static int sum(const int *Values, int Count) {
  int Sum = 0;
  for (int I = 0; I != Count; ++I)
    Sum += Values[I];
  return Sum;
}

[[clang::optnone]] [[gnu::noinline]] static void put(char *Target, int At) { Target[At] = 'x'; }

[[clang::optnone]] [[gnu::noinline]] static char get(const char *Source, int At) { return Source[At]; }

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  Numbers[ArgumentCount] = 4;
  Sink = sum(Numbers, 10);
  put(Text, 12);
  Sink = sum(Own, 5) + get(OwnText, 10) + get("letters", 7);
  put(OwnText, 10);
  if (sum(Own, 5) != 6 || get(OwnText, 10) != 'x')
    return 1;
  if (!strcmp(Fault, "own"))
    // OWN: error: global-out-of-bounds: load of 4 bytes at 0x
    // OWN-NEXT: right behind 'Own' of 20 bytes
    // OWN: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    Sink = sum(Own, 6);
  if (!strcmp(Fault, "literal"))
    // LITERAL: error: global-out-of-bounds: load of 1 byte at 0x
    // LITERAL-NEXT: right behind a constant without a name of 8 bytes
    // LITERAL: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    Sink = get("letters", 8);
  if (!strcmp(Fault, "read"))
    // READ: error: global-out-of-bounds: load of 4 bytes at 0x
    // READ-NEXT: right behind 'Numbers' of 40 bytes
    // READ: in sum(int const*, int) at {{.*}}globals.cpp:[[@LINE-30]]:
    // READ: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    Sink = sum(Numbers, 11);
  if (!strcmp(Fault, "write"))
    // WRITE: error: global-out-of-bounds: store of 1 byte at 0x
    // WRITE-NEXT: right behind 'Text' of 13 bytes
    // WRITE: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    put(Text, 13);
  return 0;
}
