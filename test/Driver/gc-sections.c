// Objects give the program only what it needs.
//
// RUN: tpcc -O1 -c -ffunction-sections -fdata-sections %s -o %t.o
// RUN: tpcc -nostdlib %t.o -o %t.elf && llvm-nm %t.elf | FileCheck %s
// RUN: tpcc -nostdlib %t.o -Wl,--no-gc-sections -o %t.elf && llvm-nm %t.elf | FileCheck --check-prefix=ALL %s
// RUN: tpcc -nostdlib %t.o -Wl,--undefined=unneeded -o %t.elf && llvm-nm %t.elf | FileCheck --check-prefix=ALL %s
// RUN: tpcc -nostdlib %t.o -Wl,--entry=unneeded -o %t.elf && llvm-readelf -h %t.elf | FileCheck --check-prefix=ENTRY %s

// CHECK-DAG: D Needed
// CHECK-DAG: T _start
// CHECK-DAG: T retained
// CHECK-NOT: unneeded
// ALL: T unneeded
// ENTRY: Entry point address: 0x1

int Needed = 1;
int unneeded(void) { return 5; }
__attribute__((retain, used)) int retained(void) { return 6; }
void _start(void) { __builtin_tp_halt(Needed); }
