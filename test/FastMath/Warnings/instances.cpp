// Dependent code, its instances, lambdas and coroutines: once for each place.

// RUN: tpcc -std=c++20 -ffast-math -fsyntax-only -Xclang -verify %s
// RUN: clang++ -std=c++20 -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -ffast-math -fsyntax-only -Xclang -verify %s

#include <coroutine>
#include <limits>

extern int Counts[9];

template <class Number> struct Box {
  Number Low = std::numeric_limits<Number>::infinity(); // expected-warning {{infinity}} expected-note {{'-fno-finite-math-only'}}
  bool isEmpty() const { return Low != Low; } // expected-warning {{test for NaN}}
  static void count(Number X, Number W) {
    ++Counts[int(X / W)]; // expected-warning {{an index}} expected-note {{this division}} expected-note {{used as}}
  }
};
Box<float> Floats;
Box<double> Doubles;
Box<int> Integers;
void useBoxes() {
  Box<float>::count(1, 2);
  Box<int>::count(1, 2);
  Floats.isEmpty();
  Integers.isEmpty();
}
template <class Number> bool never(Number X) {
  ++Counts[int(X / X)];
  return X != X;
}

auto Generic = [](auto X, auto W) {
  ++Counts[int(X / W)]; // expected-warning {{an index}} expected-note {{this division}} expected-note {{used as}}
  return X != X; // expected-warning {{test for NaN}}
};
bool useGeneric() { return Generic(1.0f, 2.0f) || Generic(1, 2) || Generic(1.0, 2.0); }

auto Global = [](float X, float W) {
  ++Counts[int(X / W)]; // expected-warning {{an index}} expected-note {{this division}} expected-note {{used as}}
};

template <auto Value> constexpr auto Constant = Value;
template <class... Numbers> bool anyNaN(Numbers... All) {
  return (... || (All != All)); // expected-warning {{test for NaN}}
}
bool useFold() { return anyNaN(1.0f, 2.0, 3); }

template <class T>
concept Ordered = requires(T A, T B) { A != A; };
template <Ordered T> T same(T A) { return A; }
float useConcept() { return same(1.0f) + Constant<3>; }

struct Task {
  struct promise_type {
    Task get_return_object() { return {}; }
    std::suspend_never initial_suspend() { return {}; }
    std::suspend_never final_suspend() noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() {}
    std::suspend_always yield_value(int) { return {}; }
  };
};
Task coroutine(float X, float W) {
  int Bin = int(X / W); // expected-warning {{an index}} expected-note {{this division}}
  co_await std::suspend_always();
  co_yield Counts[Bin]; // expected-note {{used as}}
  if (X != X) // expected-warning {{test for NaN}}
    co_return;
}

#define IS_NAN(X) ((X) != (X))
bool macro(float X) { return IS_NAN(X); } // expected-warning {{test for NaN}}

// Recursive functions end.
int loop(float X, float W, int Depth) {
  if (Depth == 0)
    return X / W; // expected-warning {{an index}} expected-note {{this division}}
  return loop(X, W, Depth - 1);
}
void useLoop() { Counts[loop(1, 2, 3)] = 0; } // expected-note {{used as}}
