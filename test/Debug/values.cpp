// At each probe() the debug information gives the values that the source has
// there: from registers, the stack, constants, callers, parts of structs. And
// the stack can be unwound at every instruction of the run.
//
// RUN: tpcc -O0 -g %s -o %t.0 && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.0.txt %t.0
// RUN: %python %S/Inputs/check_values.py %s %t.0 %t.0.txt --all
// RUN: %python %S/Inputs/check_unwinding.py %t.0 %t.0.txt
// RUN: tpcc -O2 -g %s -o %t.2 && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.2.txt %t.2
// RUN: %python %S/Inputs/check_values.py %s %t.2 %t.2.txt --at-least 115
// RUN: %python %S/Inputs/check_unwinding.py %t.2 %t.2.txt
// RUN: tpcc -O3 -g -fno-lto %s -o %t.3 && tpsim --chip 1x1 --quiet --functional --trace-instructions %t.3.txt %t.3
// RUN: %python %S/Inputs/check_values.py %s %t.3 %t.3.txt --at-least 120
// RUN: %python %S/Inputs/check_unwinding.py %t.3 %t.3.txt
//
// What the check finds wrong it says.
// RUN: sed -e 's/X=42/X=43/' %s > %t.cpp
// RUN: not %python %S/Inputs/check_values.py %t.cpp %t.0 %t.0.txt | FileCheck %s --check-prefix=WRONG
// WRONG: X is 42, not 43

#define NOINLINE __attribute__((noinline))

NOINLINE void probe() { asm volatile("" ::: "memory"); }
template <class T> NOINLINE void use(T Value) {
  asm volatile("" ::"r"(Value) : "memory");
}

struct Pair {
  int Low;
  int High;
};
struct Vector {
  float X, Y, Z;
};
struct Large {
  int Values[12];
  short Small;
  signed char Tiny;
};

thread_local int PerThread = 3;
int Global = 7;

NOINLINE int arguments(int A, unsigned B, short C, bool D, signed char E) {
  probe(); // A=-5 B=4000000000 C=-300 D=1 E=-7 Global=7 PerThread=3
  return A + C + D + E + int(B) + ++Global + ++PerThread;
}

NOINLINE int afterCalls(int A, int B) {
  int X = A * B;
  use(X);
  int Y = X + A;
  probe(); // A=6 B=7 X=42 Y=48
  use(Y);
  probe(); // A=6 B=7 X=42 Y=48
  return X + Y + B;
}

NOINLINE int forgotten(int A, int B) {
  use(A + B);
  probe(); // A=11 B=12
  use(1);
  return 5;
}

NOINLINE int onStack(int A, int B, int C, int D, int E, int F, int G, int H,
                     int I, short J, signed char K) {
  probe(); // A=1 B=2 C=3 D=4 E=5 F=6 G=7 H=8 I=9 J=-10 K=-11
  use(A + B + C + D + E + F + G + H);
  probe(); // I=9 J=-10 K=-11
  return I + J + K;
}

NOINLINE float floats(float A, float B, Vector V) {
  float S = A * B;
  float T = S + V.Y;
  probe(); // A=1.5 B=-2 S=-3 T=2 V.X=4 V.Y=5 V.Z=6
  use(int(T));
  probe(); // S=-3 T=2 V.X=4 V.Y=5 V.Z=6
  return S + T + V.Z;
}

NOINLINE int byValue(Large L, int I) {
  int R = L.Values[I];
  probe(); // L.Values[0]=100 L.Values[11]=111 L.Small=-5 L.Tiny=-6 I=4 R=104
  L.Values[2] = R;
  use(&L);
  probe(); // L.Values[2]=104 L.Values[3]=103 R=104
  return R + L.Values[7];
}

NOINLINE Large result(int A) {
  Large L = {};
  L.Values[3] = A;
  L.Small = -2;
  probe(); // A=9 L.Values[3]=9 L.Small=-2 L.Tiny=0
  use(A);
  return L;
}

NOINLINE int pieces(Pair P) {
  Pair Q = P;
  Q.Low += 5;
  probe(); // P.Low=20 P.High=30 Q.Low=25 Q.High=30
  use(Q.Low);
  probe(); // Q.Low=25 Q.High=30
  return Q.Low * Q.High;
}

NOINLINE int constants(int A) {
  int K = 42;
  const float F = 2.5f;
  probe(); // A=1 K=42 F=2.5
  use(A + K);
  K = 17;
  long long Wide = -4;
  double D = 0.75;
  probe(); // A=1 K=17 Wide=-4 D=0.75
  return int(A + K + F + D + double(Wide));
}

NOINLINE int loop(const int *P, int N) {
  int Sum = 0;
  for (int I = 0; I < N; ++I) {
    Sum += P[I] * I;
    probe(); // I=0|1|2 N=3 Sum=0|11|35
  }
  return Sum;
}

static inline __attribute__((always_inline)) int inner(int Q, int W) {
  int M = Q * W;
  probe(); // Q=3|9 W=9|3 M=27|27
  return M + Q;
}
NOINLINE int inlined(int A, int B) {
  int R = inner(A, B);
  R += inner(B, A);
  probe(); // A=3 B=9 R=66
  return R + A + B;
}

NOINLINE int spilled(const int *P) {
  int A = P[0], B = P[1], C = P[2], D = P[3], E = P[4], F = P[5], G = P[6],
      H = P[7], I = P[8], J = P[9], K = P[10], L = P[11];
  probe(); // A=10 B=11 C=12 D=13 E=14 F=15 G=16 H=17 I=18 J=19 K=20 L=21
  use(A * B);
  probe(); // A=10 B=11 C=12 D=13 E=14 F=15 G=16 H=17 I=18 J=19 K=20 L=21
  return A + B * C + D * E + F * G + H * I + J * K * L;
}

NOINLINE long long wide(long long A, int B, double D) {
  long long C = A * B;
  double E = D + 1;
  probe(); // A=5000000000 B=3 C=15000000000 D=1.25 E=2.25
  use(B);
  probe(); // A=5000000000 C=15000000000 E=2.25
  return C + A + (long long)E;
}

NOINLINE int variableSize(int N) {
  volatile int Array[N];
  for (int I = 0; I < N; ++I)
    Array[I] = I * 3;
  alignas(64) volatile int Aligned[4] = {1, 2, 3, 4};
  probe(); // N=6 Aligned[3]=4
  return Array[N - 1] + Aligned[2];
}

NOINLINE int blocks(int A) {
  int R = A;
  {
    int R = A * 2;
    probe(); // R=16 A=8
    use(R);
  }
  static int Visits = 5;
  ++Visits;
  probe(); // R=8 A=8 Visits=6
  return R + Visits;
}

NOINLINE int tailCalled(int A, int B) {
  probe(); // A=31 B=32
  use(A);
  probe(); // A=31 B=32
  return A - 1;
}
NOINLINE int tailCalls(int A) { return tailCalled(A + 1, A + 2); }

struct Base {
  int Field = 55;
  NOINLINE virtual int method(int A) {
    int R = Field + A;
    probe(); // A=5 R=60
    return R * Field;
  }
};

NOINLINE int recursive(int N) {
  int R = N == 0 ? 0 : recursive(N - 1) + N;
  probe(); // N=0|1|2|3 R=0|1|3|6
  return R;
}

int List[12];

int main(int Count, char **) {
  for (int I = 0; I < 12; ++I)
    List[I] = I + 9 + Count;
  Large L = {};
  for (int I = 0; I < 12; ++I)
    L.Values[I] = 100 + I;
  L.Small = -5 * Count;
  L.Tiny = -6 * Count;
  Base Object;
  volatile int Sum = 0;
  Sum = Sum + arguments(-5 * Count, 4000000000u, short(-300 * Count),
                        Count == 1, -7);
  Sum = Sum + afterCalls(6 * Count, 7);
  Sum = Sum + forgotten(11 * Count, 12);
  Sum = Sum + onStack(Count, 2, 3, 4, 5, 6, 7, 8, 9 * Count, -10, -11);
  Sum = Sum + int(floats(1.5f * float(Count), -2, {4, 5, 6}));
  Sum = Sum + byValue(L, 4 * Count);
  Sum = Sum + result(9 * Count).Values[3];
  Sum = Sum + pieces({20 * Count, 30});
  Sum = Sum + constants(Count);
  Sum = Sum + loop(List, 3 * Count);
  Sum = Sum + inlined(3 * Count, 9);
  Sum = Sum + spilled(List);
  Sum = Sum + int(wide(5000000000ll * Count, 3, 1.25));
  Sum = Sum + variableSize(6 * Count);
  Sum = Sum + blocks(8 * Count);
  Sum = Sum + tailCalls(30 * Count);
  Sum = Sum + static_cast<Base *>(&Object)->method(5);
  Sum = Sum + recursive(3 * Count);
  return Sum == 0;
}
