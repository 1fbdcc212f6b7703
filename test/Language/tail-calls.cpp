// Calls that must be tail calls: with arguments on the stack, structs by value,
// exchanged arguments, struct results, through pointers and members; thunks of
// variadic virtual functions.
// RUN: %compare %s %t --native clang -std=c++20
#include <cstdarg>
#include <cstdint>
#include <cstdio>

struct Big { int V[7]; };
struct Huge { int V[60]; };

__attribute__((noinline)) int target(int A, int B, int C, int D, int E, int F,
                                     int G, int H, int I, int64_t J, float K) {
  return A + 2 * B + 3 * C + 4 * D + 5 * E + 6 * F + 7 * G + 8 * H + 9 * I + (int)J * 10 + (int)K;
}
__attribute__((noinline)) int exchange(int A, int B, int C, int D, int E, int F,
                                       int G, int H, int I, int64_t J, float K) {
  [[clang::musttail]] return target(B, A, C, I, E, F, G, (int)J, H, D, K);
}
__attribute__((noinline)) int structs(Big A, int X, Huge H, Big B) {
  return A.V[3] * X + B.V[6] - H.V[59];
}
__attribute__((noinline)) int swapped(Big A, int X, Huge H, Big B) {
  A.V[6]++;
  H.V[59] += X;
  [[clang::musttail]] return structs(B, X + 1, H, A);
}
__attribute__((noinline)) int passed(Big A, int X, Huge H, Big B) {
  [[clang::musttail]] return swapped(A, X * 2, H, B);
}
__attribute__((noinline)) int far(int, int, int, int, int, int, int, int, Big A, Big B) {
  return A.V[0] * 10 + B.V[0];
}
__attribute__((noinline)) int farther(int A, int B, int C, int D, int E, int F, int G, int H, Big I, Big J) {
  [[clang::musttail]] return far(B, A, D, C, F, E, H, G, J, I);
}
__attribute__((noinline)) Big result(int X) { return {{X, X, X, X * 2}}; }
__attribute__((noinline)) Big results(int X) { [[clang::musttail]] return result(X + 1); }

// A loop without a loop: the stack must not grow.
struct Machine { const char *Code; int64_t Value; };
using Step = int (*)(Machine, int, int, int, int, int, int, int, int64_t);
static int add(Machine, int, int, int, int, int, int, int, int64_t);
static int end(Machine M, int, int, int, int, int, int, int, int64_t Sum) { return (int)(M.Value + Sum); }
static const Step Steps[] = {add, end};
static int add(Machine M, int A, int B, int C, int D, int E, int F, int G, int64_t Sum) {
  Step Next = Steps[A == 0];
  M.Value += A & 3;
  [[clang::musttail]] return Next(M, A - 1, C, B, D, F, E, G, Sum + B * D);
}

struct First {
  int A = 1;
  virtual int f(int Count, ...) = 0;
  int call(int V, int W) { return A * V + W; }
};
struct Second {
  int B = 2;
  virtual int g(int Count, ...) = 0;
  virtual int h(Big V, int, int, int, int, int, int, int, int Last) = 0;
};
struct Both : First, Second {
  int C = 3;
  int f(int Count, ...) override { return C + Count; }
  int g(int Count, ...) override {
    va_list List;
    va_start(List, Count);
    double Sum = C;
    while (Count--) Sum += va_arg(List, double);
    va_end(List);
    return (int)Sum;
  }
  int h(Big V, int, int, int, int, int, int, int, int Last) override { return V.V[2] + Last + C; }
};
__attribute__((noinline)) int useSecond(Second *S, Big B) {
  return S->g(3, 1.0, 2.0, 3.5) + S->h(B, 1, 2, 3, 4, 5, 6, 7, 800);
}

int main() {
  Big A = {{1, 2, 3, 4, 5, 6, 7}}, B = {{11, 12, 13, 14, 15, 16, 17}};
  Huge H = {{}};
  H.V[59] = 1000;
  std::printf("%d\n", exchange(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11.5f));
  std::printf("%d %d\n", swapped(A, 3, H, B), passed(A, 5, H, B));
  std::printf("%d %d\n", farther(1, 2, 3, 4, 5, 6, 7, 8, A, B), results(4).V[3]);
  std::printf("%d\n", add({"", 5}, 20000, 1, 2, 3, 4, 5, 6, 7));
  Both O;
  std::printf("%d\n", useSecond(&O, A));
  std::printf("%d %d\n", A.V[6], B.V[6]);
}
