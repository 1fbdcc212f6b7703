// What of each option reaches the canonicalizer as fast-math flags.
//
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm %s -o - | FileCheck --check-prefix=STRICT %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ftp-fp=strict %s -o - | FileCheck --check-prefix=STRICT %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ftp-fp=reproducible %s -o - | FileCheck --check-prefix=REPRODUCIBLE %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ftp-fp=fast %s -o - | FileCheck --check-prefix=FAST %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ftp-fp=fast -fno-finite-math-only %s -o - | FileCheck --check-prefix=HONOUR %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ffast-math %s -o - | FileCheck --check-prefix=FAST %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ffast-math -fno-fast-math %s -o - | FileCheck --check-prefix=STRICT %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -fassociative-math -fno-signed-zeros %s -o - | FileCheck --check-prefix=ASSOCIATIVE %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -Wno-tp-fp -fassociative-math %s -o - | FileCheck --check-prefix=STRICT %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -freciprocal-math %s -o - | FileCheck --check-prefix=RECIPROCAL %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -mfma -ffp-contract=fast %s -o - | FileCheck --check-prefix=CONTRACT %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ffp-contract=on %s -o - | FileCheck --check-prefix=MULADD %s
// RUN: tpcc -O1 -mllvm -tp-fp-canonicalize=0 -S -emit-llvm -ffp-model=strict %s -o - | FileCheck --check-prefix=OBSERVED %s

// STRICT: fmul float
// STRICT: fdiv float
// STRICT: fadd float
// REPRODUCIBLE: fmul reassoc nsz arcp afn float
// REPRODUCIBLE: fdiv reassoc nsz arcp afn float
// FAST: fmul fast float
// FAST: fdiv fast float
// HONOUR: fmul reassoc nsz arcp contract afn float
// ASSOCIATIVE: fmul reassoc nsz float
// RECIPROCAL: fdiv arcp float
// CONTRACT: fmul contract float
// MULADD: call float @llvm.fmuladd.f32
// OBSERVED: call float @llvm.experimental.constrained.fmul.f32
float f(float A, float B, float C) { return A * B + C / B; }

// No errno, so an instruction.
// STRICT: call float @llvm.sqrt.f32
// REPRODUCIBLE: call reassoc nsz arcp afn float @llvm.sqrt.f32
float root(float A) { return __builtin_sqrtf(A); }

// Saturates unless told otherwise.
// STRICT: call i32 @llvm.fptosi.sat.i32.f32
int whole(float A) { return (int)A; }
