//===- EngineSnapshot.cpp - An engine's state in little memory ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/EngineSnapshot.h"
#include "simulator/core/BufferArchive.h"

#include "llvm/Support/Compression.h"
#include "llvm/Support/Error.h"

#include <cassert>

using namespace llvm;

namespace tp {

EngineSnapshot::EngineSnapshot(Engine &Machine, bool IsPacked) {
  SavingArchive A;
  Machine.serialize(A);
  if (!IsPacked || !compression::zstd::isAvailable()) {
    State = A.collected();
    return;
  }
  SmallVector<uint8_t> Packed;
  compression::zstd::compress(A.collected(), Packed,
                              compression::zstd::BestSpeedCompression);
  UnpackedBytes = A.collected().size();
  State.assign(Packed.begin(), Packed.end());
}

void EngineSnapshot::restore(Engine &Machine) const {
  if (UnpackedBytes == 0) {
    RestoringArchive A(State);
    Machine.serialize(A);
    assert(A.isComplete() && "a snapshot of another engine");
    return;
  }
  std::vector<uint8_t> Unpacked(UnpackedBytes);
  size_t Bytes = UnpackedBytes;
  cantFail(compression::zstd::decompress(State, Unpacked.data(), Bytes));
  RestoringArchive A(Unpacked);
  Machine.serialize(A);
  assert(A.isComplete() && "a snapshot of another engine");
}

} // namespace tp
