//===- DramAddressMapping.cpp - Where a byte lies in DRAM ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramAddressMapping.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

using namespace tp;

namespace {

constexpr std::array<std::string_view, 5> FieldNames = {
    "row", "bank", "bankgroup", "column", "channel"};

/// `name` or `name/base`.
struct FieldText {
  std::string_view Name;
  std::optional<uint32_t> Base;
};

std::optional<FieldText> readField(std::string_view Text) {
  size_t Slash = Text.find('/');
  if (Slash == std::string_view::npos)
    return FieldText{Text, std::nullopt};
  std::string_view Number = Text.substr(Slash + 1);
  uint32_t Base = 0;
  auto [End, Error] =
      std::from_chars(Number.data(), Number.data() + Number.size(), Base);
  if (Error != std::errc() || End != Number.data() + Number.size() || Base < 2)
    return std::nullopt;
  return FieldText{Text.substr(0, Slash), Base};
}

std::string quoted(std::string_view Text) {
  return "'" + std::string(Text) + "'";
}

} // namespace

uint64_t tp::dramCapacityBytes(const DramConfig &Config) {
  return uint64_t(Config.Channels) * Config.BankGroups * Config.BanksPerGroup *
         Config.RowsPerBank * Config.RowBytes;
}

std::string tp::checkAddressMapping(const DramConfig &Config) {
  return DramAddressMapping().parse(Config);
}

DramAddressMapping::DramAddressMapping(const DramConfig &Config) {
  parse(Config);
}

std::string DramAddressMapping::parse(const DramConfig &Config) {
  BurstBytes = Config.BurstBytes;
  BanksPerGroup = Config.BanksPerGroup;
  const std::array<uint32_t, NumFields> Sizes = {
      Config.RowsPerBank, Config.BanksPerGroup, Config.BankGroups,
      Config.RowBytes / Config.BurstBytes, Config.Channels};
  std::array<uint32_t, NumFields> Weights;
  Weights.fill(1);

  std::string_view Rest = Config.AddressMapping;
  for (bool Last = false; !Last;) {
    size_t Colon = Rest.rfind(':');
    Last = Colon == std::string_view::npos;
    std::string_view Text = Last ? Rest : Rest.substr(Colon + 1);
    Rest = Rest.substr(0, Last ? 0 : Colon);

    std::optional<FieldText> Parsed = readField(Text);
    if (!Parsed)
      return quoted(Text) + ": a number from 2 on must stand behind the slash";
    const auto *Name =
        std::find(FieldNames.begin(), FieldNames.end(), Parsed->Name);
    if (Name == FieldNames.end())
      return quoted(Text) +
             " is none of row, bank, bankgroup, column and channel";
    size_t Index = Name - FieldNames.begin();
    uint32_t Left = Sizes[Index] / Weights[Index];
    uint32_t Base = Parsed->Base.value_or(Left);
    if (Left == 1 && Sizes[Index] != 1)
      return quoted(*Name) + " stands there more often than it has digits";
    if (Left % Base != 0)
      return quoted(Text) + ": the field's size, " + std::to_string(Left) +
             ", is no multiple of it";
    Digits.push_back({Field(Index), Base, Weights[Index]});
    Weights[Index] *= Base;
  }
  for (size_t Index = 0; Index < NumFields; ++Index)
    if (Weights[Index] != Sizes[Index])
      return quoted(FieldNames[Index]) + " is missing" +
             (Weights[Index] == 1 ? "" : " for the upper part");
  return "";
}

DramLocation DramAddressMapping::locate(uint64_t Address) const {
  std::array<uint32_t, NumFields> Values{};
  uint64_t Number = Address / BurstBytes;
  for (const Digit &D : Digits) {
    Values[unsigned(D.Of)] += uint32_t(Number % D.Base) * D.Weight;
    Number /= D.Base;
  }
  auto Value = [&](Field F) { return Values[unsigned(F)]; };
  return {Value(Field::Channel),
          Value(Field::BankGroup) * BanksPerGroup + Value(Field::Bank),
          Value(Field::Row), Value(Field::Column)};
}

uint32_t DramAddressMapping::channelOf(uint64_t Address) const {
  uint32_t Channel = 0;
  uint64_t Number = Address / BurstBytes;
  for (const Digit &D : Digits) {
    if (D.Of == Field::Channel)
      Channel += uint32_t(Number % D.Base) * D.Weight;
    Number /= D.Base;
  }
  return Channel;
}
