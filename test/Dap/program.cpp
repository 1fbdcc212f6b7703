// A client that is not ours, Microsoft's @vscode/debugadapter-testsupport,
// debugs this program through `tpdbg --dap`. Each script is a suite of its own.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/breakpoints.js
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/lifecycle.js
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/memory.js
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/robustness.js
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/stepping.js
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/variables.js

#include <cstdint>
#include <cstdio>

enum class Color : uint8_t { Red, Green = 5 };

struct Base {
  int Id = 7;
};

struct Node : Base {
  float Bounds[3] = {1.5f, -2.0f, 0.25f};
  Color Tint = Color::Green;
  unsigned Flags : 3 = 5;
  const char *Name = "root";
  Node *Next = nullptr;
};

Node Tree[300];
int Counter;
thread_local int Scratch = 11;

static int sum(const int *Values, int Count) {
  int Total = 0;
  for (int I = 0; I < Count; ++I)
    Total += Values[I]; // in the loop
  return Total;         // end of sum
}

static void count(int Times) {
  for (int I = 0; I < Times; ++I)
    ++Counter; // counts
}

int main() {
  int Numbers[4] = {1, 2, 3, 4};
  Node Local; // after numbers
  Local.Next = &Tree[2];
  Node &Alias = Local;
  Tree[2].Id = 42;
  Alias.Id += Scratch;
  int Result = sum(Numbers, 4); // call
  count(20);                    // after the call
  printf("sum %d\n", Result);   // prints
  return Result - 10;           // end
}
