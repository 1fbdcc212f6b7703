//===- UndefinedOrigins.h - Where undefined values come from ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_UNDEFINEDORIGINS_H
#define TP_SIMULATOR_CHECK_UNDEFINEDORIGINS_H

#include "simulator/check/HeapBlocks.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace tp {

/// Names an origin.
using OriginId = uint32_t;

inline constexpr OriginId NoOrigin = 0;
/// A register that the program has not written.
inline constexpr OriginId UnwrittenRegister = 1;

/// Memory that has not been written since it was allocated.
struct UndefinedOrigin {
  /// Such as "4 bytes into a heap block of 40 bytes".
  std::string What;
  /// Where the memory was allocated, of the heap; else where it was read.
  const char *PlaceIs = nullptr;
  CodePlace Place;
};

/// All origins, each once.
class UndefinedOrigins {
public:
  /// Keeps so many origins apart.
  explicit UndefinedOrigins(size_t MaxOrigins = 1 << 18)
      : MaxOrigins(MaxOrigins), Origins(FirstOfMemory) {
    Origins[UnwrittenRegister].What = "a register that was never written";
    Origins[SomeMemory].What = "memory that nobody has written";
  }

  /// The number of this one.
  OriginId add(UndefinedOrigin Origin) {
    if (Origins.size() >= MaxOrigins)
      return SomeMemory;
    auto [Known, IsNew] = Numbers.try_emplace(
        std::tuple(Origin.Place.Pc, Origin.Place.Calls, Origin.What),
        OriginId(Origins.size()));
    if (IsNew)
      Origins.push_back(std::move(Origin));
    return Known->second;
  }

  const UndefinedOrigin &operator[](OriginId Id) const { return Origins[Id]; }

private:
  /// One of those that are too many.
  static constexpr OriginId SomeMemory = 2;
  static constexpr OriginId FirstOfMemory = 3;

  const size_t MaxOrigins;
  std::vector<UndefinedOrigin> Origins;
  std::map<std::tuple<uint32_t, CallContext, std::string>, OriginId> Numbers;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_UNDEFINEDORIGINS_H
