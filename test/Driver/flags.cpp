// Clang's flags reach the front end, the optimizer and the link.
//
// RUN: not tpcc -fsyntax-only -Wall -Werror -DUNUSED %s 2>&1 | FileCheck --check-prefix=WERROR %s
// RUN: not tpcc -fsyntax-only -DTHROW %s 2>&1 | FileCheck --check-prefix=THROW %s
// RUN: tpcc -O2 -ffast-math -mllvm -tp-fp-canonicalize=0 -S -emit-llvm %s -o - | FileCheck --check-prefix=FAST %s
// RUN: tpcc -O2 -S -emit-llvm %s -o - | FileCheck --check-prefix=STRICT %s
// RUN: tpcc -O2 -S -emit-llvm -mfma -ffp-contract=fast -mllvm -tp-fp-canonicalize=0 %s -o - | FileCheck --check-prefix=CONTRACT %s
// RUN: tpcc -Os -S -emit-llvm %s -o - | FileCheck --check-prefix=SIZE %s
// RUN: tpcc -fsyntax-only -include cstdint -I%S/Inputs -isystem %S -DINCLUDED %s

// FAST: fmul fast float
// STRICT: fmul float
// STRICT: fadd float
// CONTRACT: fmul contract float
// SIZE: optsize
float mac(float A, float B, float C) { return A * B + C; }

#ifdef UNUSED
// WERROR: error: unused variable 'Nothing' [-Werror,-Wunused-variable]
void unused() { int Nothing; }
#endif
#ifdef THROW
// THROW: error: cannot use 'throw' with exceptions disabled
void fail() { throw 1; }
#endif
#ifdef INCLUDED
#include <answer.c>
std::uint32_t Number = __cplusplus >= 202002L ? 1 : answer();
#endif
