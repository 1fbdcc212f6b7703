// Static constructors run before main in the order of their priority, from IR
// and from objects; destructors after it.
//
// RUN: rm -rf %t && split-file %s %t && cd %t
// RUN: tpcc -O2 -c early.cpp -o early.o
// RUN: tpcc -O2 main.cpp early.o -o out.elf && tpsim out.elf --chip 1x1 2>/dev/null | FileCheck main.cpp
// RUN: tpcc -O0 main.cpp early.cpp -o out.elf && tpsim out.elf --chip 1x1 2>/dev/null | FileCheck main.cpp

//--- main.cpp
#include <stdio.h>
struct Speaker {
  const char *Name;
  Speaker(const char *Name) : Name(Name) { printf("begin %s\n", Name); }
  ~Speaker() { printf("end %s\n", Name); }
};
Speaker Ordinary("ordinary");
__attribute__((init_priority(300))) Speaker Prior("prior");
int main() { printf("main\n"); }

// CHECK: early
// CHECK-NEXT: begin prior
// CHECK-NEXT: begin ordinary
// CHECK-NEXT: main
// CHECK-NEXT: end ordinary
// CHECK-NEXT: end prior

//--- early.cpp
#include <stdio.h>
__attribute__((constructor(150))) static void early() { printf("early\n"); }
