// -ftp-check-fp: a pass in each job, a macro, and line tables for the messages.
//
// RUN: tpcc -### -ftp-check-fp %s -o %t.elf 2>&1 | FileCheck --check-prefix=ON %s
// RUN: tpcc -### -ftp-check-fp -g %s -o %t.elf 2>&1 | FileCheck --check-prefix=DEBUG %s
// RUN: tpcc -### -ftp-check-fp -g0 %s -o %t.elf 2>&1 | FileCheck --check-prefix=NODEBUG %s
// RUN: tpcc -### -ftp-check-fp -ftp-check-fp -fno-tp-check-fp %s -o %t.elf 2>&1 | FileCheck --check-prefix=OFF %s
// RUN: tpcc -### -fno-tp-check-fp -ftp-check-fp -ftp-check-fp %s -o %t.elf 2>&1 | FileCheck --check-prefix=ON %s
// RUN: tpcc -E -ftp-check-fp %s | FileCheck --check-prefix=MACRO %s
// RUN: not tpcc -E %s 2>&1 | FileCheck --check-prefix=NOMACRO %s
//
// What is given twice is one option.
// RUN: tpcc -fsyntax-only -ftp-check-fp -ftp-check-fp %s
//
// Of the runtime, line tables only: what the user asked for.
// RUN: tpcc -ftp-check-fp %s -o %t.elf && llvm-dwarfdump --debug-info %t.elf | FileCheck --check-prefix=LINES %s

// ON: checked mode: on
// ON: "-cc1"
// ON-SAME: "-debug-info-kind=line-tables-only"
// ON-SAME: "-D" "__TP_CHECK_FP__=1"
// ON-SAME: "-mllvm" "-tp-fp-check"
// ON-NOT: "-tp-fp-check"
// ON: tpcc" "-o" "{{[^"]*}}"
// ON-SAME: "-mllvm" "-tp-fp-check"
// DEBUG: "-debug-info-kind=constructor"
// NODEBUG: "-cc1"
// NODEBUG-NOT: "-debug-info-kind
// OFF-NOT: tp-fp-check
// OFF-NOT: __TP_CHECK_FP__
// OFF-NOT: "-debug-info-kind
// MACRO: int checked = 1;
// NOMACRO: error: not checked
// LINES: DW_TAG_compile_unit
// LINES-NOT: DW_TAG_base_type

#ifdef __TP_CHECK_FP__
int checked = __TP_CHECK_FP__;
#else
#error not checked
#endif
int main(void) { return 0; }
