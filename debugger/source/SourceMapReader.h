//===- SourceMapReader.h - Fills a SourceMap --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_SOURCEMAPREADER_H
#define TP_DEBUGGER_SOURCE_SOURCEMAPREADER_H

#include "debugger/source/NameIndex.h"
#include "debugger/source/SourceMap.h"

#include "llvm/DebugInfo/DWARF/DWARFDebugLine.h"

namespace tp {

/// Reads the symbols, lines and functions of a program into a SourceMap.
class SourceMapReader {
public:
  SourceMapReader(SourceMap &Map, const ElfProgram &Program,
                  llvm::DWARFContext &Dwarf, const NameIndex &Names)
      : Map(Map), Program(Program), Dwarf(Dwarf), Names(Names) {}

  void read();

private:
  SourceMap &Map;
  const ElfProgram &Program;
  llvm::DWARFContext &Dwarf;
  const NameIndex &Names;

  bool isCode(uint64_t Address) const;
  void readSymbols();
  void readLines();
  void readFiles(llvm::DWARFUnit &Unit,
                 const llvm::DWARFDebugLine::LineTable &Table);
  void readSequence(const llvm::DWARFDebugLine::LineTable &Table,
                    const llvm::DWARFDebugLine::Sequence &Sequence,
                    llvm::ArrayRef<SourceFileId> UnitFiles);
  void readFunctions();
  void addSymbolFunctions();
  void addNames();
  llvm::SmallVector<AddressRange, 1> rangesOf(llvm::DWARFDie Die) const;
  uint32_t addFunction(llvm::DWARFDie Die, llvm::ArrayRef<AddressRange> Ranges);
  void addInner(SourceMap::Block &Outer, llvm::DWARFDie Die);
  uint32_t bodyOf(const FunctionInfo &Function) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_SOURCEMAPREADER_H
