//===- ProfileTable.cpp - A profile for people ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileTable.h"

#include "simulator/profile/ProfileNames.h"
#include "simulator/profile/StackTree.h"
#include "simulator/stats/RunSummary.h"
#include "simulator/stats/TableText.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"

#include <algorithm>
#include <map>

using namespace llvm;

namespace tp {

namespace {

struct NamedSum {
  const char *Name;
  ProfileOrder::SumKind Sum;
};

} // namespace

static constexpr NamedSum Sums[] = {
    {"cycles", ProfileOrder::Cycles},
    {"instructions", ProfileOrder::Instructions},
    {"memory_waits", ProfileOrder::MemoryWaits},
    {"global", ProfileOrder::Global},
    {"latency", ProfileOrder::Latency},
};

std::optional<ProfileRows> findProfileRows(StringRef Name) {
  return StringSwitch<std::optional<ProfileRows>>(Name)
      .Case("line", ProfileRows::Line)
      .Case("function", ProfileRows::Function)
      .Case("path", ProfileRows::Path)
      .Case("instruction", ProfileRows::Instruction)
      .Default(std::nullopt);
}

std::optional<ProfileOrder> findProfileOrder(StringRef Name) {
  for (const NamedSum &Sum : Sums)
    if (Name == Sum.Name)
      return ProfileOrder{Sum.Sum, std::nullopt, std::nullopt};
  ProfileOrder Order{ProfileOrder::Cycles, findLoss(Name), std::nullopt};
  if (!Order.Reason)
    Order.Level = findLevel(Name);
  if (Order.Reason == Loss::Finished || (!Order.Reason && !Order.Level))
    return std::nullopt;
  return Order;
}

std::vector<std::string> profileOrderNames() {
  std::vector<std::string> Names;
  for (const NamedSum &Sum : Sums)
    Names.push_back(Sum.Name);
  for (unsigned I = 0; I != NumLosses; ++I)
    if (Loss(I) != Loss::Finished)
      Names.push_back(lossName(Loss(I)));
  for (unsigned I = 0; I != NumServedBy; ++I)
    if (!is_contained(Names, levelName(ServedBy(I))))
      Names.push_back(levelName(ServedBy(I)));
  return Names;
}

static ServedAccesses allServed(const MemoryBehaviour &Memory) {
  return servedBetween(Memory, ServedBy::L1, ServedBy::Memory);
}

static uint64_t keyOf(const ProfileRow &Row, const ProfileOrder &Order) {
  if (Order.Reason)
    return Row.Counts.Lost[unsigned(*Order.Reason)];
  if (Order.Level)
    return Row.Memory.Served[unsigned(*Order.Level)].Accesses;
  switch (Order.Sum) {
  case ProfileOrder::Cycles:
    return Row.Counts.cycles();
  case ProfileOrder::Instructions:
    return Row.Counts.Instructions;
  case ProfileOrder::MemoryWaits:
    return Row.Counts.memoryWaits();
  case ProfileOrder::Global:
    return Row.Memory.Global;
  case ProfileOrder::Latency:
    return allServed(Row.Memory).Cycles;
  }
  llvm_unreachable("every order has a key");
}

static std::string rowName(const Profile &Data,
                           const ProfileInstruction &Instruction,
                           ProfileRows Rows) {
  const ProfileFrame &Frame = Data.Frames[Instruction.Frame];
  std::string Function = shortName(nameOf(Data.Functions[Frame.Function]));
  std::string Place = placeOf(Data, Frame);
  switch (Rows) {
  case ProfileRows::Function:
    return Function;
  case ProfileRows::Line:
    return (Place.empty() ? "" : Place + " ") + Function;
  case ProfileRows::Instruction:
    return "0x" + utohexstr(Instruction.Pc, true, 8) + " " + Instruction.Text +
           "  " + (Place.empty() ? Function : Place);
  case ProfileRows::Path:
    break;
  }
  llvm_unreachable("paths are rows of the stack tree");
}

/// Functions from the inside out.
static std::string pathName(const Profile &Data, const StackTree &Tree,
                            uint32_t Node) {
  std::string Name;
  std::vector<uint32_t> Functions = Tree.functionsOf(Node);
  for (uint32_t Function : reverse(Functions))
    Name += (Name.empty() ? "" : " < ") +
            shortName(nameOf(Data.Functions[Function]));
  return Name;
}

std::vector<ProfileRow> profileRows(const Profile &Data, ProfileRows Rows,
                                    const ProfileOrder &Order) {
  std::map<std::string, ProfileRow> ByName;
  auto Add = [&](std::string Name, const ProfileCounts &Counts,
                 const MemoryBehaviour &Memory) {
    ProfileRow &Row = ByName[Name];
    Row.Name = std::move(Name);
    Row.Counts += Counts;
    Row.Memory += Memory;
  };
  if (Rows == ProfileRows::Path) {
    StackTree Tree(Data);
    for (auto [I, Node] : enumerate(Tree.nodes()))
      if (Node.Self != ProfileCounts())
        Add(pathName(Data, Tree, uint32_t(I)), Node.Self, Node.Memory);
  } else {
    for (const ProfileInstruction &Instruction : Data.Instructions)
      Add(rowName(Data, Instruction, Rows), Instruction.Counts,
          Instruction.Memory);
  }
  std::vector<ProfileRow> Result;
  Result.reserve(ByName.size());
  for (auto &[Name, Row] : ByName)
    Result.push_back(std::move(Row));
  std::ranges::sort(Result, [&](const ProfileRow &A, const ProfileRow &B) {
    uint64_t KeyA = keyOf(A, Order), KeyB = keyOf(B, Order);
    return KeyA != KeyB ? KeyA > KeyB : A.Name < B.Name;
  });
  return Result;
}

namespace {

/// A column with how many of the accesses that came to some levels the first of
/// them served.
struct HitRate {
  const char *Title;
  const char *Meaning;
  ServedBy First;
  ServedBy Last;

  uint64_t hits(const MemoryBehaviour &Memory) const {
    return Memory.Served[unsigned(First)].Accesses;
  }
  uint64_t all(const MemoryBehaviour &Memory) const {
    return servedBetween(Memory, First, Last).Accesses;
  }
};

constexpr HitRate HitRates[] = {
    {"l1", "percent of them that the L1 served", ServedBy::L1,
     ServedBy::Memory},
    {"l2", "percent of the rest that the L2 served", ServedBy::L2,
     ServedBy::Memory},
    {"row", "percent of those from DRAM whose row was open",
     ServedBy::DramRowHit, ServedBy::DramRowConflict},
};

class TableWriter {
public:
  /// \p Memory is that of the whole run.
  TableWriter(const Profile &Data, const MemoryBehaviour &Memory,
              raw_ostream &OS)
      : Whole(std::max<uint64_t>(Data.Run.threadCycles(), 1)), OS(OS) {
    copy_if(HitRates, std::back_inserter(Rates), [&](const HitRate &Rate) {
      return isDram(Rate.First) ? Rate.all(Memory) : Rate.hits(Memory);
    });
  }

  void writeHead() {
    OS << "access is the mean of cycles from issue to answer of global "
          "accesses";
    for (const HitRate &Rate : Rates)
      OS << ";\n" << Rate.Title << " is the " << Rate.Meaning;
    OS << "\n\ncycles  issued    data  memory  units  fetch   wait  access";
    for (const HitRate &Rate : Rates)
      OS << right_justify(Rate.Title, RateWidth);
    OS << "  in\n";
  }

  void write(const ProfileRow &Row) {
    const LossCounts &Lost = Row.Counts.Lost;
    auto Sum = [&](std::initializer_list<Loss> Reasons) {
      uint64_t Cycles = 0;
      for (Loss Reason : Reasons)
        Cycles += Lost[unsigned(Reason)];
      return Cycles;
    };
    share(Row.Counts.cycles(), 6);
    share(Row.Counts.Instructions, 8);
    share(Sum({Loss::Data}), 8);
    share(Row.Counts.memoryWaits(), 8);
    share(Sum({Loss::UnitConflict}), 7);
    share(Sum({Loss::IcacheConflict, Loss::IcacheMiss, Loss::Branch}), 7);
    share(Sum({Loss::Barrier, Loss::Sync, Loss::Sleep}), 7);
    writeLatency(Row.Memory);
    for (const HitRate &Rate : Rates)
      writeRate(Rate.hits(Row.Memory), Rate.all(Row.Memory));
    // A path may be very long; its inner end tells most.
    constexpr size_t MaxName = 80;
    bool IsCut = Row.Name.size() > MaxName;
    OS << "  " << StringRef(Row.Name).take_front(MaxName)
       << (IsCut ? "...\n" : "\n");
  }

private:
  /// In percent of the thread-cycles; nothing for nothing.
  void share(uint64_t Cycles, unsigned Width) {
    std::string Text;
    if (Cycles != 0) {
      double Percent = 100.0 * double(Cycles) / double(Whole);
      Text = Percent < 0.05 ? "<0.1" : formatv("{0:F1}", Percent).str();
    }
    OS << right_justify(Text, Width);
  }

  /// Cycles of a global access, from its issue to its answer.
  void writeLatency(const MemoryBehaviour &Memory) {
    ServedAccesses All = allServed(Memory);
    std::string Text;
    if (All.Accesses != 0)
      Text = formatv("{0:F0}", double(All.Cycles) / double(All.Accesses));
    OS << right_justify(Text, 8);
  }

  void writeRate(uint64_t Hits, uint64_t All) {
    std::string Text;
    if (All != 0)
      Text = formatv("{0:F0}", 100 * double(Hits) / double(All));
    OS << right_justify(Text, RateWidth);
  }

  static constexpr unsigned RateWidth = 5;

  const uint64_t Whole;
  /// Those of levels that the run has used.
  SmallVector<HitRate, std::size(HitRates)> Rates;
  raw_ostream &OS;
};

} // namespace

void writeProfileTable(const Profile &Data, const ProfileTableOptions &Options,
                       raw_ostream &OS) {
  std::vector<ProfileRow> Rows = profileRows(Data, Options.Rows, Options.Order);
  OS << "profile: percent of " << grouped(Data.Run.threadCycles())
     << " thread-cycles (" << Data.Run.threads() << " threads x "
     << grouped(Data.Run.Cycles) << " cycles);\n";
  MemoryBehaviour Memory;
  for (const ProfileRow &Row : Rows)
    Memory += Row.Memory;
  TableWriter Table(Data, Memory, OS);
  Table.writeHead();
  size_t Shown = std::min(Rows.size(), Options.MaxRows);
  for (const ProfileRow &Row : ArrayRef(Rows).take_front(Shown))
    Table.write(Row);
  ProfileRow Rest;
  for (const ProfileRow &Row : ArrayRef(Rows).drop_front(Shown)) {
    Rest.Counts += Row.Counts;
    Rest.Memory += Row.Memory;
  }
  Rest.Name = formatv("({0} more)", Rows.size() - Shown);
  if (Rows.size() != Shown)
    Table.write(Rest);
  ProfileRow Finished;
  Finished.Name = "(threads that had finished)";
  Finished.Counts.Lost[unsigned(Loss::Finished)] = Data.Run.Finished;
  if (Data.Run.Finished != 0)
    Table.write(Finished);
}

} // namespace tp
