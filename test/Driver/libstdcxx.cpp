// libstdc++'s headers that work without a compiled libstdc++.
//
// RUN: tpcc -std=c++20 -O1 %s -o %t.elf
// RUN: tpsim %t.elf --chip 1x1 2>/dev/null | FileCheck %s
// RUN: tpcc -std=c++20 -O0 %s -o %t.elf
// RUN: tpsim %t.elf --chip 1x1 2>/dev/null | FileCheck %s

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

static_assert(std::is_same_v<std::size_t, unsigned int>);
static_assert(std::numeric_limits<float>::is_iec559);
static_assert(std::atomic<int>::is_always_lock_free);

struct Base {
  virtual ~Base() = default;
  virtual int value() const = 0;
};
struct Seven final : Base {
  int value() const override { return 7; }
};

std::vector<int> Numbers{5, 3, 9, 1};

static int sum(std::span<const int> Values) {
  return std::accumulate(Values.begin(), Values.end(), 0);
}

int main() {
  std::ranges::sort(Numbers);
  std::array<int, 3> Three{1, 2, 3};
  std::unique_ptr<Base> Object = std::make_unique<Seven>();
  std::string Text = "numbers";
  Text += std::string_view(" from a vector");
  std::atomic<uint32_t> Counter{40};
  Counter.fetch_add(2);
  std::variant<int, float> Either = 2.5f;
  // CHECK: numbers from a vector: 1 3 5 9
  std::printf("%s: %d %d %d %d\n", Text.c_str(), Numbers[0], Numbers[1],
              Numbers[2], Numbers[3]);
  // CHECK: 6 7 42 4 2.5 3
  std::printf("%d %d %u %d %.1f %.0f\n", sum(Three), Object->value(),
              Counter.load(), std::popcount(0xF0u), std::get<float>(Either),
              std::sqrt(9.0f));
}
