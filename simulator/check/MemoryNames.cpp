//===- MemoryNames.cpp - What lies where in global memory -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/MemoryNames.h"

#include "simulator/check/ObjectPlace.h"

#include "llvm/Demangle/Demangle.h"
#include "llvm/Object/ELFObjectFile.h"

#include <cstring>
#include <iterator>

using namespace llvm;

namespace tp {

/// The bytes of \p Program at [\p Begin, \p Begin + \p Bytes), or nothing.
static ArrayRef<uint8_t> contentsAt(const ElfProgram &Program, uint64_t Begin,
                                    uint64_t Bytes) {
  for (const Segment &S : Program.segments())
    if (Begin >= S.Address && Begin + Bytes <= S.Address + S.Contents.size())
      return S.Contents.slice(Begin - S.Address, Bytes);
  return {};
}

std::vector<CheckedGlobal> readCheckedGlobals(const ElfProgram &Program) {
  std::vector<CheckedGlobal> Globals;
  for (object::SymbolRef Symbol : Program.object().symbols()) {
    Expected<StringRef> Name = Symbol.getName();
    Expected<uint64_t> Address = Symbol.getAddress();
    if (Name && Address && Name->starts_with(CheckedGlobalsSymbol)) {
      ArrayRef<uint8_t> Table =
          contentsAt(Program, *Address, object::ELFSymbolRef(Symbol).getSize());
      const size_t Count = Table.size() / sizeof(CheckedGlobal);
      Globals.resize(Globals.size() + Count);
      std::memcpy(Globals.data() + Globals.size() - Count, Table.data(),
                  Count * sizeof(CheckedGlobal));
    }
    consumeError(Name.takeError());
    consumeError(Address.takeError());
  }
  return Globals;
}

MemoryNames::MemoryNames(const ElfProgram &Program) {
  for (object::SymbolRef Symbol : Program.object().symbols()) {
    object::ELFSymbolRef Variable(Symbol);
    const uint8_t Type = Variable.getELFType();
    if ((Type != ELF::STT_OBJECT && Type != ELF::STT_TLS) ||
        Variable.getSize() == 0)
      continue;
    Expected<StringRef> Name = Symbol.getName();
    Expected<uint64_t> Address = Symbol.getAddress();
    if (Name && Address)
      add({uint32_t(*Address), Variable.getSize(),
           "'" + demangle(*Name) + "'"});
    consumeError(Name.takeError());
    consumeError(Address.takeError());
  }
  for (const CheckedGlobal &Known : readCheckedGlobals(Program))
    Objects.try_emplace(Known.Address, Object{0, "a constant without a name"})
        .first->second.Bytes = Known.Bytes;
}

void MemoryNames::add(const LaunchPart &Part) {
  Objects[Part.Address] = {Part.Bytes, Part.Name};
}

std::optional<std::string> MemoryNames::describe(uint32_t Address) const {
  auto Behind = Objects.upper_bound(Address);
  if (Behind == Objects.begin())
    return std::nullopt;
  const auto &[Begin, Found] = *std::prev(Behind);
  uint32_t Offset = Address - Begin;
  // Farther away it is none of the object's business.
  if (Offset >= Found.Bytes + LaunchPaddingBytes)
    return std::nullopt;
  return describePlace(Address, Begin, Found.Bytes, Found.Name);
}

} // namespace tp
