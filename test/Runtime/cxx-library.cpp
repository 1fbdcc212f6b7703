// The parts of the C++ library that need no operating system, on the chip
// against the host.
// RUN: %host_cxx -w -std=c++20 -O1 -ffp-contract=off %s -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

struct Shape {
  virtual ~Shape() = default;
  virtual int area() const = 0;
};

struct Square : Shape {
  int Side;
  explicit Square(int Side) : Side(Side) {}
  int area() const override { return Side * Side; }
};

struct Box : Square {
  int Height;
  Box(int Side, int Height) : Square(Side), Height(Height) {}
  int area() const override { return 2 * Square::area() + 4 * Side * Height; }
};

static int total(std::span<const int> Values) {
  int Sum = 0;
  for (int Value : Values)
    Sum += Value;
  return Sum;
}

static std::optional<int> half(int Value) {
  if (Value % 2)
    return std::nullopt;
  return Value / 2;
}

int main() {
  std::array<int, 8> Values = {5, 3, 8, 1, 9, 2, 7, 4};
  std::sort(Values.begin(), Values.end(), [](int A, int B) { return A > B; });
  for (int Value : Values)
    std::printf("%d ", Value);
  std::printf("%d %d\n", total(Values),
              *std::max_element(Values.begin(), Values.end()));
  Shape *Shapes[] = {new Square(3), new Box(2, 5)};
  for (Shape *S : Shapes) {
    std::printf("%d ", S->area());
    delete S;
  }
  std::printf("%d %d\n", half(10).value_or(-1), half(11).value_or(-1));
  std::atomic<int> Counter = 40;
  Counter += 2;
  int Expected = 42;
  bool Done = Counter.compare_exchange_strong(Expected, 7);
  std::printf("%d %d\n", Done, Counter.load());
  std::printf("%d %d %u\n", std::popcount(0xF0F0u), std::countl_zero(1u),
              std::bit_cast<std::uint32_t>(1.5f));
  volatile float F = 2.25f;
  volatile double D = 2.25;
  std::printf("%.9g %.17g %.9g %d %d\n", std::sqrt(F), std::sqrt(D),
              std::floor(F), std::isnan(F), std::abs(-3));
  auto [A, B] = std::make_tuple(1, 'b');
  std::printf("%d %c %d\n", A, B, std::numeric_limits<int>::max());
  std::printf("%d %.17g\n", std::atoi("77"), std::strtod("0.1", nullptr));
}
