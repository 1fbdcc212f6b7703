// A run without timing, sources that have been moved, and the progress of a run
// that takes long.
//
// RUN: tpcc -O0 -g %s -o %t.elf
// RUN: mkdir -p %t.moved && cp %s %t.moved/modes.cpp
// RUN: env DAP_PROGRAM=%t.elf DAP_SOURCE=%s DAP_MOVED=%t.moved/modes.cpp node %S/Inputs/modes.js

volatile unsigned Rounds;

static void turn() {
  Rounds = Rounds + 1; // turns
}

int main() {
  turn(); // first
  turn(); // second
  while (true)
    turn();
}
