//===- TPFrameRecord.h - What a function needs of the stack -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The compiler leaves a record of each function in its object, from which the
// linker bounds the stack. Assembly may do the same (docs/tpcc.md). A record is
// a sequence of words: the members below in their order, then CalleeTypeCount
// of the types of the functions that are called through registers.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPFRAMERECORD_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPFRAMERECORD_H

#include <cstdint>

namespace llvm {
namespace TPFrameRecord {

/// The section of an object that holds the records; not part of a program.
inline constexpr const char SectionName[] = ".tp.frames";

enum Word : uint32_t {
  /// The function's address, by a relocation.
  Function,
  /// The most bytes that it takes from the stack itself, or DynamicSize.
  FrameBytes,
  /// A type as below.
  OwnType,
  /// Number of its instructions that call through a register.
  RegisterCallCount,
  CalleeTypeCount,
  HeaderWords,
};

/// FrameBytes of a function that takes what it computes at run time.
inline constexpr uint32_t DynamicSize = 0xFFFFFFFF;

/// A type is an even number that functions of the same parameters and results
/// share, or this for any.
inline constexpr uint32_t AnyType = 0;

/// Set in a callee's type if the caller has given back its frame before it
/// jumps.
inline constexpr uint32_t TailCallFlag = 1;

} // namespace TPFrameRecord
} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPFRAMERECORD_H
