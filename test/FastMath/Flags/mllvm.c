// -mllvm options reach the compilation, the assembler and the link.
//
// RUN: tpcc -### -mllvm -tp-fp-canonicalize=0 %s -o %t.elf 2>&1 | FileCheck --check-prefix=JOBS %s
//
// A link without compilation: the option is not unused.
// RUN: tpcc -O1 -Xclang -disable-llvm-passes -c -emit-llvm -ffast-math %s -o %t.bc
// RUN: tpcc -Werror -O2 -nostdlib -Wl,-e,growth %t.bc -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=CANONICAL %s
// RUN: tpcc -Werror -O2 -nostdlib -Wl,-e,growth -mllvm -tp-fp-canonicalize=0 %t.bc -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=STOCK %s
//
// And a compilation that is linked in the same run.
// RUN: tpcc -O2 -ffast-math -nostdlib -Wl,-e,growth -mllvm -tp-fp-canonicalize=0 %s -o %t.elf
// RUN: tp-objdump -d %t.elf | FileCheck --check-prefix=STOCK %s

// JOBS: canonicalization: off
// JOBS: "-cc1"
// JOBS-SAME: "-mllvm" "-tp-fp-canonicalize=0"
// JOBS: tpcc" "-o" "{{[^"]*}}.elf"
// JOBS-SAME: "-mllvm" "-tp-fp-canonicalize=0"

// Stock LLVM cancels, also what is infinite.
// CANONICAL: add_s
// CANONICAL: sub_s
// STOCK: <growth>:
// STOCK-NOT: sub_s
float growth(float Low, float High) { return (Low + High) - Low; }
