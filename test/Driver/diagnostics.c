// The forms of messages, also those of the linker.
//
// RUN: not tpcc -fsyntax-only %s 2>&1 | FileCheck --check-prefix=PLAIN %s
// RUN: not tpcc -fsyntax-only -fcolor-diagnostics %s 2>&1 | FileCheck --check-prefix=COLOR %s
// RUN: not tpcc -fsyntax-only -fdiagnostics-color=always %s 2>&1 | FileCheck --check-prefix=COLOR %s
// RUN: not tpcc -fsyntax-only -fdiagnostics-color=never %s 2>&1 | FileCheck --check-prefix=PLAIN %s
// RUN: not tpcc -fsyntax-only -fdiagnostics-format=msvc %s 2>&1 | FileCheck --check-prefix=MSVC %s
// RUN: not tpcc -fsyntax-only -fdiagnostics-format=vi %s 2>&1 | FileCheck --check-prefix=VI %s
// RUN: not tpcc -fsyntax-only -fdiagnostics-format=sarif -Wno-sarif-format-unstable %s 2>&1 | grep '^{' | %python -m json.tool | FileCheck --check-prefix=SARIF %s
// RUN: not tpcc -fsyntax-only -fno-caret-diagnostics %s 2>&1 | FileCheck --check-prefix=PLAIN --implicit-check-not=^ %s
// RUN: not tpcc -fsyntax-only -fno-diagnostics-show-option %s 2>&1 | FileCheck --check-prefix=NOOPTION %s
// RUN: not tpcc -fsyntax-only -ferror-limit=1 -DTWICE %s 2>&1 | FileCheck --check-prefix=LIMIT %s
// RUN: not tpcc -fsyntax-only --serialize-diagnostics %t.dia %s
// RUN: llvm-bcanalyzer --dump %t.dia | FileCheck --check-prefix=DIA %s
// RUN: tpcc -fsyntax-only -Wdouble-promotion -DPROMOTION %s 2>&1 | FileCheck --check-prefix=PROMOTION %s
//
// RUN: not tpcc -DNONE %S/Inputs/answer.c -lnowhere 2>&1 | FileCheck --check-prefix=LINK %s
// RUN: not tpcc -fcolor-diagnostics %S/Inputs/answer.c -lnowhere 2>&1 | FileCheck --check-prefix=LINKCOLOR %s

#ifdef PROMOTION
// PROMOTION: warning: implicit conversion increases floating-point precision: 'float' to 'double' [-Wdouble-promotion]
double twice(float X) { return X * 2.0; }
#else
void check(int X) {
  if (X = 1)
    return;
}
// PLAIN: diagnostics.c:[[@LINE-3]]:9: warning: using the result of an assignment as a condition without parentheses [-Wparentheses]
// MSVC: diagnostics.c([[@LINE-4]],9): warning:
// VI: diagnostics.c +[[@LINE-5]]:9: warning:
// NOOPTION: without parentheses{{$}}
int Value = missing;
// PLAIN: diagnostics.c:[[@LINE-1]]:13: error: use of undeclared identifier 'missing'
// COLOR: {{.\[0;1;31m}}error: {{.*}}use of undeclared identifier
// DIA: use of undeclared identifier
// SARIF: "text": "use of undeclared identifier 'missing'"
#ifdef TWICE
int Other = absent;
int Third = gone;
// LIMIT: fatal error: too many errors emitted, stopping now [-ferror-limit=]
#endif
#endif
// LINK: {{^}}tpcc: error: cannot find library '-lnowhere'
// LINKCOLOR: tpcc: {{.\[0;1;31m}}error: {{.\[0m}}cannot find library
