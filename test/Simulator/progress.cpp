// A progress line on a terminal, and nowhere else.

// RUN: tpcc -O1 %s -o %t.elf
// RUN: not %python %S/Inputs/on_terminal.py tpsim --chip 4x32 --max-cycles 3000000 %t.elf > %t.tty
// RUN: FileCheck %s --check-prefix=TTY < %t.tty
// TTY: cycle {{[0-9,]+}}, {{[0-9.]+}} million thread-instructions/s, 0 threads halted
// RUN: not %python %S/Inputs/on_terminal.py tpsim --quiet --chip 4x32 --max-cycles 3000000 %t.elf > %t.quiet
// RUN: FileCheck %s --check-prefix=QUIET < %t.quiet
// QUIET-NOT: threads halted
// RUN: not tpsim --chip 4x32 --max-cycles 3000000 %t.elf 2> %t.file
// RUN: FileCheck %s --check-prefix=QUIET < %t.file

int main() {
  for (volatile int Forever = 1; Forever;)
    ;
}
