// What the presets are, and that they forget every floating-point option before
// them; options behind them win.
//
// RUN: tpcc -### -c -ftp-fp=strict %s -o x.o 2> %t.strict
// RUN: tpcc -### -c -ftp-fp=reproducible %s -o x.o 2> %t.reproducible
// RUN: tpcc -### -c -ftp-fp=fast %s -o x.o 2> %t.fast
// RUN: FileCheck --check-prefix=STRICT %s < %t.strict
// RUN: FileCheck --check-prefix=REPRODUCIBLE %s < %t.reproducible
// RUN: FileCheck --check-prefix=FAST %s < %t.fast
//
// strict is the default and fast is -ffast-math.
// RUN: tpcc -### -c %s -o x.o 2>&1 | diff - %t.strict
// RUN: tpcc -### -c -ffast-math %s -o x.o 2>&1 | diff - %t.fast
//
// RUN: tpcc -### -c -ffast-math -ffp-contract=on -fmath-errno -frounding-math -ffp-exception-behavior=strict -fdenormal-fp-math=preserve-sign -fstrict-float-cast-overflow -fcx-limited-range -fprotect-parens -ffp-eval-method=double -ftp-fp=strict %s -o x.o 2>&1 | diff - %t.strict
// RUN: tpcc -### -c -ffp-model=strict -ftrapping-math -fno-fast-math -fhonor-nans -fmath-errno -ftp-fp=reproducible %s -o x.o 2>&1 | diff - %t.reproducible
// RUN: tpcc -### -c -ffp-model=aggressive -fno-associative-math -fno-approx-func -ffp-contract=off -ftp-fp=fast %s -o x.o 2>&1 | diff - %t.fast
// RUN: tpcc -### -c -ftp-fp=fast -ftp-fp=reproducible -ftp-fp=strict %s -o x.o 2>&1 | diff - %t.strict
// RUN: tpcc -### -c -ftp-fp=strict -ftp-fp=fast %s -o x.o 2>&1 | diff - %t.fast
//
// Of -Ofast the optimization level stays.
// RUN: tpcc -### -c -O3 -ftp-fp=strict %s -o x.o 2> %t.strict3
// RUN: tpcc -### -c -Ofast -ftp-fp=strict %s -o x.o 2>&1 | diff - %t.strict3
//
// RUN: tpcc -### -c -ftp-fp=strict -ffast-math %s -o x.o 2>&1 | diff - %t.fast
// RUN: tpcc -### -c -ftp-fp=fast -fno-fast-math %s -o x.o 2>&1 | diff - %t.strict
// RUN: tpcc -### -c -ftp-fp=fast -fno-finite-math-only -ffp-contract=off %s -o x.o 2>&1 | FileCheck --check-prefix=HONOUR %s
// RUN: tpcc -### -c -ftp-fp=reproducible -fno-associative-math %s -o x.o 2>&1 | FileCheck --check-prefix=ORDER %s
//
// None of these complains.
// RUN: tpcc -fsyntax-only -Werror -ffp-model=strict -ftp-fp=fast -ffp-contract=off %s
// RUN: tpcc -fsyntax-only -Werror -ffast-math -ftp-fp=strict -ffp-contract=on %s
// RUN: tpcc -fsyntax-only -Werror -ftp-fp=fast -fno-fast-math %s
// RUN: tpcc -c -Werror -ftp-fp=strict %s -o %t.o
// RUN: tpcc -Werror -ftp-fp=fast -mfma -ftp-check-fp -nostdlib -Wl,-e,mac %t.o -o %t.elf

// STRICT: "-ffp-contract=off"
// STRICT-NOT: "-mreassociate"
// STRICT-NOT: "-freciprocal-math"
// STRICT-NOT: "-fapprox-func"
// STRICT-NOT: "-fno-signed-zeros"
// STRICT-NOT: "-fmath-errno"

// REPRODUCIBLE-NOT: "-menable-no-infs"
// REPRODUCIBLE-NOT: "-menable-no-nans"
// REPRODUCIBLE: "-fapprox-func"
// REPRODUCIBLE-SAME: "-fno-signed-zeros"
// REPRODUCIBLE-SAME: "-mreassociate"
// REPRODUCIBLE-SAME: "-freciprocal-math"
// REPRODUCIBLE-SAME: "-ffp-contract=off"
// REPRODUCIBLE-NOT: "-ffinite-math-only"

// FAST: "-menable-no-infs" "-menable-no-nans"
// FAST-SAME: "-ffp-contract=fast"
// FAST-SAME: "-ffast-math" "-ffinite-math-only"

// HONOUR-NOT: "-menable-no-infs"
// HONOUR: "-mreassociate"
// HONOUR-SAME: "-ffp-contract=off"
// ORDER-NOT: "-mreassociate"
// ORDER: "-freciprocal-math"

float mac(float A, float B, float C) { return A * B + C; }
