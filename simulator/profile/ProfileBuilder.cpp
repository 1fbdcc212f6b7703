//===- ProfileBuilder.cpp - Makes a profile of a run ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileBuilder.h"

#include "simulator/loader/Disassembler.h"
#include "simulator/profile/SourcePlaces.h"
#include "simulator/stats/JsonReport.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {

namespace {

class ProfileBuilder {
public:
  ProfileBuilder(const RunSummary &Run, const ElfProgram &Program,
                 const ExecutionRecord &Record)
      : Run(Run), Program(Program), Record(Record), Places(Program, Result) {}

  Profile build(Utilisation Tms) {
    describeRun();
    for (size_t Word = 0; Word != Run.Stats.Pcs.size(); ++Word)
      addInstruction(uint32_t(Word));
    for (const CalledFunction &Called : Record.Calls)
      addCall(Called);
    Result.IsCallTreeCut = Record.IsCallTreeCut;
    Result.Tms = std::move(Tms);
    Places.readSources();
    Result.Statistics = statisticsText();
    return std::move(Result);
  }

private:
  void describeRun() {
    ProfileRun &About = Result.Run;
    About.Program = Program.path();
    About.Outcome = Run.Outcome;
    About.Chip = Run.Chip.Name;
    About.ClockGhz = Run.Chip.ClockGHz;
    About.TmCount = Run.Chip.TmCount;
    About.TpsPerTm = Run.Chip.TpsPerTm;
    About.Cycles = Run.Stats.Cycles;
    About.Finished = Run.Stats.lost(Loss::Finished);
  }

  uint32_t pcOf(uint32_t Word) const { return Run.TextBegin + Word * 4; }

  void addInstruction(uint32_t Word) {
    const PcStatistics &Counts = Run.Stats.Pcs[Word];
    ProfileCounts Sum{Counts.Executed, Counts.Lost};
    if (Sum == ProfileCounts())
      return;
    Result.Instructions.push_back({pcOf(Word), textOf(Word),
                                   Places.frameOf(pcOf(Word)), Sum,
                                   Record.Pcs[Word]});
  }

  std::string textOf(uint32_t Word) {
    const Segment &Text = Program.text();
    uint32_t Offset = pcOf(Word) - Text.Address;
    return Disassembly.print(support::endian::read32le(&Text.Contents[Offset]),
                             pcOf(Word));
  }

  void addCall(const CalledFunction &Called) {
    CallNode Node;
    Node.Function = Places.functionAt(pcOf(Called.Entry));
    Node.Caller = Called.Caller;
    Node.Calls = Called.Calls;
    Node.Self = {Called.Instructions, Called.Lost};
    if (Called.Caller)
      Node.CallSite = instructionAt(pcOf(Called.CallSite));
    Result.Calls.push_back(Node);
  }

  /// The number of an instruction that was executed.
  uint32_t instructionAt(uint32_t Pc) const {
    auto Found = partition_point(
        Result.Instructions,
        [Pc](const ProfileInstruction &Other) { return Other.Pc < Pc; });
    return uint32_t(Found - Result.Instructions.begin());
  }

  std::string statisticsText() const {
    RunSummary WithoutPcs = Run;
    WithoutPcs.FramesOf = nullptr;
    std::string Text;
    raw_string_ostream OS(Text);
    writeJson(WithoutPcs, OS);
    return formatv("{0}", cantFail(json::parse(Text)));
  }

  const RunSummary &Run;
  const ElfProgram &Program;
  const ExecutionRecord &Record;
  Profile Result;
  SourcePlaces Places;
  Disassembler Disassembly;
};

} // namespace

Profile makeProfile(const RunSummary &Run, const ElfProgram &Program,
                    const ExecutionRecord &Record, Utilisation Tms) {
  return ProfileBuilder(Run, Program, Record).build(std::move(Tms));
}

} // namespace tp
