//===- CheckFailure.h - A failed floating-point check -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What checked code passes on when a check fails, and how it reads. Checked
// code for the TP ends in `break <code>` with the values' low words in r4, r5
// and r6 and their high words in r7, r8 and r9; on the host it calls
// __tp_fp_check_failed (runtime/host/FloatCheck.cpp). Needs nothing of LLVM:
// the simulator and the host runtime read it too.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKFAILURE_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKFAILURE_H

#include <array>
#include <cstdint>
#include <string>

namespace tp {

/// Why a check failed; see CheckFailures.def.
enum class CheckKind : uint8_t {
#define CHECK_KIND(Name) Name,
#include "llvm-backend/FloatingPoint/Check/CheckFailures.def"
};

/// The type of the values.
enum class CheckType : uint8_t {
#define CHECK_TYPE(Name, Bits) Name,
#include "llvm-backend/FloatingPoint/Check/CheckFailures.def"
};

/// What was done with the values.
enum class CheckOperation : uint16_t {
#define CHECK_OPERATION(Name, Text) Name,
#include "llvm-backend/FloatingPoint/Check/CheckFailures.def"
};

/// What a check that fails says of itself, apart from the values.
struct CheckFailure {
  CheckKind Kind = CheckKind::Conversion;
  CheckType Type = CheckType::Float;
  CheckOperation Operation = CheckOperation::ToInt32;

  /// Codes of `break` from here to 0xFFFF are failed checks.
  static constexpr uint32_t FirstCode = 0xC000;

  /// All of it as one number from FirstCode on.
  constexpr uint32_t code() const {
    return FirstCode | uint32_t(Kind) << 12 | uint32_t(Type) << 10 |
           uint32_t(Operation);
  }

  /// Whether \p Code is that of a failed check.
  static bool isCode(uint32_t Code);
  /// What \p Code, for which isCode() holds, stands for.
  static CheckFailure fromCode(uint32_t Code);

  /// What happened, in words: "NaN converted to an integer: nan (0x7fc00000)
  /// to int32_t". \p Values are the bits of the result, as far as there is one,
  /// and of the operands that the operation has.
  std::string describe(const std::array<uint64_t, 3> &Values) const;
};

/// A floating-point number in decimal, the fewest digits that identify it, and
/// its bits: "0.1 (0x3dcccccd)".
std::string describeFloat(uint64_t Bits, CheckType Type);

} // namespace tp

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_CHECK_CHECKFAILURE_H
