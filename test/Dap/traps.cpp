// A trap is an exception: the client learns where, why and in which thread.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s node %S/Inputs/traps.js

static int load(volatile int *From) {
  return *From; // traps
}

int main() {
  volatile int Value = 3; // begin
  int Sum = load(&Value);
  Sum += load(nullptr); // call
  return Sum;
}
