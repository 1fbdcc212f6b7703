//===- TraceFile.cpp - Traces of threads for Perfetto ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/TraceFile.h"

#include "simulator/loader/Disassembler.h"
#include "simulator/loader/Symbolizer.h"
#include "simulator/profile/ProfileNames.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {

namespace {

/// Tracks of a TP have numbers from its number times this.
constexpr uint32_t TracksPerTp = 1024;

class TraceFileWriter {
public:
  TraceFileWriter(const ChipConfig &Chip, const ElfProgram &Program,
                  raw_ostream &OS)
      : Chip(Chip), Program(Program), Symbols(Program, SourcePaths::Relative),
        OS(OS), Json(OS) {}

  void write(ArrayRef<ThreadTrace> Traces) {
    Json.object([&] {
      Json.attributeObject("otherData", [&] {
        Json.attribute("chip", Chip.Name);
        Json.attribute("clock_ghz", Chip.ClockGHz);
        Json.attribute("microsecond", "a cycle");
      });
      Json.attributeArray("traceEvents", [&] {
        for (const ThreadTrace &Trace : Traces)
          writeTrace(Trace);
      });
    });
    OS << '\n';
  }

private:
  void writeTrace(const ThreadTrace &Trace) {
    Process = Trace.Thread / Chip.TpsPerTm;
    uint32_t Tp = Trace.Thread % Chip.TpsPerTm;
    Track = Tp * TracksPerTp;
    name("process_name", "TM " + Twine(Process));
    name("thread_name", "TP " + Twine(Tp));
    for (const TracedIssue &Issue : Trace.Issues)
      writeSpan(textOf(Issue.Word), "issue", {Issue.Cycle, Issue.Cycle + 1},
                [&] {
                  writePlace(Issue.Word);
                  if (Issue.Address)
                    writeAddress(*Issue.Address);
                });
    for (const TracedStall &Stall : Trace.Stalls)
      writeSpan(lossName(Stall.Reason), "stall", Stall.Cycles, [&] {
        if (Stall.Reason == Loss::Finished)
          return;
        Json.attribute("instruction", textOf(Stall.Word));
        writePlace(Stall.Word);
      });
    writeAccesses(Trace, Tp);
  }

  /// Each on the first track that is free then.
  void writeAccesses(const ThreadTrace &Trace, uint32_t Tp) {
    DenseMap<uint64_t, uint32_t> AddressAt;
    for (const TracedIssue &Issue : Trace.Issues)
      if (Issue.Address)
        AddressAt[Issue.Cycle] = *Issue.Address;
    std::vector<uint64_t> FreeFrom;
    for (const AnsweredRequest &Access : Trace.Accesses) {
      auto Free = find_if(
          FreeFrom, [&](uint64_t Cycle) { return Cycle <= Access.Issued; });
      auto Lane = uint32_t(Free - FreeFrom.begin());
      Track = Tp * TracksPerTp + 1 + std::min(Lane, TracksPerTp - 2);
      if (Free == FreeFrom.end()) {
        FreeFrom.push_back(Access.Ready);
        name("thread_name", "TP " + Twine(Tp) + " memory " + Twine(Lane));
      } else {
        *Free = Access.Ready;
      }
      writeSpan(levelName(Access.Level), "memory",
                {Access.Issued, Access.Ready}, [&] {
                  Json.attribute("instruction", textOf(Access.Word));
                  writePlace(Access.Word);
                  auto Known = AddressAt.find(Access.Issued);
                  if (Known != AddressAt.end())
                    writeAddress(Known->second);
                });
    }
  }

  void name(StringRef What, const Twine &Name) {
    Json.object([&] {
      Json.attribute("name", What);
      Json.attribute("ph", "M");
      Json.attribute("pid", Process);
      Json.attribute("tid", Track);
      Json.attributeObject("args", [&] { Json.attribute("name", Name.str()); });
    });
  }

  void writeSpan(StringRef Name, StringRef Category, CycleRange Cycles,
                 function_ref<void()> WriteArguments) {
    Json.object([&] {
      Json.attribute("name", Name);
      Json.attribute("cat", Category);
      Json.attribute("ph", "X");
      Json.attribute("pid", Process);
      Json.attribute("tid", Track);
      // Viewers round to nanoseconds: a cycle may be less.
      Json.attribute("ts", Cycles.Begin);
      Json.attribute("dur", Cycles.End - Cycles.Begin);
      Json.attributeObject("args", [&] {
        Json.attribute("cycle", Cycles.Begin);
        Json.attribute("cycles", Cycles.End - Cycles.Begin);
        WriteArguments();
      });
    });
  }

  void writeAddress(uint32_t Address) {
    Json.attribute("address", "0x" + utohexstr(Address, true, 8));
  }

  void writePlace(uint32_t Word) {
    Json.attribute("pc", "0x" + utohexstr(pcOf(Word), true, 8));
    const SourceFrame &Place = placeAt(Word);
    if (!Place.Function.empty())
      Json.attribute("function", Place.Function);
    if (!Place.File.empty() && Place.Line != 0)
      Json.attribute("line", Place.File + ":" + std::to_string(Place.Line));
  }

  uint32_t pcOf(uint32_t Word) const {
    return Program.text().Address + Word * 4;
  }

  const SourceFrame &placeAt(uint32_t Word) {
    auto [Known, IsNew] = Places.try_emplace(Word);
    if (IsNew) {
      std::vector<SourceFrame> Frames = Symbols.frames(pcOf(Word));
      if (!Frames.empty())
        Known->second = Frames.front();
    }
    return Known->second;
  }

  const std::string &textOf(uint32_t Word) {
    auto [Known, IsNew] = Texts.try_emplace(Word);
    if (IsNew)
      Known->second = Disassembly.print(
          support::endian::read32le(&Program.text().Contents[size_t(Word) * 4]),
          pcOf(Word));
    return Known->second;
  }

  const ChipConfig &Chip;
  const ElfProgram &Program;
  Symbolizer Symbols;
  Disassembler Disassembly;
  raw_ostream &OS;
  json::OStream Json;
  DenseMap<uint32_t, SourceFrame> Places;
  DenseMap<uint32_t, std::string> Texts;
  uint32_t Process = 0;
  uint32_t Track = 0;
};

} // namespace

void writeThreadTraces(ArrayRef<ThreadTrace> Traces, const ChipConfig &Chip,
                       const ElfProgram &Program, raw_ostream &OS) {
  TraceFileWriter(Chip, Program, OS).write(Traces);
}

} // namespace tp
