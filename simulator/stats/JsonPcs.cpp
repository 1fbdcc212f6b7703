//===- JsonPcs.cpp - What happened at each instruction, as JSON -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonBlocks.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

static bool hasCounts(const PcStatistics &Counts) {
  return Counts.Executed != 0 ||
         any_of(Counts.Lost, [](uint64_t Cycles) { return Cycles != 0; });
}

/// Leaves out what is not known of \p Frame.
static void writeFrame(const SourceFrame &Frame, json::OStream &Json) {
  if (!Frame.Function.empty())
    Json.attribute("function", Frame.Function);
  if (!Frame.File.empty())
    Json.attribute("file", Frame.File);
  if (Frame.Line != 0)
    Json.attribute("line", Frame.Line);
  if (Frame.Column != 0)
    Json.attribute("column", Frame.Column);
}

static void writeSource(ArrayRef<SourceFrame> Frames, json::OStream &Json) {
  if (Frames.empty())
    return;
  writeFrame(Frames.front(), Json);
  if (Frames.size() == 1)
    return;
  Json.attributeArray("inlined_into", [&] {
    for (const SourceFrame &Frame : Frames.drop_front())
      Json.object([&] { writeFrame(Frame, Json); });
  });
}

void writePcs(const RunSummary &Run, json::OStream &Json) {
  if (!Run.FramesOf)
    return;
  Json.attributeArray("instructions_by_pc", [&] {
    for (auto [Word, Counts] : enumerate(Run.Stats.Pcs)) {
      if (!hasCounts(Counts))
        continue;
      auto Pc = uint32_t(Run.TextBegin + Word * 4);
      Json.object([&, &Counts = Counts, &Word = Word] {
        Json.attribute("pc", "0x" + utohexstr(Pc, /*LowerCase=*/true, 8));
        Json.attribute("opcode", StringRef(mnemonic(Run.Opcodes[Word])));
        Json.attribute("executed", Counts.Executed);
        Json.attributeObject("lost", [&] {
          for (unsigned I = 0; I != NumLosses; ++I)
            if (Counts.Lost[I] != 0)
              Json.attribute(lossName(Loss(I)), int64_t(Counts.Lost[I]));
        });
        writeSource(Run.FramesOf(Pc), Json);
      });
    }
  });
}

} // namespace tp
