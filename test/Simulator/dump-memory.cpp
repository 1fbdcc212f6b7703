// --dump-memory writes what a variable holds at the end of the run.

// RUN: rm -f %t.*
// RUN: tpcc -O2 %s -o %t.elf
// RUN: tpsim --chip 1x1 --quiet --dump-memory 'sums=%t.sums' \
// RUN:     --dump-memory=results::count=%t.count %t.elf
// RUN: od -An -tx4 %t.sums | FileCheck %s --check-prefix=SUMS
// RUN: od -An -tx4 %t.count | FileCheck %s --check-prefix=COUNT
// SUMS: {{^}} 00000001 00000003 00000006 0000000a{{$}}
// SUMS-NOT: {{.}}
// COUNT: {{^}} 00000004{{$}}
// COUNT-NOT: {{.}}

// RUN: not tpsim --chip 1x1 --dump-memory nothing=%t.x %t.elf 2>&1 \
// RUN:     | FileCheck %s --check-prefix=NONE
// NONE: error: {{.*}}.elf: --dump-memory 'nothing': the program has no such variable; one marked {{.*gnu::used.*}} stays in it
// RUN: not tpsim --chip 1x1 --dump-memory main=%t.x %t.elf 2>&1 \
// RUN:     | FileCheck %s --check-prefix=FUNCTION
// FUNCTION: --dump-memory 'main': the program has no such variable
// RUN: not tpsim --chip 1x1 --dump-memory own=%t.x %t.elf 2>&1 \
// RUN:     | FileCheck %s --check-prefix=LOCAL
// LOCAL: --dump-memory 'own': the program has no such variable
// RUN: not tpsim --chip 1x1 --dump-memory sums %t.elf 2>&1 \
// RUN:     | FileCheck %s --check-prefix=WORDS
// WORDS: error: --dump-memory 'sums': expected <variable>=<file>
// RUN: not tpsim --chip 1x1 --dump-memory sums=%t.no/file %t.elf 2>&1 \
// RUN:     | FileCheck %s --check-prefix=FILE
// FILE: error: cannot write {{.*}}.no/file: No such file or directory

[[gnu::used]] unsigned sums[4];
[[gnu::used]] thread_local unsigned own = 5;
namespace results {
[[gnu::used]] unsigned count;
}

int main() {
  for (unsigned I = 0, Sum = 0; I < 4; ++I) {
    Sum += I + 1;
    sums[I] = Sum;
    ++results::count;
  }
  return 0;
}
