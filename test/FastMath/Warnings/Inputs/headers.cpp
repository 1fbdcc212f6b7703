// Headers with much floating point, and instances of their templates.
#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

// What the TP has no library for.
#ifndef __tp__
#include <charconv>
#include <complex>
#include <random>

float hostHeaders() {
  std::mt19937 Generator;
  std::normal_distribution<float> Normal;
  std::uniform_real_distribution<float> Uniform;
  std::complex<float> Complex(1, 2);
  Complex = std::sqrt(Complex * Complex / Complex);
  return Normal(Generator) + Uniform(Generator) + std::abs(Complex);
}
#endif

float headers(std::vector<float> &Values) {
  std::sort(Values.begin(), Values.end());
  std::set<float> Set(Values.begin(), Values.end());
  std::map<float, int> Map{{1.0f, 2}};
  std::unordered_map<float, int> Hashed{{1.0f, 2}};
  return std::sqrt(Values[0]) + std::fmod(Values[1], 2.0f) +
         std::accumulate(Values.begin(), Values.end(), 0.0f) +
         Map[1.0f] + Hashed[1.0f] + *Set.begin();
}
