//===- SpecialRegisters.h - What a thread is told of itself -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_SPECIALREGISTERS_H
#define TP_SIMULATOR_CORE_SPECIALREGISTERS_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/isa/Instructions.h"

#include <cstdint>

namespace tp {

/// The value of \p Register in thread \p Thread of \p Chip. \p Cycles and
/// \p Instructions give the thread's 64-bit counters.
template <class CycleFunction, class InstructionsFunction>
uint32_t readSpecial(SpecialRegister Register, const ChipConfig &Chip,
                     uint32_t Thread, CycleFunction Cycles,
                     InstructionsFunction Instructions) {
  switch (Register) {
  case SpecialRegister::thread:
    return Thread;
  case SpecialRegister::tp:
    return Thread % Chip.TpsPerTm;
  case SpecialRegister::tm:
    return Thread / Chip.TpsPerTm;
  case SpecialRegister::nthread:
    return Chip.threadCount();
  case SpecialRegister::ntp:
    return Chip.TpsPerTm;
  case SpecialRegister::ntm:
    return Chip.TmCount;
  case SpecialRegister::lssize:
    return Chip.LocalStoreBytes;
  case SpecialRegister::cycle:
    return uint32_t(Cycles());
  case SpecialRegister::cycleh:
    return uint32_t(Cycles() >> 32);
  case SpecialRegister::instret:
    return uint32_t(Instructions());
  case SpecialRegister::instreth:
    return uint32_t(Instructions() >> 32);
  }
  __builtin_unreachable();
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_SPECIALREGISTERS_H
