//===- ResourceLayout.cpp - What a TM can start in one cycle --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/ResourceLayout.h"

#include <bit>

namespace tp {

ResourceLayout::Limit ResourceLayout::place(uint32_t Capacity,
                                            uint32_t Interval, uint32_t Users) {
  // A TP starts one instruction a cycle: this limit can never bind.
  if (Capacity >= Users && Interval == 1)
    return {};
  unsigned CounterBits = unsigned(std::bit_width(Capacity));
  if (Bits / PartBits != (Bits + CounterBits) / PartBits)
    Bits = (Bits / PartBits + 1) * PartBits;
  if (Bits % PartBits == 0)
    ++Bits;
  Limit Result{true, Bits, CounterBits, Capacity, Interval};
  Bits += CounterBits + 1;
  return Result;
}

ResourceLayout::ResourceLayout(const ChipConfig &Chip) {
  for (unsigned I = 0; I != NumUnits; ++I) {
    Units[I] =
        place(Chip.Units[I].Count, Chip.Units[I].Interval, Chip.TpsPerTm);
    Uniform &= Units[I].Interval == 1;
  }
  for (uint32_t I = 0; I != Chip.IcacheBanks; ++I)
    Banks.push_back(place(Chip.IcachePorts, 1, Chip.TpsPerTm));
  if (Bits > 512)
    return;
  for (const Limit &Bank : Banks)
    if (Bank.Exists)
      IcacheGuards |= Bank.guard();
  Guards = closed() | IcacheGuards;
  for (const Limit &Type : Units)
    if (Type.Exists)
      Guards |= Type.guard();
}

WideWord ResourceLayout::closed() const {
  WideWord Result = 0;
  for (unsigned Part = 0; Part < Bits; Part += PartBits)
    Result |= WideWord(1) << Part;
  return Result;
}

WideWord ResourceLayout::Limit::unused(uint64_t Cycle) const {
  if (!Exists)
    return 0;
  WideWord Full = (WideWord(1) << CounterBits) - 1;
  return (Cycle % Interval == 0 ? Full - Capacity : Full) << Shift;
}

WideWord ResourceLayout::use(Unit Type, uint32_t Bank) const {
  return Units[unsigned(Type)].one() + Banks[Bank].one();
}

WideWord ResourceLayout::unused(uint64_t Cycle) const {
  WideWord Word = 0;
  for (const Limit &Type : Units)
    Word |= Type.unused(Cycle);
  for (const Limit &Bank : Banks)
    Word |= Bank.unused(Cycle);
  return Word;
}

} // namespace tp
