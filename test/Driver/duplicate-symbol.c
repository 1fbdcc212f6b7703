// Two strong definitions of a symbol, in units and in objects; a program's own
// definition instead of the runtime's is none.
//
// RUN: rm -rf %t && split-file %s %t && cd %t
// RUN: tpcc -c one.c -o one.o && tpcc -c two.c -o two.o
// RUN: not tpcc one.c two.c -o out.elf 2>&1 | FileCheck --check-prefix=UNITS one.c
// RUN: not tpcc one.o two.o -o out.elf 2>&1 | FileCheck --check-prefix=OBJECTS one.c
// RUN: not tpcc one.c two.o -o out.elf 2>&1 | FileCheck --check-prefix=BOTH one.c
// RUN: tpcc weak.c one.o -o out.elf && tpsim out.elf --chip 1x1
// RUN: tpcc own.c -O1 -o out.elf && tpsim out.elf --chip 1x1

//--- one.c
// UNITS: tpcc: error: duplicate symbol: twice
// UNITS-NEXT: defined in one.c
// UNITS-NEXT: defined in two.c
// OBJECTS: tpcc: error: duplicate symbol: twice
// OBJECTS-NEXT: defined in one.o
// OBJECTS-NEXT: defined in two.o
// BOTH: tpcc: error: duplicate symbol: twice
// BOTH-NEXT: defined in one.c
// BOTH-NEXT: defined in two.o
int twice(int X) { return X * 2; }

//--- two.c
int twice(int X) { return X + X; }

//--- weak.c
__attribute__((weak)) int twice(int X) { return 0; }
int main(void) { return twice(4) == 8 ? 0 : 1; }

//--- own.c
int abs(int X) { return 17; }
int main(void) { int (*volatile Function)(int) = abs; return Function(3) == 17 ? 0 : 1; }
