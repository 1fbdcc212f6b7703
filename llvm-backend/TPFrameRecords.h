//===- TPFrameRecords.h - Writes what functions need of the stack -*- C++ -*-=//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPFRAMERECORDS_H
#define TP_LLVM_BACKEND_TPFRAMERECORDS_H

#include "llvm/ADT/SmallVector.h"
#include <cstdint>
#include <vector>

namespace llvm {

class MachineFunction;
class MCStreamer;
class MCSymbol;

/// The records (MCTargetDesc/TPFrameRecord.h) of a unit's functions.
class TPFrameRecords {
public:
  /// Notes the finished function \p MF, whose code is at \p Function.
  void add(const MachineFunction &MF, const MCSymbol *Function);
  /// Writes all records into their section and forgets them.
  void emit(MCStreamer &Streamer);

private:
  struct Record {
    const MCSymbol *Function;
    uint32_t FrameBytes;
    uint32_t OwnType;
    uint32_t RegisterCallCount;
    SmallVector<uint32_t, 2> CalleeTypes;
  };
  std::vector<Record> Records;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPFRAMERECORDS_H
