// Undefined values that reach a branch, an address or an output are reported
// with the place where they were read or the memory was allocated.
//
// RUN: tpcc -O1 -g %s -o %t.elf
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- branch 2>&1 \
// RUN:   | FileCheck %s --check-prefix=BRANCH
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- address 2>&1 \
// RUN:   | FileCheck %s --check-prefix=ADDRESS
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- output 2>&1 \
// RUN:   | FileCheck %s --check-prefix=OUTPUT
// RUN: not tpsim --chip 1x1 --quiet --check=init %t.elf -- status 2>&1 \
// RUN:   | FileCheck %s --check-prefix=STATUS
// RUN: tpsim --chip 1x1 --quiet --check=all %t.elf 2>&1 | count 0
// RUN: tpcc -O0 -g %s -o %t.0.elf
// RUN: tpsim --chip 1x1 --quiet --check=all %t.0.elf 2>&1 | count 0

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct Record {
  unsigned Low : 5, Middle : 9, High : 18;
  short Number;
  char Letter; // behind it is padding
};

static int Table[8] = {1};
static volatile int Sink;

/// What is copied and masked but not looked at is no fault.
[[gnu::noinline]] static bool isClean(Record *Records) {
  Records[0].Middle = 3;
  Records[0].Number = 7;
  Record Copy = Records[0];
  memcpy(&Records[1], &Copy, sizeof(Copy));
  unsigned char Bytes[4];
  memcpy(Bytes, &Records[1].Number, 2);
  return Records[1].Middle == 3 && Bytes[0] == 7;
}

int main(int ArgumentCount, char **Arguments) {
  const char *Fault = ArgumentCount > 1 ? Arguments[1] : "none";
  auto *Records = static_cast<Record *>(malloc(4 * sizeof(Record)));
  if (!isClean(Records))
    return 1;
  if (!strcmp(Fault, "branch"))
    // BRANCH: error: undefined-branch: a branch depends on an undefined value
    // BRANCH-NEXT: it is that of memory that nobody has written, 24 bytes into a heap block of 32 bytes
    // BRANCH: used by thread 0
    // BRANCH-NEXT: in main at {{.*}}init.cpp:[[@LINE+4]]:
    // BRANCH: allocated by thread 0
    // BRANCH: in malloc at
    // BRANCH: in main at
    if (Records[3].Low == 3)
      puts("3");
  if (!strcmp(Fault, "address"))
    // ADDRESS: error: undefined-address: an address depends on an undefined
    // ADDRESS: in main at {{.*}}init.cpp:[[@LINE+1]]:
    Sink = Table[Records[2].Number & 7];
  if (!strcmp(Fault, "output")) {
    // OUTPUT: error: undefined-output: byte 2 of the output is undefined
    // OUTPUT: in main at {{.*}}init.cpp:[[@LINE+5]]:
    // OUTPUT: allocated by thread 0
    char *Text = static_cast<char *>(malloc(8));
    memcpy(Text, "ab", 2);
    fwrite(Text, 1, 4, stdout);
    fflush(stdout);
  }
  if (!strcmp(Fault, "status"))
    // STATUS: error: undefined-output: the exit status depends on an undefined
    return Records[3].High & 1;
  return 0;
}
