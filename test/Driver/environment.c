// What the environment says: edits of the command line, header folders.
//
// RUN: env CCC_OVERRIDE_OPTIONS='#^-O2 +-DEDITED' tpcc -### -c %s 2>&1 | FileCheck --check-prefix=EDITED %s
// RUN: env CCC_OVERRIDE_OPTIONS='x-c +-S' tpcc -c %s -o %t.s 2>&1 | FileCheck --check-prefix=EDITS %s
// RUN: FileCheck --check-prefix=ASSEMBLY %s < %t.s
// RUN: env CPATH=%S/Inputs tpcc -fsyntax-only -DINCLUDED %s
// RUN: env C_INCLUDE_PATH=%S/Inputs tpcc -fsyntax-only -DINCLUDED %s
// RUN: not tpcc -fsyntax-only -DINCLUDED %s
// RUN: env SOURCE_DATE_EPOCH=0 tpcc -E -DDATED %s | FileCheck --check-prefix=DATE %s

// EDITED: "-O2"
// EDITED-SAME: "-D" "EDITED"
// EDITS: ### CCC_OVERRIDE_OPTIONS: x-c +-S
// EDITS: ### Deleting argument -c
// EDITS: ### Adding argument -S at end
// ASSEMBLY: value:
#ifdef INCLUDED
#include <answer.c>
#endif
#ifdef DATED
// DATE: "Jan  1 1970"
const char *Date = __DATE__;
#endif
int value(void) { return 1; }
