//===- ProfileWriter.cpp - A profile as JSON ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileJson.h"
#include "simulator/profile/ProfileNames.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {

namespace {

class ProfileWriter {
public:
  ProfileWriter(const Profile &Data, raw_ostream &OS)
      : Data(Data), OS(OS), Json(OS) {}

  void write() {
    Json.object([&] {
      Json.attribute("format_version", ProfileFormatVersion);
      writeRun();
      array("files", Data.Files, &ProfileWriter::writeFile);
      array("functions", Data.Functions, &ProfileWriter::writeFunction);
      array("frames", Data.Frames, &ProfileWriter::writeFrame);
      array("instructions", Data.Instructions,
            &ProfileWriter::writeInstruction);
      array("call_tree", Data.Calls, &ProfileWriter::writeCall);
      if (Data.IsCallTreeCut)
        Json.attribute("call_tree_is_cut", true);
      writeUtilisation();
      if (!Data.Statistics.empty()) {
        Json.attributeBegin("statistics");
        Json.rawValue(Data.Statistics);
        Json.attributeEnd();
      }
    });
    OS << '\n';
  }

private:
  template <class Element>
  void array(const char *Name, const std::vector<Element> &Elements,
             void (ProfileWriter::*Write)(const Element &)) {
    Json.attributeArray(Name, [&] {
      for (const Element &E : Elements)
        Json.object([&] { (this->*Write)(E); });
    });
  }

  void writeRun() {
    const ProfileRun &Run = Data.Run;
    Json.attributeObject("run", [&] {
      Json.attribute("program", Run.Program);
      Json.attribute("outcome", Run.Outcome);
      Json.attribute("chip", Run.Chip);
      Json.attribute("clock_ghz", Run.ClockGhz);
      Json.attribute("tm_count", Run.TmCount);
      Json.attribute("tps_per_tm", Run.TpsPerTm);
      Json.attribute("cycles", Run.Cycles);
      Json.attribute("thread_cycles", Run.threadCycles());
      Json.attribute("instructions", Data.total().Instructions);
      Json.attribute("finished", Run.Finished);
    });
  }

  void index(const char *Name, std::optional<uint32_t> Index) {
    if (Index)
      Json.attribute(Name, *Index);
  }
  void number(const char *Name, uint32_t Known) {
    if (Known != 0)
      Json.attribute(Name, Known);
  }

  void writeFile(const ProfileFile &File) {
    Json.attribute("path", json::fixUTF8(File.Path));
    if (File.Text)
      Json.attribute("text", json::fixUTF8(*File.Text));
  }

  void writeFunction(const ProfileFunction &Function) {
    Json.attribute("name", json::fixUTF8(Function.Name));
    index("file", Function.File);
    number("line", Function.Line);
  }

  void writeFrame(const ProfileFrame &Frame) {
    Json.attribute("function", Frame.Function);
    index("file", Frame.File);
    number("line", Frame.Line);
    number("column", Frame.Column);
    index("inlined_into", Frame.InlinedInto);
  }

  void writeLost(const LossCounts &Lost) {
    Json.attributeObject("lost", [&] {
      for (unsigned I = 0; I != NumLosses; ++I)
        if (Lost[I] != 0)
          Json.attribute(lossName(Loss(I)), int64_t(Lost[I]));
    });
  }

  void writeInstruction(const ProfileInstruction &Instruction) {
    Json.attribute("pc", "0x" + utohexstr(Instruction.Pc, true, 8));
    Json.attribute("text", Instruction.Text);
    Json.attribute("frame", Instruction.Frame);
    Json.attribute("executed", Instruction.Counts.Instructions);
    writeLost(Instruction.Counts.Lost);
    const MemoryBehaviour &Memory = Instruction.Memory;
    if (Memory.Global == 0)
      return;
    Json.attribute("global", Memory.Global);
    Json.attributeObject("served", [&] {
      for (unsigned I = 0; I != NumServedBy; ++I)
        if (Memory.Served[I].Accesses != 0)
          Json.attributeObject(levelName(ServedBy(I)), [&] {
            Json.attribute("accesses", Memory.Served[I].Accesses);
            Json.attribute("cycles", Memory.Served[I].Cycles);
          });
    });
  }

  void writeCall(const CallNode &Call) {
    Json.attribute("function", Call.Function);
    index("caller", Call.Caller);
    index("call_site", Call.CallSite);
    Json.attribute("calls", Call.Calls);
    writeCounts(Call.Self);
  }

  void writeCounts(const ProfileCounts &Counts) {
    Json.attribute("instructions", Counts.Instructions);
    writeLost(Counts.Lost);
  }

  void writeTms(const char *Name,
                const std::vector<std::vector<uint64_t>> &Tms) {
    Json.attributeArray(Name, [&] {
      for (const std::vector<uint64_t> &Intervals : Tms)
        Json.array([&] {
          for (uint64_t Count : Intervals)
            Json.value(Count);
        });
    });
  }

  void writeUtilisation() {
    const Utilisation &Tms = Data.Tms;
    Json.attributeObject("utilisation", [&] {
      Json.attributeArray("ends", [&] {
        for (uint64_t End : Tms.Ends)
          Json.value(End);
      });
      array("chip", Tms.Chip, &ProfileWriter::writeCounts);
      writeTms("issued", Tms.Issued);
      writeTms("memory", Tms.Memory);
      writeTms("finished", Tms.Finished);
    });
  }

  const Profile &Data;
  raw_ostream &OS;
  json::OStream Json;
};

} // namespace

void writeProfile(const Profile &Data, raw_ostream &OS) {
  ProfileWriter(Data, OS).write();
}

} // namespace tp
