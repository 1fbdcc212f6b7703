// Where the time goes, in the front end and in the link of the whole program.
//
// RUN: rm -rf %t && mkdir %t
// RUN: tpcc -O1 -ftime-report -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=COMPILE %s
// RUN: tpcc -O1 -ftime-report %s -o %t/x.elf 2>&1 | FileCheck --check-prefix=LINK %s
// RUN: tpcc -O1 -ftime-report=per-pass-run -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=COMPILE %s
// RUN: tpcc -O1 -ftime-trace -c %s -o %t/x.o
// RUN: %python -m json.tool %t/x.json > %t/x.txt && FileCheck --check-prefix=FRONTEND %s < %t/x.txt
// RUN: tpcc -O1 -ftime-trace=%t/named.json -ftime-trace-granularity=0 -c %s -o %t/x.o
// RUN: %python -m json.tool %t/named.json > %t/x.txt && FileCheck --check-prefix=FRONTEND %s < %t/x.txt
// RUN: tpcc -O1 -ftime-trace -ftime-trace-granularity=0 %s -o %t/x.elf
// RUN: %python -m json.tool %t/x.elf.time-trace > %t/x.txt && FileCheck --check-prefix=PROGRAM %s < %t/x.txt
// RUN: tpcc -O1 -save-stats=obj -c %s -o %t/x.o && FileCheck --check-prefix=STATISTICS %s < %t/time-report.stats

// COMPILE: Pass execution timing report
// COMPILE: TP DAG->DAG Pattern Instruction Selection
// COMPILE: Clang time report
// COMPILE: Front end
// LINK: Clang time report
// LINK: Pass execution timing report
// LINK: TP Assembly Printer
// FRONTEND: "name": "ExecuteCompiler"
// PROGRAM: "name": "OptimizeProgram"
// STATISTICS: {

int main(void) { return 0; }
