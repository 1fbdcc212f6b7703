// Classes with several and virtual bases, lambdas, templates and objects of
// variable size, for the debugger's expressions. The tests stop at the call of
// stop().

extern "C" __attribute__((noinline)) void stop() {
  asm volatile("" ::: "memory");
}

struct Left {
  int InLeft = 1;
};
struct Right {
  int InRight = 2;
};
struct Both : Left, Right {
  int Own = 3;
};

struct Shared {
  virtual ~Shared() = default;
  int Common = 40;
};
struct First : virtual Shared {
  int InFirst = 41;
};
struct Second : virtual Shared {
  int InSecond = 42;
};
struct Joined : First, Second {
  int InJoined = 43;
};

struct Fields {
  unsigned long long Narrow : 20 = 5;
  long long Wide : 40 = -5;
};

template <int N, class T> struct Table {
  T Items[N] = {};
  template <int Step> __attribute__((noinline)) T sum() {
    T Result = N;
    for (int I = 0; I < N; I += Step)
      Result += Items[I];
    stop();
    return Result;
  }
};

struct Holder {
  int Held = 60;
  __attribute__((noinline)) int run(int Given) {
    int Outer = 61;
    auto Body = [this, Outer, &Given](int Inner) __attribute__((noinline)) {
      stop();
      return Held + Outer + Given + Inner;
    };
    return Body(62);
  }
};

int twice(int Value) { return 2 * Value; }
_Float16 Half = 1.5f16;
__bf16 Brain = (__bf16)-2.5f;
_Complex float Complex = {1.5f, -2};
unsigned __int128 Huge = (unsigned __int128)1 << 100;
char Bytes[3] = {'a', 'b', 'c'};
namespace {
__attribute__((noinline)) int unnamed(int Value) { return Value + 1; }
} // namespace

__attribute__((noinline)) int classes(Both *B, Joined *J, int Rows) {
  Right *R = B;
  Right &Reference = *B;
  Shared *S = J;
  Joined Copy;
  Fields Bits;
  int (*Function)(int) = twice;
  int Grid[Rows][Rows + 1];
  for (int I = 0; I < Rows; ++I)
    for (int K = 0; K <= Rows; ++K)
      Grid[I][K] = 10 * I + K;
  int List[4] = {7, 8, 9, 10};
  int X = 0;
  stop();
  return R->InRight + Reference.InRight + S->Common + Copy.Common +
         int(Bits.Narrow) + Function(Grid[1][2]) + List[X & 3];
}

int main() {
  Both B;
  Joined J;
  Table<3, int> T;
  Holder H;
  int Sum = classes(&B, &J, 2) + T.sum<2>() + H.run(63) + unnamed(1) +
            int(Half) + int(Brain) + int(Huge) + Bytes[0] +
            int(__real__ Complex);
  return Sum == 0;
}
