//===- SourceMapReader.cpp - Fills a SourceMap ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/SourceMapReader.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFContext.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/Object/ELFObjectFile.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

void SourceMapReader::read() {
  readSymbols();
  readLines();
  readFunctions();
  addSymbolFunctions();
  addNames();
}

/// The linker leaves debug information of what it drops, at address 0.
bool SourceMapReader::isCode(uint64_t Address) const {
  const Segment &Text = Program.text();
  return Address >= Text.Address && Address < Text.end();
}

void SourceMapReader::readSymbols() {
  for (const object::SymbolRef &Symbol : Program.object().symbols()) {
    Expected<object::SymbolRef::Type> Type = Symbol.getType();
    Expected<StringRef> Name = Symbol.getName();
    Expected<uint64_t> Address = Symbol.getAddress();
    Expected<uint32_t> Flags = Symbol.getFlags();
    Error Problems =
        joinErrors(joinErrors(Type ? Error::success() : Type.takeError(),
                              Name ? Error::success() : Name.takeError()),
                   joinErrors(Address ? Error::success() : Address.takeError(),
                              Flags ? Error::success() : Flags.takeError()));
    if (Problems) {
      consumeError(std::move(Problems));
      continue;
    }
    bool IsFunction = *Type == object::SymbolRef::ST_Function;
    bool IsData = *Type == object::SymbolRef::ST_Data;
    if (Name->empty() || *Flags & object::SymbolRef::SF_Undefined ||
        (!IsFunction && !IsData))
      continue;
    Map.Symbols.push_back({uint32_t(*Address),
                           uint32_t(object::ELFSymbolRef(Symbol).getSize()),
                           IsFunction, Name->str()});
  }
  llvm::sort(Map.Symbols, [](const auto &A, const auto &B) {
    return std::tie(A.Address, A.Size, A.Name) <
           std::tie(B.Address, B.Size, B.Name);
  });
}

void SourceMapReader::readFiles(DWARFUnit &Unit,
                                const DWARFDebugLine::LineTable &Table) {
  std::vector<SourceFileId> &Ids = Map.UnitFiles[Unit.getOffset()];
  const char *Folder = Unit.getCompilationDir();
  uint64_t Last = Table.getLastValidFileIndex().value_or(0);
  for (uint64_t Number = 0; Number <= Last; ++Number) {
    std::string Name;
    if (!Table.hasFileAtIndex(Number) ||
        !Table.getFileNameByIndex(
            Number, {}, DILineInfoSpecifier::FileLineInfoKind::RelativeFilePath,
            Name)) {
      Ids.push_back(Map.Files.add("<unknown>", {}, std::nullopt));
      continue;
    }
    std::optional<MD5::MD5Result> Checksum;
    if (Table.Prologue.ContentTypes.HasMD5)
      Checksum = Table.Prologue.getFileNameEntry(Number).Checksum;
    Ids.push_back(Map.Files.add(Name, Folder ? Folder : "", Checksum));
  }
}

void SourceMapReader::readSequence(const DWARFDebugLine::LineTable &Table,
                                   const DWARFDebugLine::Sequence &Sequence,
                                   ArrayRef<SourceFileId> UnitFiles) {
  bool IsStatement = false, EndsPrologue = false;
  for (unsigned I = Sequence.FirstRowIndex; I + 1 < Sequence.LastRowIndex;
       ++I) {
    const DWARFDebugLine::Row &Row = Table.Rows[I];
    const DWARFDebugLine::Row &Next = Table.Rows[I + 1];
    SourcePosition Position = {Row.File < UnitFiles.size() ? UnitFiles[Row.File]
                                                           : 0,
                               Row.Line, Row.Column};
    IsStatement |= Row.IsStmt;
    EndsPrologue |= Row.PrologueEnd;
    if (Next.Address.Address <= Row.Address.Address) {
      // Only what the same line says of an address holds for it.
      if (Next.Line != Row.Line)
        IsStatement = false;
      continue;
    }
    Map.Lines.push_back({uint32_t(Row.Address.Address),
                         uint32_t(Next.Address.Address), Position,
                         IsStatement && Row.Line != 0, EndsPrologue});
    IsStatement = EndsPrologue = false;
  }
}

void SourceMapReader::readLines() {
  for (const auto &Unit : Dwarf.compile_units()) {
    const DWARFDebugLine::LineTable *Table =
        Dwarf.getLineTableForUnit(Unit.get());
    if (!Table)
      continue;
    readFiles(*Unit, *Table);
    for (const DWARFDebugLine::Sequence &Sequence : Table->Sequences)
      if (isCode(Sequence.LowPC))
        readSequence(*Table, Sequence, Map.UnitFiles[Unit->getOffset()]);
  }
  llvm::sort(Map.Lines, [](const LineRange &A, const LineRange &B) {
    return A.Begin < B.Begin;
  });
  for (uint32_t I = 0; I != Map.Lines.size(); ++I)
    if (Map.Lines[I].Position.isKnown())
      Map.ByLine.push_back(I);
  llvm::sort(Map.ByLine, [&](uint32_t A, uint32_t B) {
    const SourcePosition &Left = Map.Lines[A].Position;
    const SourcePosition &Right = Map.Lines[B].Position;
    return std::tuple(Left.File, Left.Line, A) <
           std::tuple(Right.File, Right.Line, B);
  });
}

SmallVector<AddressRange, 1> SourceMapReader::rangesOf(DWARFDie Die) const {
  SmallVector<AddressRange, 1> Result;
  Expected<DWARFAddressRangesVector> Ranges = Die.getAddressRanges();
  if (!Ranges) {
    consumeError(Ranges.takeError());
    return Result;
  }
  for (const DWARFAddressRange &Range : *Ranges)
    if (isCode(Range.LowPC) && Range.HighPC > Range.LowPC)
      Result.push_back({uint32_t(Range.LowPC), uint32_t(Range.HighPC)});
  return Result;
}

static std::string typeName(DWARFDie Die) {
  std::string Text;
  raw_string_ostream OS(Text);
  DWARFDie Type = Die.getAttributeValueAsReferencedDie(DW_AT_type);
  dumpTypeQualifiedName(Type, OS);
  return Text;
}

/// `(int, float const *)`, and `const` of a member function.
static std::string parameterTypes(DWARFDie Die) {
  std::string Text = "(";
  bool IsConst = false, IsVariadic = false;
  for (DWARFDie Child : Die.children()) {
    IsVariadic |= Child.getTag() == DW_TAG_unspecified_parameters;
    if (Child.getTag() != DW_TAG_formal_parameter)
      continue;
    if (Child.find(DW_AT_artificial)) {
      std::string This = typeName(Child);
      IsConst |= StringRef(This).starts_with("const ") ||
                 StringRef(This).contains(" const ");
      continue;
    }
    if (Text.size() > 1)
      Text += ", ";
    Text += typeName(Child);
  }
  if (IsVariadic)
    Text += Text.size() > 1 ? ", ..." : "...";
  return Text + (IsConst ? ") const" : ")");
}

uint32_t SourceMapReader::addFunction(DWARFDie Die,
                                      ArrayRef<AddressRange> Ranges) {
  DWARFDie Origin = originOf(Die);
  FunctionInfo Info;
  Info.BaseName = baseName(Die).str();
  Info.QualifiedName = scopePrefix(Die) + Info.BaseName;
  Info.Name = Info.QualifiedName + parameterTypes(Origin);
  if (const char *Linkage = Die.getLinkageName())
    Info.LinkageName = Linkage;
  Info.Declared = Map.declarationOf(Die);
  Info.Ranges.assign(Ranges.begin(), Ranges.end());
  Info.Entry = Ranges.front().Begin;
  if (std::optional<uint64_t> Low = toAddress(Die.find(DW_AT_low_pc)))
    Info.Entry = uint32_t(*Low);
  if (std::optional<DWARFFormValue> Entry = Die.find(DW_AT_entry_pc)) {
    if (std::optional<uint64_t> Address = Entry->getAsAddress())
      Info.Entry = uint32_t(*Address);
    else if (std::optional<uint64_t> Offset = Entry->getAsUnsignedConstant())
      Info.Entry = Ranges.front().Begin + uint32_t(*Offset);
  }
  Info.Die = Die;
  Map.Functions.push_back(std::move(Info));
  return uint32_t(Map.Functions.size() - 1);
}

void SourceMapReader::addInner(SourceMap::Block &Outer, DWARFDie Die) {
  for (DWARFDie Child : Die.children()) {
    bool IsInlined = Child.getTag() == DW_TAG_inlined_subroutine;
    if (!IsInlined && Child.getTag() != DW_TAG_lexical_block)
      continue;
    SourceMap::Block Block;
    Block.Ranges = rangesOf(Child);
    if (Block.Ranges.empty())
      continue;
    Block.Die = Child;
    Block.IsInlined = IsInlined;
    Block.Function = Outer.Function;
    if (IsInlined) {
      Block.Function = addFunction(Child, Block.Ranges);
      Map.Functions[Block.Function].InlinedInto = Outer.Function;
    }
    addInner(Block, Child);
    Outer.Inner.push_back(std::move(Block));
  }
}

void SourceMapReader::readFunctions() {
  for (DWARFDie Die : Names.functions()) {
    SmallVector<AddressRange, 1> Ranges = rangesOf(Die);
    if (Ranges.empty())
      continue;
    SourceMap::Block Block;
    Block.Function = addFunction(Die, Ranges);
    Block.Die = Die;
    Block.Ranges = std::move(Ranges);
    addInner(Block, Die);
    for (AddressRange Range : Block.Ranges)
      Map.ByAddress.push_back({Range, uint32_t(Map.Blocks.size())});
    Map.Blocks.push_back(std::move(Block));
  }
  auto ByBegin = [](const auto &A, const auto &B) {
    return A.first.Begin < B.first.Begin;
  };
  llvm::sort(Map.ByAddress, ByBegin);
}

/// Functions that only the symbol table knows.
void SourceMapReader::addSymbolFunctions() {
  std::vector<std::pair<AddressRange, uint32_t>> Added;
  for (size_t I = 0; I != Map.Symbols.size(); ++I) {
    const SourceMap::Symbol &Symbol = Map.Symbols[I];
    if (!Symbol.IsCode || !isCode(Symbol.Address) ||
        Map.functionAt(Symbol.Address) ||
        (!Added.empty() && Added.back().first.Begin == Symbol.Address))
      continue;
    uint32_t End = Symbol.Address + Symbol.Size;
    if (Symbol.Size == 0) {
      auto Next =
          std::find_if(Map.Symbols.begin() + I, Map.Symbols.end(),
                       [&](const SourceMap::Symbol &Other) {
                         return Other.IsCode && Other.Address > Symbol.Address;
                       });
      End = Next == Map.Symbols.end() ? uint32_t(Program.text().end())
                                      : Next->Address;
    }
    FunctionInfo Info;
    Info.Name = demangle(Symbol.Name);
    Info.QualifiedName =
        StringRef(Info.Name).take_front(parameterListOf(Info.Name)).str();
    Info.BaseName = lastComponent(Info.QualifiedName).str();
    Info.LinkageName = Symbol.Name;
    Info.Ranges = {{Symbol.Address, End}};
    Info.Entry = Symbol.Address;
    SourceMap::Block Block;
    Block.Function = uint32_t(Map.Functions.size());
    Block.Ranges.push_back(Info.Ranges.front());
    Map.Functions.push_back(std::move(Info));
    Added.push_back({Block.Ranges.front(), uint32_t(Map.Blocks.size())});
    Map.Blocks.push_back(std::move(Block));
  }
  Map.ByAddress.insert(Map.ByAddress.end(), Added.begin(), Added.end());
  llvm::sort(Map.ByAddress, [](const auto &A, const auto &B) {
    return A.first.Begin < B.first.Begin;
  });
}

uint32_t SourceMapReader::bodyOf(const FunctionInfo &Function) const {
  if (Function.InlinedInto || !Function.Die)
    return Function.Entry;
  auto First = partition_point(Map.Lines, [&](const LineRange &Range) {
    return Range.Begin < Function.Entry;
  });
  for (auto At = First; At != Map.Lines.end() && Function.contains(At->Begin);
       ++At)
    if (At->EndsPrologue)
      return At->Begin;
  // The second line, as long as it is in the function.
  if (First != Map.Lines.end())
    for (auto At = First + 1;
         At != Map.Lines.end() && Function.contains(At->Begin); ++At)
      if (At->IsStatement && At->Position.Line != First->Position.Line)
        return At->Begin;
  return Function.Entry;
}

void SourceMapReader::addNames() {
  for (uint32_t I = 0; I != Map.Functions.size(); ++I) {
    FunctionInfo &Function = Map.Functions[I];
    Function.Body = bodyOf(Function);
    Map.ByName[Function.BaseName].push_back(I);
    StringRef Plain = withoutTemplateArguments(Function.BaseName);
    if (Plain != Function.BaseName)
      Map.ByName[Plain].push_back(I);
  }
}

} // namespace tp
