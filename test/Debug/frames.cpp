// The stack can be unwound at every instruction of frames of each kind: large,
// aligned anew, of variable size, with saved floats, shrink-wrapped, with early
// returns.
//
// RUN: tpcc -O0 -g %s -o %t.0 && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.0.txt %t.0
// RUN: %python %S/Inputs/check_unwinding.py %t.0 %t.0.txt
// RUN: tpcc -O2 -g %s -o %t.2 && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.2.txt %t.2
// RUN: %python %S/Inputs/check_unwinding.py %t.2 %t.2.txt
// RUN: tpcc -O2 -g -fno-omit-frame-pointer -fno-lto %s -o %t.fp && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.fp.txt %t.fp
// RUN: %python %S/Inputs/check_unwinding.py %t.fp %t.fp.txt
// RUN: tpcc -Oz -g %s -o %t.z && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.z.txt %t.z
// RUN: %python %S/Inputs/check_unwinding.py %t.z %t.z.txt
//
// Code without frame information is not taken for right.
// RUN: tpcc -O2 -g %s -o %t.bare && llvm-objcopy --remove-section=.debug_frame %t.bare
// RUN: not %python %S/Inputs/check_unwinding.py %t.bare %t.2.txt | FileCheck %s
// CHECK: no frame information

#define NOINLINE __attribute__((noinline))

volatile int Sink;
NOINLINE int leaf(int A) { return Sink += A; }

NOINLINE int large(int A) {
  volatile char Bytes[40000];
  Bytes[A] = char(A);
  return leaf(Bytes[A]);
}

NOINLINE int aligned(int A) {
  alignas(128) volatile int Values[8];
  Values[A & 7] = leaf(A);
  return Values[A & 7] + leaf(3);
}

NOINLINE int variable(int A, int, int, int, int, int, int, int, int I) {
  volatile int Values[A];
  alignas(64) volatile int Other[4];
  Values[A - 1] = leaf(A);
  Other[A & 3] = I;
  return large(Values[A - 1] & 15) + Other[A & 3];
}

NOINLINE float floats(float A, float B) {
  float C = A * B;
  leaf(int(A));
  float D = C + B;
  leaf(int(C));
  return A + B + C + D;
}

NOINLINE int shrinkWrapped(int A) {
  if (A > 5)
    return A;
  int B = leaf(A);
  return leaf(B) + A;
}

[[noreturn]] NOINLINE void stop(int A) {
  while (true)
    Sink = A;
}
// Code without the frame lies behind code with it.
NOINLINE int frameInTheMiddle(int A) {
  int B = A * 3;
  if (__builtin_expect(B == 6, 1)) {
    int C = leaf(A);
    leaf(B + C);
    stop(C);
  }
  for (int I = 0; I < A; ++I)
    B ^= B << 1;
  return B;
}

NOINLINE int earlyReturns(int A, int B) {
  if (leaf(A) & 1)
    return A;
  if (leaf(B) & 2)
    return leaf(A) + B;
  return A * B;
}

NOINLINE int recursion(int N) {
  return N < 2 ? N : recursion(N - 1) + recursion(N - 2);
}

NOINLINE int tailCall(int A) { return leaf(A + 1); }

NOINLINE int pointer(int (*Function)(int), int A) {
  return Function(A) + Function(A + 1);
}

int main(int Count, char **) {
  int Sum = large(100 * Count) + aligned(5 * Count);
  Sum += variable(7 * Count, 1, 2, 3, 4, 5, 6, 7, 8);
  Sum += int(floats(float(Count), 2.5f));
  Sum += shrinkWrapped(Count) + shrinkWrapped(10 * Count);
  Sum += frameInTheMiddle(5 * Count);
  for (int I = 0; I < 4; ++I)
    Sum += earlyReturns(I * Count, I + 1);
  Sum += recursion(5 * Count) + tailCall(Count);
  Sum += pointer(shrinkWrapped, Count) + pointer(tailCall, Count);
  return Sum == 0;
}
