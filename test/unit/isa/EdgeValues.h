//===- EdgeValues.h - Operands worth testing --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ISA_EDGEVALUES_H
#define TP_TEST_UNIT_ISA_EDGEVALUES_H

#include <cstdint>

namespace tp::test {

inline constexpr uint32_t IntegerEdges[] = {
    0,          1,          2,          3,          5,          31,
    32,         33,         0x7F,       0x80,       0xFF,       0x7FFF,
    0x8000,     0xFFFF,     0x10000,    0x12345678, 0x7FFFFFFE, 0x7FFFFFFF,
    0x80000000, 0x80000001, 0xDEADBEEF, 0xFFFF8000, 0xFFFFFFFE, 0xFFFFFFFF,
};

/// Bits of floats.
inline constexpr uint32_t FloatEdges[] = {
    0x00000000, // 0
    0x80000000, // -0
    0x00000001, // smallest subnormal
    0x80000001,
    0x007FFFFF, // largest subnormal
    0x807FFFFF,
    0x00800000, // smallest normal
    0x80800000, 0x00FFFFFF,
    0x3F800000, // 1
    0xBF800000,
    0x3F7FFFFF, // the one below 1
    0x3F800001,
    0x3F000000, // 0.5
    0xBF000000, 0x3EFFFFFF,
    0x3FC00000, // 1.5
    0xBFC00000,
    0x40200000, // 2.5
    0xC0200000,
    0x40490FDB, // pi
    0x3EAAAAAB, // 1/3
    0x4AFFFFFF, // 8388607.5
    0x4B000001,
    0x4EFFFFFF, // the one below 2^31
    0x4F000000, // 2^31
    0xCF000000, 0xCF000001,
    0x4F7FFFFF, // the one below 2^32
    0x4F800000, // 2^32
    0x5F000000,
    0x7F7FFFFF, // largest
    0xFF7FFFFF,
    0x7F800000, // infinity
    0xFF800000,
    0x7FC00000, // NaN
    0x7F800001, // signalling NaN
    0xFFC12345,
};

} // namespace tp::test

#endif // TP_TEST_UNIT_ISA_EDGEVALUES_H
