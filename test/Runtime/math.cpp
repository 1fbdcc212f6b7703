// tp/math.h computes the same bits on the chip as on the host.
// RUN: %host_cxx -std=c++20 -O2 -ffp-contract=off \
// RUN:   -I %source_dir -I %source_dir/runtime/include %s \
// RUN:   %source_dir/runtime/lib/math/Exponential.cpp \
// RUN:   %source_dir/runtime/lib/math/InverseTrigonometric.cpp \
// RUN:   %source_dir/runtime/lib/math/Rounding.cpp \
// RUN:   %source_dir/runtime/lib/math/Trigonometric.cpp \
// RUN:   %source_dir/runtime/host/Math.cpp -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <stdint.h>
#include <stdio.h>
#include <tp/math.h>

static unsigned bits(float X) {
  return X != X ? 0x7FC00000u : __builtin_bit_cast(uint32_t, X);
}

int main() {
  using Function = float (*)(float);
  const Function Functions[] = {tp::sin,
                                tp::cos,
                                tp::tan,
                                tp::asin,
                                tp::acos,
                                tp::atan,
                                tp::exp,
                                tp::exp2,
                                tp::log,
                                tp::log2,
                                tp::log10,
                                tp::floor,
                                tp::ceil,
                                tp::trunc,
                                tp::round,
                                tp::rint,
                                [](float X) { return tp::sqrt(X); },
                                [](float X) { return tp::rsqrt(X); },
                                [](float X) { return tp::rcp(X); },
                                [](float X) { return tp::fastSin(X); },
                                [](float X) { return tp::fastCos(X); }};
  const uint32_t Edges[] = {0x00000000, 0x00000001, 0x007FFFFF, 0x00800000,
                            0x3F000000, 0x3F7FFFFF, 0x3F800000, 0x3F800001,
                            0x4B000000, 0x4F000000, 0x7F7FFFFF, 0x7F800000,
                            0x7FC00000};
  uint32_t Inputs[200];
  int Count = 0;
  for (uint32_t Edge : Edges) {
    Inputs[Count++] = Edge;
    Inputs[Count++] = Edge | 0x80000000u;
  }
  uint32_t State = 12345;
  while (Count != 200) {
    State = State * 1664525u + 1013904223u;
    // Every second one has an exponent near that of 1.
    Inputs[Count] = Count & 1 ? (State & 0x87FFFFFFu) | 0x3C000000u : State;
    ++Count;
  }
  for (uint32_t Input : Inputs) {
    float X = __builtin_bit_cast(float, Input);
    printf("%08x:", bits(X));
    for (Function F : Functions)
      printf(" %08x", bits(F(X)));
    for (int I = 0; I < 200; I += 13) {
      float Y = __builtin_bit_cast(float, Inputs[I]);
      printf(" %08x %08x %08x %08x %08x", bits(tp::pow(X, Y)),
             bits(tp::atan2(X, Y)), bits(tp::fmod(X, Y)), bits(tp::fmin(X, Y)),
             bits(tp::fmax(X, Y)));
    }
    printf(" %08x\n", bits(tp::ldexp(X, static_cast<int>(Input % 300) - 150)));
  }
}
