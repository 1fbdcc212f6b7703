// What C has besides: initializers, literals, complex numbers, generic
// selection, statement expressions, flexible arrays, strings, volatile.
// RUN: %compare %s %t -std=gnu2x --native clang
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct Point { int X, Y; struct { float Z; char Name[8]; }; };
static const struct Point Points[] = {
    [2] = {.Y = 5, .X = 1, .Z = 1.5f, .Name = "two"}, [0].X = 7, [1] = {1, 2}};
static int Matrix[3][4] = {{1, 2}, [2][3] = 9, [1] = {[1 ... 2] = 6}};
struct Flexible { int Count; short Data[]; };
static struct Flexible Flexible = {3, {10, 20, 30}};
static const char *const Strings[] = {"a\tb", "\x41\102\u00e9", u8"ü"};
static const wchar_t Wide[] = L"wide ü";
static const uint_least16_t Short[] = u"s\U0001F600";
constexpr int Size = 5;
enum Color : uint8_t { Red = 3, Green = 250 };
typedef int (*Operation)(int, int);
static int plus(int A, int B) { return A + B; }
static int minus(int A, int B) { return A - B; }
static const struct { const char *Name; Operation Run; } Table[] = {
    {"plus", plus}, {"minus", minus}};
static int *const Relative = &Matrix[2][3];
static const ptrdiff_t Distance = (char *)&Points[2] - (char *)&Points[1];

#define KIND(X) _Generic((X), int: "int", float: "float", double: "double",    \
                         long long: "long long", char *: "string",             \
                         const int *: "pointer", default: "other")
#define MAX(A, B) ({ auto A_ = (A); auto B_ = (B); A_ > B_ ? A_ : B_; })

__attribute__((noinline)) _Complex float spin(_Complex float A, _Complex float B) {
  return A * B + A / B - __builtin_conjf(A) * 2;
}
__attribute__((noinline)) _Complex double wide(_Complex double A, int N) {
  _Complex double R = 1;
  while (N--) R *= A;
  return R / (A + 1.5i);
}
static int local(int V) {
  static int Calls = 100;
  struct Local { int A; } L = {V};
  { int V = 3; L.A += V; }
  return L.A + Calls++;
}
static int array(int A[static 3], size_t N) { return A[N - 1] + (int)sizeof(A[0]); }

int main(void) {
  printf("%d %d %d %g %s\n", Points[0].X, Points[1].Y, Points[2].Y, Points[2].Z,
         Points[2].Name);
  printf("%d %d %d %d\n", Matrix[0][1], Matrix[1][2], *Relative, (int)(Distance / sizeof(struct Point)));
  struct Flexible *F = &Flexible;
  printf("%d %d\n", F->Data[F->Count - 1], (int)offsetof(struct Flexible, Data));
  printf("%s %s %s %d %d\n", Strings[0], Strings[1], Strings[2],
         (int)(sizeof Wide / sizeof *Wide), Short[1]);
  printf("%s %s %s %s %s %s\n", KIND(1), KIND(1.f), KIND(1.), KIND(1ll), KIND("x"), KIND('x' == 1u));
  printf("%d %g\n", MAX(3, Size), MAX(2.5, -1.0));
  _Complex float C = spin(1 + 2i, -0.5f + 3i);
  printf("%.6g %.6g\n", __builtin_crealf(C), __builtin_cimagf(C));
  _Complex double D = wide(0.5 - 0.25i, 5);
  printf("%.12g %.12g %d\n", __builtin_creal(D), __builtin_cimag(D), D == __builtin_conj(D));
  printf("%d %d\n", local(1), local(2));
  printf("%d\n", array((int[]){1, 2, 3}, 3));
  enum Color Color = Green;
  Color += 10;
  printf("%d %d %d\n", Color, (int)sizeof Color, Table[1].Run(Table[0].Run(5, 6), 2));
  volatile struct { volatile int A; const volatile char *B; } V = {1, "vol"};
  V.A++;
  printf("%d %c\n", V.A + V.A, V.B[1]);
  bool B = 0.5;
  unsigned char U = 300;
  signed char S = -1;
  printf("%d %d %d %u\n", B, U, S >> 1, (unsigned)S >> 28);
  typeof_unqual(Points[0]) Copy = Points[2], Other = (struct Point){.Name = "xyz"};
  Copy = Copy.X ? Other : Copy;
  printf("%s %d\n", Copy.Name, nullptr == (void *)0);
  int I = 5;
  I = I++ + 0 * I;
  printf("%d %d %d\n", -7 / 2, -7 % 3, 7u / 2);
  printf("%d %lld %g\n", (int)3.99, (long long)-1e15, (double)(float)0.1);
  printf("%d\n", ({ int T = 0; for (int J = 0; J < 5; ++J) T += J; T; }));
  printf("%s:%d %s\n", "file", __LINE__ > 0, __func__);
  register int R = 4;
  printf("%d %d\n", R ?: 7, 0 ?: 7);
  char Text[] = "mutable";
  Text[0] ^= 0x20;
  printf("%s %zu %d\n", Text, sizeof Text, strcmp(Text, "Mutable"));
  printf("%d %d\n", 0b1011, 1'000'000);
  printf("%x\n", (unsigned)-1 % 10 + 'a' - L'a' + U'\x10');
  long double LD = 1.0L / 3;
  printf("%d\n", LD > 0.333L && LD < 0.334L);
}
