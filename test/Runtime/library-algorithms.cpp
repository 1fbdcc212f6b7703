// <algorithm>, <numeric>, <array>, <span>, <functional>, <iterator> and
// <ranges> on the chip as on the host.
// RUN: %host_cxx -w -std=c++20 -O1 -ffp-contract=off %s -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -w -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -w -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iterator>
#include <numeric>
#include <ranges>
#include <span>
#include <string>
#include <vector>

static uint32_t State = 1;

static int next(uint32_t Bound) {
  State = State * 1664525u + 1013904223u;
  return static_cast<int>((State >> 8) % Bound);
}

template <typename Range> static void put(const char *Name, const Range &R) {
  std::printf("%s:", Name);
  for (auto Value : R)
    std::printf(" %d", static_cast<int>(Value));
  std::printf("\n");
}

struct Item {
  int Key;
  int Number;
  bool operator==(const Item &) const = default;
};

static void testSorting() {
  std::array<int, 40> A;
  std::generate(A.begin(), A.end(), [] { return next(100); });
  auto B = A;
  std::sort(B.begin(), B.end());
  put("sort", B);
  auto C = A;
  std::partial_sort(C.begin(), C.begin() + 7, C.end(), std::greater<>());
  put("partial_sort", std::span(C).first(7));
  std::nth_element(C.begin(), C.begin() + 20, C.end());
  std::printf("nth_element: %d %d\n", C[20], C[20] == B[20]);
  std::vector<Item> Items;
  for (int I = 0; I != 30; ++I)
    Items.push_back({next(5), I});
  std::stable_sort(Items.begin(), Items.end(),
                   [](Item A, Item B) { return A.Key < B.Key; });
  for (Item I : Items)
    std::printf("%d.%d ", I.Key, I.Number);
  auto [Low, High] = std::equal_range(B.begin(), B.end(), B[10]);
  std::printf("\nequal_range: %d %d, %d %d\n", int(Low - B.begin()),
              int(High - B.begin()), std::binary_search(B.begin(), B.end(), 50),
              int(std::lower_bound(B.begin(), B.end(), 60) - B.begin()));
  std::vector<int> Heap(A.begin(), A.begin() + 12);
  std::make_heap(Heap.begin(), Heap.end());
  Heap.push_back(200);
  std::push_heap(Heap.begin(), Heap.end());
  std::pop_heap(Heap.begin(), Heap.end());
  std::printf("heap: %d %d\n", Heap.back(),
              std::is_heap(Heap.begin(), Heap.end() - 1));
  Heap.pop_back();
  std::sort_heap(Heap.begin(), Heap.end());
  put("sort_heap", Heap);
  std::sort(A.begin(), A.begin() + 20);
  std::sort(A.begin() + 20, A.end());
  std::inplace_merge(A.begin(), A.begin() + 20, A.end());
  std::printf("sorted until %d\n",
              int(std::is_sorted_until(A.begin(), A.end()) - A.begin()));
}

static void testSequences() {
  std::vector<int> V = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5};
  std::printf("find: %d %d %d %d\n",
              int(std::find(V.begin(), V.end(), 9) - V.begin()),
              int(std::adjacent_find(V.begin(), V.end()) - V.begin()),
              int(std::count(V.begin(), V.end(), 5)),
              std::any_of(V.begin(), V.end(), [](int X) { return X > 8; }));
  const int Part[] = {2, 6};
  std::printf(
      "search: %d %d\n",
      int(std::search(V.begin(), V.end(), Part, Part + 2) - V.begin()),
      int(std::mismatch(V.begin(), V.end(), V.rbegin()).first - V.begin()));
  auto W = V;
  W.erase(std::remove(W.begin(), W.end(), 5), W.end());
  put("remove", W);
  std::replace_if(W.begin(), W.end(), [](int X) { return X < 3; }, 0);
  put("replace_if", W);
  std::rotate(W.begin(), W.begin() + 3, W.end());
  put("rotate", W);
  std::reverse(W.begin(), W.end());
  W.erase(std::unique(W.begin(), W.end()), W.end());
  put("unique", W);
  auto Middle = std::stable_partition(V.begin(), V.end(),
                                      [](int X) { return X % 2 == 0; });
  std::printf("partition %d\n", int(Middle - V.begin()));
  put("partitioned", V);
  std::vector<int> Doubled;
  std::transform(V.begin(), V.end(), std::back_inserter(Doubled),
                 std::bind(std::multiplies<>(), std::placeholders::_1, 2));
  put("transform", Doubled);
  std::array<int, 4> Permutation = {1, 2, 3, 4};
  int Count = 0;
  do
    ++Count;
  while (std::next_permutation(Permutation.begin(), Permutation.end()));
  std::printf("permutations %d\n", Count);
  std::vector<int> X = {1, 2, 3, 5, 8}, Y = {2, 3, 4, 8, 9}, Z;
  std::set_union(X.begin(), X.end(), Y.begin(), Y.end(), std::back_inserter(Z));
  put("union", Z);
  Z.clear();
  std::set_symmetric_difference(X.begin(), X.end(), Y.begin(), Y.end(),
                                std::back_inserter(Z));
  put("difference", Z);
  auto [Min, Max] = std::minmax_element(V.begin(), V.end());
  std::printf("minmax %d %d clamp %d\n", *Min, *Max, std::clamp(12, 0, 10));
  std::printf("compare %d\n", std::lexicographical_compare(X.begin(), X.end(),
                                                           Y.begin(), Y.end()));
}

static void testNumeric() {
  std::vector<int> V(10);
  std::iota(V.begin(), V.end(), 1);
  std::vector<int> Sums(10), Differences(10);
  std::partial_sum(V.begin(), V.end(), Sums.begin());
  std::adjacent_difference(Sums.begin(), Sums.end(), Differences.begin());
  put("partial_sum", Sums);
  put("adjacent_difference", Differences);
  std::exclusive_scan(V.begin(), V.end(), Sums.begin(), 100);
  put("exclusive_scan", Sums);
  std::printf("%d %d %d %d %d %d %d\n", std::accumulate(V.begin(), V.end(), 0),
              std::inner_product(V.begin(), V.end(), Sums.begin(), 5),
              std::reduce(V.begin(), V.end(), 1, std::multiplies<>()),
              std::transform_reduce(V.begin(), V.end(), 0, std::plus<>(),
                                    [](int X) { return X * X; }),
              std::gcd(84, 36), std::lcm(21, 6), std::midpoint(3, 10));
  float Floats[] = {0.1f, 0.2f, 0.3f, 1e8f, -1e8f};
  std::printf("%.9g\n", double(std::accumulate(std::begin(Floats),
                                               std::end(Floats), 0.0f)));
}

static void testRanges() {
  std::vector<int> V = {5, 3, 8, 1, 9, 2};
  std::ranges::sort(V, std::ranges::greater());
  put("ranges::sort", V);
  auto Even = V | std::views::filter([](int X) { return X % 2 == 0; }) |
              std::views::transform([](int X) { return X * X; });
  for (int X : Even)
    std::printf("%d ", X);
  for (int X : std::views::iota(1, 20) | std::views::drop(3) |
                   std::views::take(4) | std::views::reverse)
    std::printf("%d ", X);
  std::span<int> Whole(V);
  std::printf("| %zu %d %d\n", Whole.subspan(2, 3).size(), Whole.back(),
              *std::ranges::max_element(Whole.last(3)));
  std::string Text = "ranges";
  std::ranges::reverse(Text);
  std::printf("%s %d\n", Text.c_str(),
              int(std::ranges::distance(Text | std::views::take(4))));
}

int main() {
  testSorting();
  testSequences();
  testNumeric();
  testRanges();
}
