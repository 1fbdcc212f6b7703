//===- ThreadName.cpp - Threads by number or place ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/ThreadName.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

std::string threadPlace(uint32_t Thread, const ChipConfig &Chip) {
  return utostr(Thread / Chip.TpsPerTm) + "." + utostr(Thread % Chip.TpsPerTm);
}

Expected<uint32_t> parseThread(StringRef Text, const ChipConfig &Chip) {
  auto Invalid = [&] {
    return createStringError("Invalid thread ID: " + Text +
                             "; it is a number, or TM.TP");
  };
  uint32_t First, Second;
  auto [Tm, Tp] = Text.split('.');
  if (Tm.getAsInteger(10, First))
    return Invalid();
  if (Text.contains('.')) {
    if (Tp.getAsInteger(10, Second))
      return Invalid();
    if (First >= Chip.TmCount || Second >= Chip.TpsPerTm)
      return createStringError("Unknown thread " + Text +
                               ": the chip has TMs 0 to " +
                               Twine(Chip.TmCount - 1) + " with TPs 0 to " +
                               Twine(Chip.TpsPerTm - 1));
    return First * Chip.TpsPerTm + Second;
  }
  if (First >= Chip.threadCount())
    return createStringError("Unknown thread " + Text +
                             ": the chip has threads 0 to " +
                             Twine(Chip.threadCount() - 1));
  return First;
}

std::string threadList(ArrayRef<uint32_t> Threads) {
  std::string Result;
  for (size_t I = 0; I < Threads.size();) {
    size_t Last = I;
    while (Last + 1 < Threads.size() && Threads[Last + 1] == Threads[Last] + 1)
      ++Last;
    Result += (Result.empty() ? "" : ", ") + utostr(Threads[I]);
    if (Last != I)
      Result += "-" + utostr(Threads[Last]);
    I = Last + 1;
  }
  return Result;
}

} // namespace tp
