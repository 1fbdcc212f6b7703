// Every header of libstdc++ that the TP has compiles alone, in each standard;
// the others say what is missing.
// RUN: %python %S/Inputs/library_headers.py tpcc
// RUN: not tpcc -fsyntax-only -include iostream %s 2>&1 \
// RUN:   | FileCheck --check-prefix=STREAMS %s
// RUN: not tpcc -fsyntax-only -include mutex %s 2>&1 \
// RUN:   | FileCheck --check-prefix=THREADS %s
// STREAMS-COUNT-1: error:
// STREAMS-SAME: the TP has no streams; print with <cstdio>
// STREAMS-NOT: error:
// THREADS-COUNT-1: error:
// THREADS-SAME: the TP has no std::thread
// THREADS-NOT: error:
