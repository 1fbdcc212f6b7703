//===- DisassemblyView.cpp - Instructions for a client --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/DisassemblyView.h"

#include "debugger/dap/MemoryReference.h"

#include "llvm/Support/Endian.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp::dap {

constexpr uint32_t InstructionBytes = 4;

json::Array DisassemblyView::show(int64_t Address, uint32_t Count) {
  json::Array Rows;
  const Segment &Text = Program.text();
  LastFile.reset();
  for (uint32_t I = 0; I < Count; ++I, Address += InstructionBytes) {
    if (Address >= int64_t(Text.Address) &&
        Address + InstructionBytes <= int64_t(Text.end())) {
      Rows.push_back(instruction(uint32_t(Address)));
      continue;
    }
    // The address space is a ring for a client that scrolls over its ends.
    Rows.push_back(json::Object{{"address", addressText(uint32_t(Address))},
                                {"instruction", "no instruction"},
                                {"presentationHint", "invalid"}});
  }
  return Rows;
}

json::Object DisassemblyView::instruction(uint32_t Address) {
  const Segment &Text = Program.text();
  size_t Offset = Address - Text.Address;
  uint32_t Word = 0;
  if (Offset + InstructionBytes <= Text.Contents.size())
    Word = support::endian::read32le(Text.Contents.data() + Offset);
  std::string Bytes;
  raw_string_ostream(Bytes) << format("%08x", Word);
  json::Object Row{{"address", addressText(Address)},
                   {"instructionBytes", std::move(Bytes)},
                   {"instruction", Printer.print(Word, Address)}};
  addPlace(Row, Address);
  return Row;
}

void DisassemblyView::addPlace(json::Object &Row, uint32_t Address) {
  const SourceMap &Map = Information.map();
  if (std::optional<uint32_t> Function = Map.functionAt(Address))
    if (Map.function(*Function).Entry == Address)
      Row["symbol"] = json::fixUTF8(Map.function(*Function).Name);
  const LineRange *Line = Map.lineAt(Address);
  if (!Line || !Line->Position.isKnown())
    return;
  Row["line"] = Line->Position.Line;
  if (LastFile == Line->Position.File)
    return;
  LastFile = Line->Position.File;
  Row["location"] = ClientSources(Information.files()).describe(*LastFile);
}

} // namespace tp::dap
