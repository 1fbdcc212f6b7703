// <optional>, <variant>, <tuple>, <utility>, <any>, <memory>, <string>, <bit>,
// <limits>, <type_traits>, <concepts>, <compare> and <atomic> on the chip as on
// the host.
// RUN: %host_cxx -w -std=c++20 -O1 -ffp-contract=off %s -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <atomic>
#include <bit>
#include <charconv>
#include <compare>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// Counts what is made, copied, moved and destroyed.
struct Counted {
  static inline int Made = 0, Copied = 0, Moved = 0, Ended = 0;
  int Value;
  explicit Counted(int Value) : Value(Value) { ++Made; }
  Counted(const Counted &Other) : Value(Other.Value) { ++Copied; }
  Counted(Counted &&Other) noexcept : Value(std::exchange(Other.Value, -1)) {
    ++Moved;
  }
  Counted &operator=(const Counted &) = default;
  Counted &operator=(Counted &&) = default;
  ~Counted() { ++Ended; }
};

static void putCounts(const char *Name) {
  std::printf("%s: made %d copied %d moved %d ended %d\n", Name, Counted::Made,
              Counted::Copied, Counted::Moved, Counted::Ended);
}

static void testOptional() {
  std::optional<Counted> A, B(std::in_place, 5);
  A = B;
  A->Value += 2;
  std::optional<Counted> C = std::move(A);
  A.reset();
  A.emplace(9);
  std::swap(A, C);
  std::printf("%d %d %d %d\n", A->Value, B.value().Value, C->Value,
              std::optional<int>().value_or(3));
  std::optional<int> D = 4, E;
  std::printf("%d%d%d %d\n", D > E, D == 4, E == std::nullopt, *D);
}

static void testVariant() {
  using Value = std::variant<int, float, std::string, Counted>;
  std::vector<Value> Values = {1, 2.5f, "three"};
  Values.emplace_back(std::in_place_type<Counted>, 4);
  Values[1] = Values[2];
  for (const Value &V : Values)
    std::visit(
        [&](const auto &X) {
          using T = std::decay_t<decltype(X)>;
          if constexpr (std::is_same_v<T, std::string>)
            std::printf("text %s ", X.c_str());
          else if constexpr (std::is_same_v<T, Counted>)
            std::printf("counted %d ", X.Value);
          else
            std::printf("number %g ", static_cast<double>(X));
        },
        V);
  std::printf("%zu %d %d\n", Values[3].index(),
              std::holds_alternative<int>(Values[0]),
              std::get_if<float>(&Values[0]) == nullptr);
  std::variant<std::monostate, int> W;
  W = 3;
  std::printf("%d\n", std::get<1>(W));
}

static void testTuples() {
  auto T = std::make_tuple(1, 2.5f, std::string("t"), 'c');
  auto [A, B, C, D] = T;
  std::printf("%d %g %s %c %zu\n", A, double(B), C.c_str(), D,
              std::tuple_size_v<decltype(T)>);
  int X = 0;
  std::string Y;
  std::tie(X, std::ignore, Y, std::ignore) = T;
  auto Both = std::tuple_cat(T, std::pair(X, 7));
  std::printf("%d %d\n", std::get<5>(Both), T < std::tuple(1, 3.0f, "a", 'a'));
  std::printf("%d\n",
              std::apply([](auto... V) { return int(sizeof...(V)); }, Both));
  auto P = std::pair(3, 'x');
  std::printf("%d %d\n", (P <=> std::pair(3, 'y')) < 0, std::cmp_less(-1, 1u));
}

static void testMemory() {
  auto Unique = std::make_unique<Counted>(7);
  auto Taken = std::move(Unique);
  std::unique_ptr<Counted[]> None;
  auto Shared = std::make_shared<Counted>(8);
  {
    std::shared_ptr<Counted> Other = Shared;
    std::printf("%ld %d %d\n", Shared.use_count(), !Unique, Taken->Value);
  }
  std::weak_ptr<Counted> Weak = Shared;
  Shared.reset();
  std::printf("%d\n", Weak.expired());
  std::shared_ptr<int> Deleter(new int(3), [](int *P) {
    std::printf("deleted %d\n", *P);
    delete P;
  });
  std::function<int(int)> F = [N = 4](int X) { return X * N; };
  auto G = std::bind_front(F, 6);
  std::reference_wrapper<std::function<int(int)>> R = F;
  std::printf("%d %d %d\n", F(2), G(), R(5));
}

static void testStrings() {
  std::string S = "a somewhat longer string than fits inside";
  S.replace(2, 8, "very much");
  S += std::to_string(-42) + std::to_string(2.5);
  std::string_view V = S;
  std::printf("%s %zu %d %d\n", S.c_str(), V.find("string"),
              V.starts_with("a very"), int(V.substr(3, 4).compare("ery ")));
  std::printf("%d %lld %g %d\n", std::stoi("77abc"), std::stoll("-5000000000"),
              std::stod("1.25e3"), std::stoi("ff", nullptr, 16));
  char Text[40];
  auto End = std::to_chars(Text, Text + 40, 123456789, 7);
  int Back;
  std::from_chars(Text, End.ptr, Back, 7);
  std::printf("%.*s %d\n", int(End.ptr - Text), Text, Back);
}

static void testBits() {
  for (uint32_t X : {0u, 1u, 0x80u, 0xF0F00F0Fu, ~0u})
    std::printf("%d %d %d %d %d %u %u %x %x\n", std::popcount(X),
                std::countl_zero(X), std::countr_one(X), std::has_single_bit(X),
                int(std::bit_width(X)), std::bit_floor(X),
                X > 0x80000000u ? 0 : std::bit_ceil(X), std::rotl(X, 7),
                std::rotr(uint16_t(X), 3));
  std::printf("%d %llx %g\n", std::endian::native == std::endian::little,
              (unsigned long long)std::bit_cast<uint64_t>(1.5),
              double(std::bit_cast<float>(0x40490FDBu)));
}

template <typename T> static void putLimits() {
  using L = std::numeric_limits<T>;
  std::printf("%d %d %d %d %d %.17g %.17g %.17g\n", L::is_signed, L::is_integer,
              L::digits, L::digits10, L::max_digits10, double(L::min()),
              double(L::max()), double(L::lowest()));
}

template <typename T>
concept Addable = requires(T A, T B) {
  { A + B } -> std::convertible_to<T>;
};
template <std::integral T> static const char *kind(T) { return "integral"; }
template <std::floating_point T> static const char *kind(T) { return "float"; }
template <typename T>
  requires(!Addable<T>)
static const char *kind(T) {
  return "other";
}

static void testTraits() {
  putLimits<int8_t>();
  putLimits<uint16_t>();
  putLimits<int>();
  putLimits<uint64_t>();
  putLimits<float>();
  putLimits<double>();
  std::printf("%g %g %g %d\n", double(std::numeric_limits<float>::epsilon()),
              double(std::numeric_limits<float>::denorm_min()),
              std::numeric_limits<double>::infinity(),
              std::numeric_limits<float>::has_quiet_NaN);
  std::printf("%s %s %s\n", kind(3), kind(2.5f), kind(Counted(1)));
  std::printf("%d%d%d%d%d%d\n",
              std::is_trivially_copyable_v<std::pair<int, int>>,
              std::is_nothrow_move_constructible_v<Counted>,
              std::is_polymorphic_v<Counted>, std::is_aggregate_v<Counted>,
              std::is_same_v<std::common_type_t<char, float>, float>,
              std::is_invocable_v<decltype(&testBits), int>);
  struct Ordered {
    int A;
    float B;
    auto operator<=>(const Ordered &) const = default;
  };
  std::printf("%d %d\n", Ordered{1, 2} < Ordered{1, 3},
              (Ordered{1, 2} <=> Ordered{0, 9}) ==
                  std::partial_ordering::greater);
}

static void testAtomics() {
  std::atomic<int> A = 5;
  A += 3;
  int Old = A.exchange(10), Expected = 10;
  bool Done = A.compare_exchange_strong(Expected, 11);
  std::atomic<uint64_t> B = 1ull << 40;
  B.fetch_sub(1);
  B ^= 0xFF;
  std::atomic<float> C = 1.5f;
  C += 2.0f;
  std::atomic<uint8_t> D = 250;
  D += 10;
  std::atomic<uint16_t> E = 0x0FF0;
  E &= 0xFF;
  int Plain = 6;
  std::atomic_ref<int> F(Plain);
  F.fetch_or(9);
  int Array[3] = {1, 2, 3};
  std::atomic<int *> G = Array;
  ++G;
  struct Two {
    int X, Y;
  };
  std::atomic<Two> H = Two{1, 2};
  H.store({3, 4});
  std::atomic_flag Flag = ATOMIC_FLAG_INIT;
  bool Before = Flag.test_and_set();
  std::printf("%d %d %d %llx %g %d %d %d %d %d %d%d\n", Old, Done, A.load(),
              (unsigned long long)B.load(), double(C.load()), D.load(),
              E.load(), Plain, *G.load(), H.load().Y, Before, Flag.test());
}

int main() {
  testOptional();
  putCounts("optional");
  testVariant();
  putCounts("variant");
  testTuples();
  testMemory();
  putCounts("memory");
  testStrings();
  testBits();
  testTraits();
  putCounts("all");
  testAtomics();
}
