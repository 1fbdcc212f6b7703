// <random>: engines and distributions, on the chip as on the host.
// RUN: %host_cxx -w -std=c++20 -O1 -ffp-contract=off %s -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <random>
#include <vector>

template <typename Engine> static void putEngine(const char *Name) {
  Engine E;
  std::printf("%s %llu", Name, (unsigned long long)E());
  E.seed(12345);
  E.discard(10);
  std::seed_seq Seeds = {1, 2, 3};
  Engine Seeded(Seeds);
  std::printf(" %llu %llu %llu %llu\n", (unsigned long long)E(),
              (unsigned long long)Seeded(), (unsigned long long)E.min(),
              (unsigned long long)E.max());
}

template <typename Distribution>
static void putReals(const char *Name, Distribution D) {
  std::mt19937 Engine(7);
  std::printf("%s", Name);
  for (int I = 0; I != 6; ++I)
    std::printf(" %.6g", static_cast<double>(D(Engine)));
  std::printf(" in [%.6g, %.6g]\n", static_cast<double>(D.min()),
              static_cast<double>(D.max()));
}

template <typename Distribution>
static void putIntegers(const char *Name, Distribution D) {
  std::mt19937 Engine(11);
  std::printf("%s", Name);
  for (int I = 0; I != 10; ++I)
    std::printf(" %lld", static_cast<long long>(D(Engine)));
  std::printf("\n");
}

int main() {
  putEngine<std::minstd_rand0>("minstd_rand0");
  putEngine<std::minstd_rand>("minstd_rand");
  putEngine<std::mt19937>("mt19937");
  putEngine<std::mt19937_64>("mt19937_64");
  putEngine<std::ranlux24_base>("ranlux24_base");
  putEngine<std::ranlux48_base>("ranlux48_base");
  putEngine<std::ranlux24>("ranlux24");
  putEngine<std::knuth_b>("knuth_b");
  putEngine<std::independent_bits_engine<std::mt19937, 48, unsigned long long>>(
      "independent_bits");

  putReals("uniform float", std::uniform_real_distribution<float>(-1, 3));
  putReals("uniform", std::uniform_real_distribution<>(0, 10));
  putReals("normal", std::normal_distribution<>(5, 2));
  putReals("normal float", std::normal_distribution<float>(0, 1));
  putReals("lognormal", std::lognormal_distribution<>(0, 0.5));
  putReals("exponential", std::exponential_distribution<>(1.5));
  putReals("gamma", std::gamma_distribution<>(2.5, 1));
  putReals("weibull", std::weibull_distribution<>(2, 1));
  putReals("extreme_value", std::extreme_value_distribution<>(0, 1));
  putReals("chi_squared", std::chi_squared_distribution<>(3));
  putReals("cauchy", std::cauchy_distribution<>(0, 1));
  putReals("fisher_f", std::fisher_f_distribution<>(3, 4));
  putReals("student_t", std::student_t_distribution<>(5));
  const double Ends[] = {0, 1, 3}, Weights[] = {2, 1, 1};
  putReals("piecewise_constant",
           std::piecewise_constant_distribution<>(Ends, Ends + 3, Weights));
  putReals("piecewise_linear",
           std::piecewise_linear_distribution<>(Ends, Ends + 3, Weights));

  putIntegers("uniform int", std::uniform_int_distribution<>(-50, 49));
  putIntegers("uniform 64",
              std::uniform_int_distribution<long long>(0, 1'000'000'000'000));
  putIntegers("bernoulli", std::bernoulli_distribution(0.25));
  putIntegers("binomial", std::binomial_distribution<>(40, 0.4));
  putIntegers("geometric", std::geometric_distribution<>(0.3));
  putIntegers("negative_binomial",
              std::negative_binomial_distribution<>(4, 0.5));
  putIntegers("poisson", std::poisson_distribution<>(4));
  putIntegers("poisson 50", std::poisson_distribution<>(50));
  putIntegers("discrete", std::discrete_distribution<>({1, 4, 5}));

  std::vector<int> Deck(20);
  std::iota(Deck.begin(), Deck.end(), 0);
  std::mt19937 Engine(3);
  std::shuffle(Deck.begin(), Deck.end(), Engine);
  for (int Card : Deck)
    std::printf("%d ", Card);
  std::printf("%.9g\n", std::generate_canonical<double, 53>(Engine));
}
