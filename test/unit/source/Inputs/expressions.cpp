// Values of each kind of type, for the debugger's expressions. The tests stop
// at the call of stop().
#include <array>
#include <span>
#include <string_view>

extern "C" __attribute__((noinline)) void stop() {
  asm volatile("" ::: "memory");
}

enum Color { Red, Green = 5, Blue };
enum class Mode : unsigned char { Off, On = 200 };
enum Flags { Readable = 1, Writable = 2, Runnable = 4 };

namespace scene {

struct Vector {
  float X, Y, Z;
};

namespace {
int Hidden = 77;
}

struct Counter {
  static int Instances;
  static constexpr int Limit = 12;
};
int Counter::Instances = 3;

template <class T, int N> struct Box {
  T Items[N];
  int Used;
};

struct Shape {
  virtual ~Shape() = default;
  int Id = 41;
};

struct Sphere : Shape, Counter {
  Vector Center = {1.5f, -2.0f, 0.25f};
  float Radius = 3;
  unsigned Visible : 1 = 1;
  int Level : 5 = -7;
  unsigned Wide : 20 = 654321;
  union {
    int AsInteger;
    float AsFloat;
  };
  Mode State = Mode::On;
  const char *Name = "ball";
  Sphere *Next = nullptr;

  __attribute__((noinline)) int area(int Scale) {
    int Local = Scale * Id;
    stop();
    return Local + int(Radius);
  }
};

int twice(int Value);
__attribute__((noinline)) int twice(int Value) { return Value * 2; }
float twice(float Value);
__attribute__((noinline)) float twice(float Value) { return Value * 2; }

} // namespace scene

thread_local int PerThread = 9;
int Matrix[3][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}};
char Text[16] = "tabs\tand \"q\"";
unsigned char Raw[4] = {1, 2, 255, 0};
const char *const Words[] = {"one", "two", nullptr};
int Zeros[40];
int (*Operation)(int) = scene::twice;
std::array<int, 4> Four = {10, 20, 30, 40};
std::string_view View = std::string_view(Text, 4);
double Precise = 0.1;
float Single = 0.1f;
long long Long = -5000000000ll;
unsigned long long Huge = 18446744073709551615ull;
int Global = 100;
int Unused = 5;
Flags Access = Flags(Readable | Runnable);
scene::Box<int, 3> Boxed = {{7, 8, 9}, 2};
scene::Sphere Ball;

namespace other {
int Global = 200;
struct Vector {
  int Other;
};
} // namespace other

namespace hidden {
struct Node {
  int Key = 3;
  long long Value = 4;
};
struct Pair {
  char Letters[2];
};
} // namespace hidden
namespace decoy {
struct Outer {
  using Node = short;
  using Pair = double;
};
} // namespace decoy
using hidden::Node;
namespace user {
using namespace hidden;
Pair Both = {{'a', 'b'}};
decoy::Outer::Node Small = 5;
decoy::Outer::Pair Number = 5;
__attribute__((noinline)) int inside(Node *Root) {
  stop();
  return Root->Key + Both.Letters[0] + Small + int(Number);
}
} // namespace user

struct Function {
  int Base;
  __attribute__((noinline)) int operator()(int A) const { return A + Base; }
  __attribute__((noinline)) int operator()(float A) const {
    return int(A) - Base;
  }
  __attribute__((noinline)) bool operator<(const Function &Other) const {
    return Base < Other.Base;
  }
  __attribute__((noinline)) int operator>>(int By) const { return Base >> By; }
  __attribute__((noinline)) const Function *operator->() const { return this; }
  __attribute__((noinline)) explicit operator bool() const { return Base; }
};
template <Color C> __attribute__((noinline)) int painted(int A) {
  return A + C;
}

struct Mixed {
  char Letter;
  short Small;
  bool Yes;
};

__attribute__((noinline)) int expressions(int A, unsigned B, float F,
                                          scene::Sphere &Ref, int *Pointer,
                                          Mixed M) {
  int X = A + 1;
  short Small = -3;
  unsigned char Byte = 250;
  char Letter = 'q';
  bool Yes = true;
  Color Paint = Green;
  Color Odd = Color(9);
  Mode State = Mode::On;
  int List[5] = {1, 2, 3, 4, 5};
  scene::Vector Position = {1, 2, 3};
  scene::Vector *Where = &Position;
  void *Raw = &X;
  std::span<int> Span(List, 3);
  {
    int X = 1000;
    Pointer[0] += X;
  }
  int &Alias = X;
  stop();
  return X + Small + Byte + Letter + Yes + Paint + int(State) + List[A & 1] +
         int(Where->X) + Alias + int(F) + int(B) + Ref.Id + (Raw != nullptr) +
         M.Small + Span[0] + Odd;
}

int main() {
  Ball.AsInteger = 0x40490fdb;
  Ball.Next = &Ball;
  int Numbers[2] = {7, 8};
  Mixed M = {'m', -9, true};
  int Sum = expressions(5, 4000000000u, 2.5f, Ball, Numbers, M);
  Sum += Ball.area(2) + PerThread + scene::Hidden + other::Global + Zeros[3] +
         Matrix[1][2] + Operation(3) + int(scene::twice(1.5f)) + Four[1] +
         int(View.size()) + int(Precise + Single) + int(Long) + int(Huge) +
         int(Access) + Boxed.Used + (Words[0] != nullptr) + Raw[1] +
         scene::Counter::Instances + other::Vector{3}.Other + Global;
  Node Root;
  Function Object = {3};
  Sum += Object(1) + Object(2.0f) + (Object < Object) + (Object >> 1) +
         Object->Base + bool(Object) + painted<Green>(Sum);
  Sum += user::inside(&Root);
  return Sum == 0;
}
