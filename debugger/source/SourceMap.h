//===- SourceMap.h - Lines and functions by address -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_SOURCEMAP_H
#define TP_DEBUGGER_SOURCE_SOURCEMAP_H

#include "debugger/source/SourceFiles.h"
#include "simulator/loader/ElfProgram.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace llvm {
class DWARFContext;
} // namespace llvm

namespace tp {

class NameIndex;

/// Addresses [Begin, End) that come from one line.
struct LineRange {
  uint32_t Begin = 0;
  uint32_t End = 0;
  SourcePosition Position;
  /// Begin is where the debugger should stop for this line.
  bool IsStatement = false;
  /// Begin is behind a function's prologue.
  bool EndsPrologue = false;
};

/// A function, or a copy of one that was inlined into another.
struct FunctionInfo {
  /// With namespaces, classes, template arguments and parameter types:
  /// `scene::Bvh::visit(int)`.
  std::string Name;
  /// The same without parameter types.
  std::string QualifiedName;
  /// `visit`.
  std::string BaseName;
  std::string LinkageName;
  /// Where it is defined.
  SourcePosition Declared;
  /// Its code; a function may be split.
  std::vector<AddressRange> Ranges;
  uint32_t Entry = 0;
  /// Where a breakpoint on the function stops: behind the prologue.
  uint32_t Body = 0;
  /// Invalid for functions that only the symbol table knows.
  llvm::DWARFDie Die;
  /// Of an inlined copy: the function that it is in, else nothing.
  std::optional<uint32_t> InlinedInto;

  bool contains(uint32_t Pc) const;
};

/// One of the functions at an address.
struct InlinedCall {
  /// Index for SourceMap::function().
  uint32_t Function = 0;
  /// Where this function is there: the line of the instruction, or the place
  /// of the call of the function inlined into it.
  SourcePosition Position;
  /// The block of this function that holds the address.
  llvm::DWARFDie Die;
};

/// A stop for `break FILE:LINE`.
struct LineStop {
  uint32_t Address = 0;
  /// The line that the stop is at: the given one or, if that has no code, the
  /// next that has.
  SourcePosition Position;
};

/// Which source an instruction comes from, and which instructions a line or a
/// function has.
class SourceMap {
public:
  /// What is passed must outlive the map.
  SourceMap(const ElfProgram &Program, llvm::DWARFContext &Dwarf,
            const NameIndex &Names, SourceFiles &Files);

  /// Whether there are lines at all.
  bool hasLines() const { return !Lines.empty(); }
  /// Ascending by address, without overlap.
  llvm::ArrayRef<LineRange> lines() const { return Lines; }
  /// The range that holds \p Pc, or nullptr.
  const LineRange *lineAt(uint32_t Pc) const;

  /// Where to stop for a line of the file: one address per function, or
  /// inlined copy, that has code of it. Empty if no line from there on has
  /// any.
  std::vector<LineStop> stopsAtLine(SourceFileId File, uint32_t Line) const;
  /// All ranges of exactly this line.
  std::vector<AddressRange> rangesOfLine(SourceFileId File,
                                         uint32_t Line) const;

  uint32_t functionCount() const { return uint32_t(Functions.size()); }
  const FunctionInfo &function(uint32_t Index) const {
    return Functions[Index];
  }
  /// The functions and inlined copies that \p Name can mean: with or without
  /// the outer namespaces, template arguments and parameter types.
  std::vector<uint32_t> findFunctions(llvm::StringRef Name) const;
  /// The function whose code holds \p Pc, not an inlined copy.
  std::optional<uint32_t> functionAt(uint32_t Pc) const;
  /// The functions that \p Pc belongs to, innermost first; the last is
  /// functionAt(). Empty if none is known.
  std::vector<InlinedCall> callsAt(uint32_t Pc) const;

  /// Where \p Die, or what it completes or is a copy of, is declared.
  SourcePosition declarationOf(llvm::DWARFDie Die) const;
  /// The blocks and inlined copies that hold \p Pc from the innermost one out
  /// to the function itself.
  std::vector<llvm::DWARFDie> blocksAt(uint32_t Pc) const;

  /// `name+12` of the symbol that holds \p Address, code or data.
  std::optional<std::string> symbolAt(uint32_t Address) const;
  /// `0x00010040 <main()+12>` or only the address.
  std::string describeAddress(uint32_t Address) const;

  SourceFiles &files() const { return Files; }

private:
  friend class SourceMapReader;

  struct Symbol {
    uint32_t Address = 0;
    uint32_t Size = 0;
    bool IsCode = false;
    std::string Name;
  };
  /// A function, an inlined copy or a block of variables.
  struct Block {
    llvm::SmallVector<AddressRange, 1> Ranges;
    llvm::DWARFDie Die;
    /// Of whom this is the outermost block, or which it is part of.
    uint32_t Function = 0;
    bool IsInlined = false;
    std::vector<Block> Inner;

    bool contains(uint32_t Pc) const;
  };

  SourceFiles &Files;
  std::vector<LineRange> Lines;
  /// Numbers in Lines by file and line.
  std::vector<uint32_t> ByLine;
  std::vector<FunctionInfo> Functions;
  /// Code of functions that are not inlined, by address, and their blocks.
  std::vector<std::pair<AddressRange, uint32_t>> ByAddress;
  std::vector<Block> Blocks;
  /// Functions by their BaseName, with and without template arguments.
  llvm::StringMap<std::vector<uint32_t>> ByName;
  std::vector<Symbol> Symbols;
  /// The files of each unit by its offset.
  llvm::DenseMap<uint64_t, std::vector<SourceFileId>> UnitFiles;

  SourceFileId fileOf(llvm::DWARFDie Die, uint64_t Number) const;
  void chainAt(uint32_t Pc, std::vector<const Block *> &Chain) const;
  uint32_t stopIn(uint32_t Address) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_SOURCEMAP_H
