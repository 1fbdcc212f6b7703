//===- ThreadGroups.cpp - Threads by the place they are at ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ThreadGroups.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"

using namespace llvm;

namespace tp::dap {

/// The place of an instruction as the user knows it.
static std::string placeText(uint32_t Pc, const SourceMap &Map) {
  std::vector<InlinedCall> Calls = Map.callsAt(Pc);
  if (Calls.empty())
    return Map.describeAddress(Pc);
  const InlinedCall &Innermost = Calls.front();
  std::string Name = Map.function(Innermost.Function).Name;
  if (!Innermost.Position.isKnown())
    return Name;
  return Name + " at " + Map.files().shortName(Innermost.Position);
}

std::vector<ThreadGroup> groupThreads(Session &Program) {
  const SourceMap &Map = Program.information().map();
  DenseMap<uint32_t, size_t> GroupOfPc;
  StringMap<size_t> GroupOfPlace;
  std::vector<ThreadGroup> Groups;
  uint32_t Count = Program.replay().threadCount();
  for (uint32_t Thread = 0; Thread < Count; ++Thread) {
    ReplayThread State = Program.replay().thread(Thread);
    bool HasHalted = State.State == ThreadState::Halted;
    // No instruction is at an odd address.
    uint32_t Key = HasHalted ? 1 : State.Pc;
    auto [Known, IsNewPc] = GroupOfPc.try_emplace(Key, Groups.size());
    if (IsNewPc) {
      std::string Place = HasHalted ? "halted" : placeText(State.Pc, Map);
      auto [Same, IsNewPlace] = GroupOfPlace.try_emplace(Place, Groups.size());
      Known->second = Same->second;
      if (IsNewPlace)
        Groups.push_back({Place, {}});
    }
    Groups[Known->second].Threads.push_back(Thread);
  }
  return Groups;
}

} // namespace tp::dap
