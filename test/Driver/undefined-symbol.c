// What is referred to and defined nowhere, and from where.
//
// RUN: rm -rf %t && split-file %s %t && cd %t
// RUN: not tpcc main.c -o out.elf 2>&1 | FileCheck --check-prefix=SOURCE main.c
// RUN: not tpcc -O2 main.c -o out.elf 2>&1 | FileCheck --check-prefix=SOURCE main.c
// RUN: not ls out.elf
// RUN: tpcc -c main.c -o main.o
// RUN: not tpcc main.o -o out.elf 2>&1 | FileCheck --check-prefix=OBJECT main.c
// RUN: not tpcc -nostdlib empty.c -o out.elf 2>&1 | FileCheck --check-prefix=ENTRY empty.c
// RUN: not tpcc empty.c -o out.elf 2>&1 | FileCheck --check-prefix=MAIN empty.c
// RUN: tpcc weak.c -o out.elf && tpsim out.elf --chip 1x1

//--- main.c
// SOURCE: tpcc: error: undefined symbol: missing
// SOURCE-NEXT: referenced by main.c:main
// OBJECT: tpcc: error: undefined symbol: missing
// OBJECT-NEXT: referenced by main.o:(main+0x{{[0-9a-f]+}})
int missing(int);
static int dead(void) { extern int alsoMissing; return alsoMissing; }
int main(int Count, char **Words) { return missing(Count); }

//--- empty.c
// ENTRY: tpcc: error: undefined entry symbol: _start; link with the runtime, define the symbol, or name another one with -Wl,--entry=<symbol>
// MAIN: tpcc: error: undefined symbol: main
// MAIN-NEXT: referenced by the runtime:__tp_start_thread
int nothing;

//--- weak.c
extern int missing(void) __attribute__((weak));
int main(void) { return missing ? 1 : 0; }
