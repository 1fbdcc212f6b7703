//===- EngineSnapshot.cpp - A machine's state in little memory ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/EngineSnapshot.h"

#include "llvm/Support/Compression.h"
#include "llvm/Support/Error.h"

using namespace llvm;

namespace tp {

void EngineSnapshot::keep(const std::vector<uint8_t> &Collected,
                          bool IsPacked) {
  if (!IsPacked || !compression::zstd::isAvailable()) {
    State = Collected;
    return;
  }
  SmallVector<uint8_t> Packed;
  compression::zstd::compress(Collected, Packed,
                              compression::zstd::BestSpeedCompression);
  UnpackedBytes = Collected.size();
  State.assign(Packed.begin(), Packed.end());
}

std::vector<uint8_t> EngineSnapshot::unpacked() const {
  std::vector<uint8_t> Result(UnpackedBytes);
  size_t Bytes = UnpackedBytes;
  if (Bytes != 0)
    cantFail(compression::zstd::decompress(State, Result.data(), Bytes));
  return Result;
}

} // namespace tp
