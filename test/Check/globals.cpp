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

[[clang::optnone]] [[gnu::noinline]] static int sum(const int *Values, int Count) {
  int Sum = 0;
  for (int I = 0; I != Count; ++I)
    Sum += Values[I];
  return Sum;
}

[[clang::optnone]] [[gnu::noinline]] static void put(char *Target, int At) { Target[At] = 'x'; }

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  Numbers[ArgumentCount] = 4;
  Sink = sum(Numbers, 10);
  put(Text, 12);
  if (!strcmp(Fault, "read"))
    // READ: error: global-out-of-bounds: load of 4 bytes at 0x
    // READ-NEXT: right behind 'Numbers' of 40 bytes
    // READ: in sum(int const*, int) at {{.*}}globals.cpp:[[@LINE-14]]:
    // READ: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    Sink = sum(Numbers, 11);
  if (!strcmp(Fault, "write"))
    // WRITE: error: global-out-of-bounds: store of 1 byte at 0x
    // WRITE-NEXT: right behind 'Text' of 13 bytes
    // WRITE: in main at {{.*}}globals.cpp:[[@LINE+1]]:
    put(Text, 13);
  return 0;
}
