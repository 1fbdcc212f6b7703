// Virtual functions, multiple and virtual inheritance, thunks, covariant
// results, pointers to members, constructors and destructors in order.
// RUN: %compare %s %t -std=c++20
#include <stdint.h>
#include <stdio.h>

static int Depth;
static void say(const char *What, int Value) {
  printf("%*s%s %d\n", Depth, "", What, Value);
}

struct Base {
  int A;
  explicit Base(int A) : A(A) { say("Base", A); }
  virtual ~Base() { say("~Base", A); }
  virtual int value() const { return A; }
  virtual Base *clone() const { return new Base(*this); }
  int plain(int B) { return A * B; }
};
struct Other {
  int64_t B;
  explicit Other(int64_t B) : B(B) { say("Other", (int)B); }
  virtual ~Other() { say("~Other", (int)B); }
  virtual int other(struct Big Argument, double D) const;
  virtual Other *self() { return this; }
};
struct Big { int V[5]; };
int Other::other(Big Argument, double D) const {
  return (int)(Argument.V[4] * D + B);
}
struct Both : Base, Other {
  float C;
  Both(int A, int64_t B) : Base(A), Other(B), C(A + B) { say("Both", (int)C); }
  ~Both() override { say("~Both", (int)C); }
  int value() const override { return Base::value() * 10; }
  int other(Big Argument, double D) const override {
    return Other::other(Argument, D) * 2 + (int)C;
  }
  Both *clone() const override { return new Both(*this); }
  Both *self() override { return this; }
};

struct Top {
  int T = 7;
  Top() { say("Top", id()); }
  virtual ~Top() { say("~Top", id()); }
  virtual int id() const { return 1; }
};
struct Left : virtual Top {
  int L = 8;
  Left() { say("Left", id()); }
  ~Left() override { say("~Left", id()); }
  int id() const override { return T + L; }
};
struct Right : virtual Top {
  double R = 9.5;
  Right() { say("Right", id()); }
  ~Right() override { say("~Right", id()); }
  virtual int right() { return (int)R + T; }
};
struct Bottom : Left, Right {
  int B = 10;
  Bottom() { say("Bottom", id()); }
  ~Bottom() override { say("~Bottom", id()); }
  int id() const override { return T * B; }
  int right() override { return Right::right() + L; }
};
struct Abstract {
  virtual int run(int) = 0;
  virtual ~Abstract() = default;
};
template <int N> struct Concrete final : Abstract {
  int run(int V) override { return V * N + Calls++; }
  int Calls = 0;
};

__attribute__((noinline)) int useBase(const Base &B) { return B.value(); }
__attribute__((noinline)) int useOther(Other *O) {
  Big Argument = {{1, 2, 3, 4, 5}};
  return O->self()->other(Argument, 1.5);
}
__attribute__((noinline)) int useTop(Top *T) { return T->id(); }
__attribute__((noinline)) int useRight(Right *R) { return R->right(); }

template <typename C> __attribute__((noinline))
int callMember(C &Object, int (C::*Function)(int), int V) {
  return (Object.*Function)(V);
}
struct Counter {
  int N = 0;
  int add(int V) { return N += V; }
  virtual int scale(int V) { return N *= V; }
  virtual ~Counter() = default;
};
struct Twice : Counter { int scale(int V) override { return N *= 2 * V; } };
struct Shifted : Top, Twice {};

int main() {
  {
    Both B(3, 4);
    ++Depth;
    say("value", useBase(B));
    say("other", useOther(&B));
    Base *Copy = B.clone();
    Copy->A = 55;
    say("copy", useBase(*Copy));
    delete Copy;
    Other *Heap = new Both(5, 6);
    say("heap", useOther(Heap));
    delete Heap;
    --Depth;
  }
  {
    Bottom B;
    say("id", useTop(&B));
    say("right", useRight(&B));
    Right R;
    say("right", useRight(&R));
    Top *T = &B;
    Left *L = &B;
    say("same", static_cast<Top *>(L) == T);
    B.Left::T = 3;
    say("shared", B.Right::T);
  }
  Concrete<3> Three;
  Concrete<-5> Minus;
  Abstract *Runners[] = {&Three, &Minus, &Three};
  int Sum = 0;
  for (int I = 0; I < 9; ++I)
    Sum += Runners[I % 3]->run(I);
  say("runners", Sum);

  int (Base::*Value)() const = &Base::value;
  int Base::*Data = &Base::A;
  Both B(1, 2);
  say("member", (B.*Value)() + B.*Data);
  int (Both::*Converted)() const = Value;
  say("converted", ((&B)->*Converted)());
  int64_t Both::*Field = &Both::B;
  B.*Field += 40;
  say("field", (int)B.B);
  int (Counter::*Functions[])(int) = {&Counter::add, &Counter::scale, nullptr};
  Shifted S;
  S.N = 1;
  for (int I = 0; Functions[I]; ++I)
    say("call", callMember<Counter>(S, Functions[I], I + 3));
  int (Shifted::*Further)(int) = static_cast<int (Shifted::*)(int)>(Functions[1]);
  say("further", (S.*Further)(2));
  say("equal", Further == static_cast<int (Shifted::*)(int)>(&Counter::scale));
  int Counter::*NoField = nullptr;
  say("null", NoField == nullptr && &Counter::N != nullptr);
}
