// Contraction and errno go back to tpcc's defaults where clang's go back to
// clang's.
//
// RUN: tpcc -### -c %s -o x.o 2> %t.default
// RUN: tpcc -### -c -ffast-math -fno-fast-math %s -o x.o 2>&1 | diff - %t.default
// RUN: tpcc -### -c -ffp-model=fast -fno-fast-math %s -o x.o 2>&1 | diff - %t.default
// RUN: tpcc -### -c -funsafe-math-optimizations -fno-unsafe-math-optimizations %s -o x.o 2>&1 | diff - %t.default
//
// A contraction that the user has asked for comes back.
// RUN: tpcc -### -c -ffp-contract=on %s -o x.o 2> %t.on
// RUN: tpcc -### -c -ffp-contract=on -ffast-math -fno-fast-math %s -o x.o 2>&1 | diff - %t.on
// RUN: tpcc -### -c -ftp-fp=fast -ffp-contract=on -fno-fast-math %s -o x.o 2>&1 | diff - %t.on
//
// RUN: tpcc -### -c -ffp-model=precise %s -o x.o 2>&1 | FileCheck --check-prefix=PRECISE %s
// RUN: tpcc -### -c -ffp-model=precise -fmath-errno %s -o x.o 2>&1 | FileCheck --check-prefix=ERRNO %s
// RUN: tpcc -### -c -Wno-deprecated-ofast -Ofast %s -o x.o 2>&1 | FileCheck --check-prefix=OFAST %s
// RUN: tpcc -### -c -Wno-deprecated-ofast -Ofast -O2 %s -o x.o 2>&1 | FileCheck --check-prefix=O2 %s

// PRECISE-NOT: "-fmath-errno"
// PRECISE: "-ffp-contract=on"
// ERRNO: "-fmath-errno"
// OFAST: "-ffp-contract=fast"
// OFAST-SAME: "-ffast-math"
// O2-NOT: "-ffast-math"
// O2: "-ffp-contract=off"

float one(void) { return 1; }
