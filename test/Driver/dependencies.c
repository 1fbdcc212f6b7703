// Makefile rules and the entries of a compilation database, in compilations and
// links.
//
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: tpcc -MM %s | FileCheck --check-prefix=USER --implicit-check-not=stdint.h %s
// RUN: tpcc -M %s | FileCheck --check-prefixes=USER,SYSTEM %s
// RUN: tpcc -MMD -c %s -o %t/x.o && FileCheck --check-prefix=USER --implicit-check-not=stdint.h %s < %t/x.d
// RUN: tpcc -MD -c %s -o %t/x.o && FileCheck --check-prefixes=USER,SYSTEM %s < %t/x.d
// RUN: tpcc -MMD -MF %t/named.d -MT first -MQ '$second' -MP -c %s -o %t/x.o
// RUN: FileCheck --check-prefix=NAMED %s < %t/named.d
// RUN: tpcc -M -MG -DMISSING %s | FileCheck --check-prefix=MISSING %s
// RUN: tpcc -MMD %s -o %t/program.elf && FileCheck --check-prefix=PROGRAM %s < %t/program.d
// RUN: tpcc -MJ %t/x.json -c %s -o %t/x.o && sed 's/,$//' %t/x.json | %python -m json.tool | FileCheck --check-prefix=ENTRY %s

// USER: .o:
// USER: dependencies.c
// USER: answer.c
// SYSTEM: lib/tp/include/stdlib.h
// NAMED: first $$second: {{.*}}dependencies.c
// NAMED: answer.c
// NAMED: answer.c:
// MISSING: absent.h
// PROGRAM: program.elf:
// PROGRAM: dependencies.c
// ENTRY: "directory": "{{.*}}dependencies.c.tmp"
// ENTRY: "file": "{{.*}}dependencies.c"
// ENTRY: "--target=tp-unknown-elf"

#include "Inputs/answer.c"
#include <stdlib.h>
#ifdef MISSING
#include "absent.h"
#endif
int main(void) { return answer() - 42; }
