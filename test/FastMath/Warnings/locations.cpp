// Where the warnings point, and what they propose.

// RUN: clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so -ffast-math \
// RUN:   -fsyntax-only -fdiagnostics-parseable-fixits %s 2>&1 \
// RUN:   | FileCheck --strict-whitespace %s
// RUN: tpcc -ffast-math -fsyntax-only -fdiagnostics-print-source-range-info \
// RUN:   -fno-caret-diagnostics %s 2>&1 | FileCheck --check-prefix=RANGES %s
// RUN: tpcc -ffast-math -fsyntax-only -fno-diagnostics-show-option %s 2>&1 \
// RUN:   | FileCheck --check-prefix=NAMELESS %s
// NAMELESS: warning: this test for NaN may be folded away under finite math{{$}}
// NAMELESS-NOT: [-W

bool isNaN(float X) { return X != X; }
// CHECK: :[[@LINE-1]]:32: warning: this test for NaN
// CHECK-NEXT: {{^ *[0-9]+ \| bool isNaN}}
// CHECK-NEXT: {{^ +\|                              ~~\^~~~$}}
// RANGES: :[[@LINE-4]]:32:{[[@LINE-4]]:30-[[@LINE-4]]:36}: warning:

extern int Counts[9];
void count(float X, float W) { ++Counts[int(X / W)]; }
// CHECK: :[[@LINE-1]]:45: warning: an index out of range may come
// CHECK: {{^ +\|                                             \^~~~~$}}
// CHECK: :[[@LINE-3]]:47: note: this division may become
// CHECK: :[[@LINE-4]]:41: note: used as an index here

struct Point {
  float X, Y;
};
bool less(const Point &A, const Point &B) {
  return A.X * B.Y - A.Y * B.X > 0;
}
// CHECK: :[[@LINE-2]]:20: warning: 'sort' orders by the sign
// CHECK: {{^ +\|          ~~~~~~~~~ \^ ~~~~~~~~~$}}
// CHECK: :[[@LINE+8]]:8: note: the order of 'sort' is chosen here
// CHECK: :[[@LINE-6]]:43: note: compare a key
// CHECK: fix-it:"{{.*}}locations.cpp":{[[@LINE-7]]:44-[[@LINE-7]]:44}:"\n#pragma clang fp contract(off) reassociate(off) reciprocal(off)\n"

template <class Compare> void sort(Compare Less) {
  Less(Point(), Point());
}
void use() {
  sort(less);
}
