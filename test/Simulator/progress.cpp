// A progress line on a terminal, and nowhere else.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: not %python %S/Inputs/on_terminal.py tpsim --chip 4x32 --max-cycles 3000000 %t.elf > %t.tty
// RUN: FileCheck %s --check-prefix=TTY < %t.tty
// TTY: cycle {{[0-9,]+}}, {{[0-9.]+}} million thread-instructions/s, {{[0-9.]+}} % done, {{[0-9]+}} s left
// RUN: not %python %S/Inputs/on_terminal.py tpsim --quiet --chip 4x32 --max-cycles 3000000 %t.elf > %t.quiet
// RUN: FileCheck %s --check-prefix=QUIET < %t.quiet
// QUIET-NOT: thread-instructions/s, {{[0-9.]+}} %
// RUN: not tpsim --chip 4x32 --max-cycles 3000000 %t.elf 2> %t.file
// RUN: FileCheck %s --check-prefix=QUIET < %t.file

// Nobody knows how much work a program without a picture and a limit has.
// RUN: tpcc -O1 -DROUNDS=100000 %s -o %t.ends.elf
// RUN: %python %S/Inputs/on_terminal.py tpsim --chip 4x32 %t.ends.elf > %t.unknown
// RUN: FileCheck %s --check-prefix=UNKNOWN < %t.unknown
// UNKNOWN: million thread-instructions/s, 0 threads halted

#ifndef ROUNDS
#define ROUNDS 1000000000
#endif

int main() {
  for (volatile int Round = 0; Round < ROUNDS; Round = Round + 1)
    ;
}
