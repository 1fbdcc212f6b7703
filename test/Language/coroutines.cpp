// Coroutines: generators, tasks with symmetric transfer, awaitables with state,
// destruction while suspended, own allocation.
// RUN: %compare %s %t -std=c++20
#include <coroutine>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>

static int Alive, Allocated;
struct Noisy {
  int V;
  explicit Noisy(int V) : V(V) { ++Alive; }
  Noisy(const Noisy &O) : V(O.V) { ++Alive; }
  ~Noisy() { --Alive; }
};

template <typename T> struct Generator {
  struct promise_type {
    T Value;
    Generator get_return_object() {
      return Generator{std::coroutine_handle<promise_type>::from_promise(*this)};
    }
    std::suspend_always initial_suspend() { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_always yield_value(T V) { Value = V; return {}; }
    void return_void() {}
    void unhandled_exception() { abort(); }
    void *operator new(size_t Size) { ++Allocated; return malloc(Size); }
    void operator delete(void *P) { --Allocated; free(P); }
  };
  std::coroutine_handle<promise_type> Handle;
  explicit Generator(std::coroutine_handle<promise_type> H) : Handle(H) {}
  Generator(Generator &&O) : Handle(std::exchange(O.Handle, {})) {}
  ~Generator() { if (Handle) Handle.destroy(); }
  bool next() { Handle.resume(); return !Handle.done(); }
  T value() { return Handle.promise().Value; }
};

Generator<int64_t> fibonacci(int Count) {
  int64_t A = 0, B = 1;
  Noisy N(Count);
  while (Count--) {
    co_yield A;
    A = std::exchange(B, A + B);
  }
}
struct Vector { float X, Y, Z; int Tag[6]; };
Generator<Vector> spiral(Vector V, double Angle, Noisy N) {
  for (int I = 0;; ++I) {
    alignas(16) volatile float Aligned[4] = {V.X, V.Y, V.Z, (float)Angle};
    co_yield V;
    V.X = Aligned[1] + N.V;
    V.Y = -Aligned[0] * Aligned[3];
    V.Tag[I % 6] += I;
  }
}
Generator<int> tree(int Low, int High) {
  if (Low > High)
    co_return;
  int Middle = (Low + High) / 2;
  for (auto G = tree(Low, Middle - 1); G.next();)
    co_yield G.value();
  co_yield Middle;
  for (auto G = tree(Middle + 1, High); G.next();)
    co_yield G.value();
}

template <typename T> struct Task {
  struct promise_type {
    T Result;
    std::coroutine_handle<> Continuation = std::noop_coroutine();
    Task get_return_object() {
      return {std::coroutine_handle<promise_type>::from_promise(*this)};
    }
    std::suspend_always initial_suspend() { return {}; }
    struct Final {
      bool await_ready() noexcept { return false; }
      std::coroutine_handle<>
      await_suspend(std::coroutine_handle<promise_type> H) noexcept {
        return H.promise().Continuation;
      }
      void await_resume() noexcept {}
    };
    Final final_suspend() noexcept { return {}; }
    void return_value(T V) { Result = V; }
    void unhandled_exception() { abort(); }
  };
  std::coroutine_handle<promise_type> Handle;
  bool await_ready() { return false; }
  std::coroutine_handle<> await_suspend(std::coroutine_handle<> Continuation) {
    Handle.promise().Continuation = Continuation;
    return Handle;
  }
  T await_resume() {
    T Result = Handle.promise().Result;
    Handle.destroy();
    return Result;
  }
};
static std::coroutine_handle<> Waiting[8];
static int NumWaiting;
struct Event {
  int V;
  bool await_ready() const { return V % 3 == 0; }
  void await_suspend(std::coroutine_handle<> H) { Waiting[NumWaiting++] = H; }
  int await_resume() const { return V * 2; }
};
Task<int> leaf(int V) { co_return co_await Event{V} + 1; }
Task<double> deep(int V) {
  if (V == 0)
    co_return 0.5;
  double Below = co_await deep(V - 1);
  co_return Below * 2 + co_await leaf(V);
}
struct Detached {
  struct promise_type {
    Detached get_return_object() { return {}; }
    std::suspend_never initial_suspend() { return {}; }
    std::suspend_never final_suspend() noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() { abort(); }
  };
};
Detached start(int V, double *Result) {
  Noisy N(V);
  *Result = co_await deep(V);
  *Result += N.V;
}

int main() {
  int64_t Sum = 0;
  for (auto G = fibonacci(60); G.next();)
    Sum += G.value();
  printf("%lld\n", (long long)Sum);
  {
    auto G = spiral({1, 2, 3, {}}, 0.25, Noisy(3));
    for (int I = 0; I < 10; ++I)
      G.next();
    Vector V = G.value();
    printf("%g %g %g %d %d\n", V.X, V.Y, V.Z, V.Tag[2], Alive);
  }
  int Count = 0, Last = -1;
  for (auto G = tree(1, 100); G.next(); ++Count) {
    if (G.value() <= Last)
      puts("order");
    Last = G.value();
  }
  printf("%d %d, alive %d, allocated %d\n", Count, Last, Alive, Allocated);
  double Results[2] = {};
  start(7, &Results[0]);
  start(3, &Results[1]);
  while (NumWaiting)
    Waiting[--NumWaiting].resume();
  printf("%g %g, alive %d\n", Results[0], Results[1], Alive);
  auto Lambda = [](int N) -> Generator<int> {
    for (int I = 0; I < N; ++I)
      co_yield I * I;
  };
  for (auto G = Lambda(5); G.next();)
    printf("%d ", G.value());
  printf("\nallocated %d\n", Allocated);
}
