// C++20: lambdas, templates, concepts, constant evaluation, structured
// bindings, references, operators, enumerations, static and thread-local
// objects, new and delete.
// RUN: %compare %s %t --native clang -std=c++20
#include <compare>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <new>
#include <source_location>
#include <utility>

struct Trace {
  const char *Name;
  explicit Trace(const char *Name) : Name(Name) { std::printf("+%s ", Name); }
  Trace(const Trace &O) : Name(O.Name) { std::printf("=%s ", Name); }
  Trace(Trace &&O) : Name(std::exchange(O.Name, "moved")) { std::printf(">%s ", Name); }
  Trace &operator=(Trace O) { std::swap(Name, O.Name); return *this; }
  ~Trace() { std::printf("-%s ", Name); }
};
static Trace GlobalObject("global");
static thread_local int PerThread = 5;
inline int InlineVariable = std::printf("inline ");
static Trace &lazy() { static Trace T("static"); return T; }

template <typename T> concept Number = requires(T A) { A + A; A * 2; };
template <Number T> constexpr T power(T Base, unsigned N) {
  return N ? Base * power(Base, N - 1) : T(1);
}
template <typename... T> auto sum(T... V) { return (V + ... + 0); }
template <typename T, typename... R> void each(const T &F, R &&...V) { (F(std::forward<R>(V)), ...); }
template <auto V> struct Constant { static constexpr auto Value = V; };
template <int N> struct Fibonacci { static constexpr int Value = Fibonacci<N - 1>::Value + Fibonacci<N - 2>::Value; };
template <> struct Fibonacci<0> { static constexpr int Value = 0; };
template <> struct Fibonacci<1> { static constexpr int Value = 1; };
template <typename T> struct Kind { static constexpr const char *Name = "value"; };
template <typename T> struct Kind<T *> { static constexpr const char *Name = "pointer"; };
template <typename T, int N> struct Kind<T[N]> { static constexpr const char *Name = "array"; };

struct Version {
  int Major, Minor;
  auto operator<=>(const Version &) const = default;
  Version operator+(int N) const { return {Major, Minor + N}; }
  int operator[](int I) const { return I ? Minor : Major; }
  int operator()(int A, int B) const { return Major * A + Minor * B; }
  explicit operator bool() const { return Major; }
};
constexpr Version operator""_v(unsigned long long N) { return {int(N / 10), int(N % 10)}; }
enum class Level : uint8_t { Low, High = 200 };
struct Literal { char Text[6]; };
template <Literal L> constexpr int length() { int N = 0; while (L.Text[N]) ++N; return N; }
consteval int twice(int V) { return 2 * V; }
constinit int Initialized = twice(21);
constexpr auto table() {
  struct { uint32_t V[16]; } T{};
  for (uint32_t I = 0; I < 16; ++I) T.V[I] = I * I ^ 5;
  return T;
}
static constexpr auto Table = table();
union Either { int A; float B; constexpr Either(int A) : A(A) {} };
struct Aggregate { int A = 1; struct { float B, C; } D{2, 3}; int E[3]; };
int overloaded(int) { return 1; }
int overloaded(double) { return 2; }
int overloaded(const char *) { return 3; }
int overloaded(std::nullptr_t) { return 4; }
static int defaults(int A, int B = 2, int C = twice(3)) { return A * 100 + B * 10 + C; }
struct Node {
  int V; Node *Next;
  static int Count;
  Node(int V, Node *Next) : V(V), Next(Next) { ++Count; }
  ~Node() { --Count; delete Next; }
};
int Node::Count;
struct alignas(64) Line { int V[20]; };
struct Custom {
  int V = 3;
  static void *operator new(size_t Size) { std::printf("new "); return malloc(Size); }
  static void operator delete(void *P) { std::printf("delete "); free(P); }
};
static Trace make(bool First) { Trace A("A"), B("B"); if (First) return A; return B; }
__attribute__((noinline)) int apply(int (*F)(int), int V) { return F(V); }
template <typename F> __attribute__((noinline)) auto invoke(F &&Function, int V) { return Function(V); }

int main() {
  std::puts("");
  lazy(); lazy();
  { Trace T = make(true); T = Trace("C"); const Trace &R = Trace("extended"); (void)R; }
  std::puts("");
  int Captured = 10;
  auto ByValue = [Captured, N = 5](int V) mutable { return V + Captured + N++; };
  auto ByReference = [&](auto V) { Captured += V; return Captured; };
  int First = ByValue(1), Second = ByValue(1);
  std::printf("%d %d %d %d %d\n", First, Second, ByReference(2), (int)ByReference(2.5), Captured);
  std::printf("%d %d\n", apply([](int V) { return V * 7; }, 6), invoke(ByReference, 4));
  auto Recursive = [](auto Self, int N) -> int { return N < 2 ? N : Self(Self, N - 1) + Self(Self, N - 2); };
  std::printf("%d\n", Recursive(Recursive, 12));
  static_assert(power(3, 4) == 81 && length<Literal{"abc"}>() == 3);
  std::printf("%d %g %d %d\n", power(2, 10), power(1.5, 3), sum(1, 2, 3, 4), Fibonacci<20>::Value);
  each([](const auto &V) { std::printf("%s ", Kind<std::remove_reference_t<decltype(V)>>::Name); }, 1, &Captured, "x");
  std::printf("%d %u\n", Constant<5>::Value, Table.V[9]);
  Version V{1, 2}, W{1, 10};
  std::printf("%d %d %d %d %d %d\n", V < W, V == W, (V <=> W) < 0, (V + 3)[1], V(5, 6), V ? 1 : 0);
  auto [Major, Minor] = 42_v;
  auto &[A, D, E] = *new Aggregate{7, {}, {1, 2, 3}};
  std::printf("%d %d %d %g %d %d\n", Major, Minor, A, D.C, E[2], Initialized);
  std::printf("%d %d %d %d %d\n", overloaded(1), overloaded(1.f), overloaded("x"), overloaded(nullptr), defaults(1));
  std::printf("%d %d\n", (int)Level::High, Either(5).A);
  Node *List = nullptr;
  for (int I = 0; I < 10; ++I) List = new Node(I, List);
  int Sum = 0;
  for (Node *N = List; N; N = N->Next) Sum += N->V;
  std::printf("%d %d ", Sum, Node::Count);
  delete List;
  std::printf("%d\n", Node::Count);
  Line *Lines = new Line[3]{};
  std::printf("%d %d ", (int)((uintptr_t)Lines & 63), Lines[2].V[19]);
  delete[] Lines;
  Custom *C = new Custom;
  std::printf("%d ", C->V);
  delete C;
  alignas(Trace) unsigned char Storage[sizeof(Trace)];
  Trace *T = new (Storage) Trace("placed");
  T->~Trace();
  Trace *Array = new Trace[2]{Trace("one"), Trace("two")};
  delete[] Array;
  std::puts("");
  for (int I : {3, 1, 2}) Sum += I;
  if (int I = Sum; I > 5) std::printf("%d %d\n", I, ++PerThread);
  int Values[] = {5, 6, 7};
  for (int Counter = 0; int &I : Values) I += Counter++;
  std::printf("%d %s %d\n", Values[2], std::source_location::current().function_name(), InlineVariable);
  goto end;
end:
  switch (Level L = Level::Low; L) { using enum Level; case High: return 1; case Low: break; }
  std::printf("%d\n", [] { if consteval { return 1; } else { return 2; } }());
}
