//===- SourceMap.cpp - Lines and functions of a program's addresses ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/SourceMap.h"

#include "debugger/source/NameIndex.h"
#include "debugger/source/SourceMapReader.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Demangle/Demangle.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

static bool holds(ArrayRef<AddressRange> Ranges, uint32_t Pc) {
  return any_of(Ranges, [&](const AddressRange &Range) {
    return Pc >= Range.Begin && Pc < Range.End;
  });
}

bool FunctionInfo::contains(uint32_t Pc) const { return holds(Ranges, Pc); }

bool SourceMap::Block::contains(uint32_t Pc) const { return holds(Ranges, Pc); }

SourceMap::SourceMap(const ElfProgram &Program, DWARFContext &Dwarf,
                     const NameIndex &Names, SourceFiles &Files)
    : Files(Files) {
  SourceMapReader(*this, Program, Dwarf, Names).read();
}

const LineRange *SourceMap::lineAt(uint32_t Pc) const {
  auto Behind = partition_point(
      Lines, [&](const LineRange &Range) { return Range.Begin <= Pc; });
  if (Behind == Lines.begin())
    return nullptr;
  const LineRange &Range = *std::prev(Behind);
  return Pc < Range.End ? &Range : nullptr;
}

std::vector<AddressRange> SourceMap::rangesOfLine(SourceFileId File,
                                                  uint32_t Line) const {
  std::vector<AddressRange> Result;
  for (auto At =
           partition_point(ByLine,
                           [&](uint32_t I) {
                             const SourcePosition &Position = Lines[I].Position;
                             return std::pair(Position.File, Position.Line) <
                                    std::pair(File, Line);
                           });
       At != ByLine.end() && Lines[*At].Position.File == File &&
       Lines[*At].Position.Line == Line;
       ++At)
    Result.push_back({Lines[*At].Begin, Lines[*At].End});
  return Result;
}

/// A stop at the first instruction of a function would be before its frame is
/// made.
uint32_t SourceMap::stopIn(uint32_t Address) const {
  std::optional<uint32_t> Index = functionAt(Address);
  if (!Index)
    return Address;
  const FunctionInfo &Function = Functions[*Index];
  return Address >= Function.Entry && Address < Function.Body ? Function.Body
                                                              : Address;
}

std::vector<LineStop> SourceMap::stopsAtLine(SourceFileId File,
                                             uint32_t Line) const {
  auto At = partition_point(ByLine, [&](uint32_t I) {
    const SourcePosition &Position = Lines[I].Position;
    return std::pair(Position.File, Position.Line) < std::pair(File, Line);
  });
  auto IsInFile = [&] {
    return At != ByLine.end() && Lines[*At].Position.File == File;
  };
  while (IsInFile() && !Lines[*At].IsStatement)
    ++At;
  std::vector<LineStop> Stops;
  if (!IsInFile())
    return Stops;
  SourcePosition Found = {File, Lines[*At].Position.Line, 0};
  std::vector<uint32_t> Seen;
  for (; IsInFile() && Lines[*At].Position.Line == Found.Line; ++At) {
    if (!Lines[*At].IsStatement)
      continue;
    std::vector<InlinedCall> Calls = callsAt(Lines[*At].Begin);
    if (!Calls.empty() && is_contained(Seen, Calls.front().Function))
      continue;
    if (!Calls.empty())
      Seen.push_back(Calls.front().Function);
    uint32_t Address =
        Calls.size() == 1 ? stopIn(Lines[*At].Begin) : Lines[*At].Begin;
    Stops.push_back({Address, Found});
  }
  return Stops;
}

/// `f (int,char)` and `f(int, char)` are the same.
static std::string withoutSpaces(StringRef Text) {
  std::string Result;
  for (char C : Text)
    if (C != ' ')
      Result += C;
  return Result;
}

std::vector<uint32_t> SourceMap::findFunctions(StringRef Name) const {
  std::vector<uint32_t> Result;
  Name = Name.trim();
  StringRef Plain = Name, Parameters;
  size_t Open = parameterListOf(Name);
  if (Open != StringRef::npos) {
    Plain = Name.take_front(Open).rtrim();
    Parameters = Name.drop_front(Open);
  }
  auto Found = ByName.find(lastComponent(Plain));
  if (Found != ByName.end())
    for (uint32_t Index : Found->second) {
      const FunctionInfo &Function = Functions[Index];
      if (!matchesName(Function.QualifiedName, Plain))
        continue;
      StringRef Own =
          StringRef(Function.Name).drop_front(Function.QualifiedName.size());
      if (Parameters.empty() ||
          withoutSpaces(Own) == withoutSpaces(Parameters) ||
          withoutSpaces(Own) == withoutSpaces(Parameters) + "const")
        Result.push_back(Index);
    }
  if (Result.empty())
    for (uint32_t Index = 0; Index != Functions.size(); ++Index)
      if (Functions[Index].LinkageName == Name)
        Result.push_back(Index);
  return Result;
}

std::optional<uint32_t> SourceMap::functionAt(uint32_t Pc) const {
  auto Behind = partition_point(
      ByAddress, [&](const auto &Entry) { return Entry.first.Begin <= Pc; });
  if (Behind == ByAddress.begin() || Pc >= std::prev(Behind)->first.End)
    return std::nullopt;
  return Blocks[std::prev(Behind)->second].Function;
}

void SourceMap::chainAt(uint32_t Pc, std::vector<const Block *> &Chain) const {
  auto Behind = partition_point(
      ByAddress, [&](const auto &Entry) { return Entry.first.Begin <= Pc; });
  if (Behind == ByAddress.begin() || Pc >= std::prev(Behind)->first.End)
    return;
  const Block *At = &Blocks[std::prev(Behind)->second];
  while (At) {
    Chain.push_back(At);
    auto Inner =
        find_if(At->Inner, [&](const Block &B) { return B.contains(Pc); });
    At = Inner == At->Inner.end() ? nullptr : &*Inner;
  }
}

std::vector<InlinedCall> SourceMap::callsAt(uint32_t Pc) const {
  std::vector<const Block *> Chain;
  chainAt(Pc, Chain);
  std::vector<InlinedCall> Result;
  if (Chain.empty())
    return Result;
  SourcePosition Position;
  if (const LineRange *Line = lineAt(Pc))
    Position = Line->Position;
  DWARFDie Innermost;
  for (const Block *B : reverse(Chain)) {
    if (!Innermost)
      Innermost = B->Die;
    if (!B->IsInlined && B != Chain.front())
      continue;
    Result.push_back({B->Function, Position, Innermost});
    Innermost = DWARFDie();
    if (!B->IsInlined)
      continue;
    uint32_t File = 0, Line = 0, Column = 0, Discriminator = 0;
    B->Die.getCallerFrame(File, Line, Column, Discriminator);
    Position = {fileOf(B->Die, File), Line, Column};
  }
  return Result;
}

std::vector<DWARFDie> SourceMap::blocksAt(uint32_t Pc) const {
  std::vector<const Block *> Chain;
  chainAt(Pc, Chain);
  std::vector<DWARFDie> Result;
  for (const Block *B : reverse(Chain))
    if (B->Die)
      Result.push_back(B->Die);
  return Result;
}

SourceFileId SourceMap::fileOf(DWARFDie Die, uint64_t Number) const {
  auto Found = UnitFiles.find(Die.getDwarfUnit()->getOffset());
  if (Found == UnitFiles.end() || Number >= Found->second.size())
    return 0;
  return Found->second[Number];
}

SourcePosition SourceMap::declarationOf(DWARFDie Die) const {
  while (Die) {
    uint64_t Line = toUnsigned(Die.find(DW_AT_decl_line), 0);
    if (Line)
      return {fileOf(Die, toUnsigned(Die.find(DW_AT_decl_file), 0)),
              uint32_t(Line),
              uint32_t(toUnsigned(Die.find(DW_AT_decl_column), 0))};
    DWARFDie Next = Die.getAttributeValueAsReferencedDie(DW_AT_specification);
    if (!Next)
      Next = Die.getAttributeValueAsReferencedDie(DW_AT_abstract_origin);
    Die = Next;
  }
  return {};
}

std::optional<std::string> SourceMap::symbolAt(uint32_t Address) const {
  std::string Name;
  uint32_t Offset = 0;
  if (std::optional<uint32_t> Index = functionAt(Address)) {
    Name = Functions[*Index].Name;
    Offset = Address - Functions[*Index].Entry;
  } else {
    auto Behind = partition_point(
        Symbols, [&](const Symbol &S) { return S.Address <= Address; });
    while (Behind != Symbols.begin()) {
      const Symbol &S = *--Behind;
      if (Address - S.Address >= std::max(S.Size, 1u))
        continue;
      Name = demangle(S.Name);
      Offset = Address - S.Address;
      break;
    }
  }
  if (Name.empty())
    return std::nullopt;
  return Offset ? Name + "+" + std::to_string(Offset) : Name;
}

std::string SourceMap::describeAddress(uint32_t Address) const {
  std::string Text = "0x" + utohexstr(Address, /*LowerCase=*/true, 8);
  if (std::optional<std::string> Symbol = symbolAt(Address))
    Text += " <" + *Symbol + ">";
  return Text;
}

} // namespace tp
