//===- ShadowMemory.h - What is known of each byte --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// For global memory and for each local store three tables that are zero at the
// start: which bytes may be accessed, which bits are undefined (1), and where
// undefined words come from.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_SHADOWMEMORY_H
#define TP_SIMULATOR_CHECK_SHADOWMEMORY_H

#include "simulator/core/AddressSpace.h"

#include <cstring>
#include <vector>

namespace tp {

/// What an access to 8 bytes that begin at a multiple of 8 may do. From 1 to 7:
/// only so many of the first bytes may be accessed.
enum class Access : uint8_t {
  All = 0,
  /// Behind a heap block.
  HeapPadding = 0x80,
  /// Was given back.
  HeapFreed,
  /// Nobody has asked for it yet.
  HeapUnused,
  /// Around an object of the stack, or around a global.
  StackPadding,
  GlobalPadding,
  /// An object of the stack whose life is over.
  StackDead,
  /// Behind a part of the launch.
  LaunchPadding,
};

inline constexpr uint32_t AccessGranule = 8;

/// The granules that begin before \p Address.
constexpr uint32_t toGranules(uint32_t Address) {
  return (Address + AccessGranule - 1) & ~(AccessGranule - 1);
}

/// The tables of one memory. Addresses are those of the program.
class ShadowMemory {
public:
  /// Of [Begin, Begin + Bytes); \p Begin is a multiple of the granule.
  ShadowMemory(uint32_t Begin, uint64_t Bytes)
      : Begin(Begin), Bits(Bytes), Words(Bytes),
        Accesses(Bytes / AccessGranule + 1) {}

  bool isMapped() const {
    return Bits.data() && Words.data() && Accesses.data();
  }

  uint8_t accessOf(uint32_t Address) const {
    return Accesses.data()[(Address - Begin) / AccessGranule];
  }
  uint8_t *undefined(uint32_t Address) const {
    return Bits.data() + (Address - Begin);
  }
  uint32_t origin(uint32_t Address) const {
    uint32_t Value;
    std::memcpy(&Value, Words.data() + ((Address - Begin) & ~3u), 4);
    return Value;
  }
  void setOrigin(uint32_t Address, uint32_t Value) {
    HasOrigins = true;
    std::memcpy(Words.data() + ((Address - Begin) & ~3u), &Value, 4);
  }

  /// All of [\p From, \p From + \p Bytes), of which the last granule may be
  /// accessed in part, is \p Code now. \p From is a multiple of the granule.
  void setAccess(uint32_t From, uint32_t Bytes, Access Code) {
    uint8_t *First = Accesses.data() + (From - Begin) / AccessGranule;
    std::memset(First, int(Code), Bytes / AccessGranule);
    if (uint32_t Rest = Bytes % AccessGranule)
      First[Bytes / AccessGranule] =
          Code == Access::All ? uint8_t(Rest) : uint8_t(Code);
  }
  /// The content of [\p From, \p From + \p Bytes) is not defined any more.
  void setUndefined(uint32_t From, uint32_t Bytes) {
    std::memset(undefined(From), 0xff, Bytes);
    if (!HasOrigins)
      return;
    const uint32_t FirstWord = (From - Begin) & ~3u;
    const uint32_t EndWord = (From - Begin + Bytes + 3) & ~3u;
    std::memset(Words.data() + FirstWord, 0, EndWord - FirstWord);
  }

private:
  uint32_t Begin;
  HostPages Bits;
  HostPages Words;
  HostPages Accesses;
  bool HasOrigins = false;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_SHADOWMEMORY_H
