//===- StackFiles.cpp - Profiles for viewers of stacks --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/StackFiles.h"

#include "simulator/profile/ProfileNames.h"
#include "simulator/profile/StackTree.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/JSON.h"

#include <algorithm>

using namespace llvm;

namespace tp {

/// The name of a function without what separates stacks.
static std::string stackName(const Profile &Data, uint32_t Function) {
  std::string Name = nameOf(Data.Functions[Function]);
  std::ranges::replace(Name, ';', ',');
  return Name;
}

void writeFoldedStacks(const Profile &Data, raw_ostream &OS) {
  StackTree Tree(Data);
  for (auto [I, Node] : enumerate(Tree.nodes())) {
    std::string Stack;
    for (uint32_t Function : Tree.functionsOf(uint32_t(I)))
      Stack += stackName(Data, Function) + ";";
    if (Node.Self.Instructions != 0)
      OS << Stack << "[issued] " << Node.Self.Instructions << '\n';
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      if (uint64_t Cycles = Node.Self.Lost[Reason])
        OS << Stack << '[' << lossName(Loss(Reason)) << "] " << Cycles << '\n';
  }
}

namespace {

class SpeedscopeWriter {
public:
  SpeedscopeWriter(const Profile &Data, raw_ostream &OS)
      : Data(Data), Tree(Data), OS(OS), Json(OS) {}

  void write() {
    ProfileCounts Total = Data.total();
    Json.object([&] {
      Json.attribute("$schema",
                     "https://www.speedscope.app/file-format-schema.json");
      Json.attribute("name", Data.Run.Program);
      Json.attribute("exporter", "tpsim");
      Json.attribute("activeProfileIndex", 0);
      Json.attributeObject("shared", [&] { writeFrames(); });
      Json.attributeArray("profiles", [&] {
        writeCounts("thread-cycles", [](const ProfileCounts &Counts) {
          return Counts.cycles();
        });
        writeCounts("issued", [](const ProfileCounts &Counts) {
          return Counts.Instructions;
        });
        for (unsigned I = 0; I != NumLosses; ++I)
          if (Total.Lost[I] != 0)
            writeCounts(lossName(Loss(I)), [I](const ProfileCounts &Counts) {
              return Counts.Lost[I];
            });
      });
    });
    OS << '\n';
  }

private:
  void writeFrames() {
    Json.attributeArray("frames", [&] {
      for (const ProfileFunction &Function : Data.Functions)
        Json.object([&] {
          Json.attribute("name", json::fixUTF8(nameOf(Function)));
          if (!Function.File)
            return;
          Json.attribute("file",
                         json::fixUTF8(Data.Files[*Function.File].Path));
          if (Function.Line != 0)
            Json.attribute("line", Function.Line);
        });
    });
  }

  void writeCounts(const char *Name,
                   function_ref<uint64_t(const ProfileCounts &)> CountOf) {
    std::vector<std::pair<uint32_t, uint64_t>> Weights;
    uint64_t Sum = 0;
    for (auto [I, Node] : enumerate(Tree.nodes()))
      if (uint64_t Count = CountOf(Node.Self)) {
        Weights.push_back({uint32_t(I), Count});
        Sum += Count;
      }
    Json.object([&] {
      Json.attribute("type", "sampled");
      Json.attribute("name", Name);
      Json.attribute("unit", "none");
      Json.attribute("startValue", 0);
      Json.attribute("endValue", Sum);
      Json.attributeArray("samples", [&] {
        for (auto [Node, Count] : Weights)
          Json.array([&, Node = Node] {
            for (uint32_t Function : Tree.functionsOf(Node))
              Json.value(Function);
          });
      });
      Json.attributeArray("weights", [&] {
        for (auto [Node, Count] : Weights)
          Json.value(Count);
      });
    });
  }

  const Profile &Data;
  StackTree Tree;
  raw_ostream &OS;
  json::OStream Json;
};

} // namespace

void writeSpeedscope(const Profile &Data, raw_ostream &OS) {
  SpeedscopeWriter(Data, OS).write();
}

} // namespace tp
