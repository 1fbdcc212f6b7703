//===- StackTree.cpp - Cycles by chain of calls ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/StackTree.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/STLExtras.h"

#include <algorithm>
#include <cassert>

using namespace llvm;

namespace tp {

namespace {

/// Shares counts out in proportion to weights; the shares of a count add up to
/// it.
class Shares {
public:
  explicit Shares(ArrayRef<uint64_t> Weights) : UpTo(1) {
    for (uint64_t Weight : Weights)
      UpTo.push_back(UpTo.back() + Weight);
  }

  /// The share of \p Count that has this number. Without any weight the first
  /// has all.
  uint64_t of(uint64_t Count, size_t Number) const {
    if (UpTo.back() == 0)
      return Number == 0 ? Count : 0;
    return before(Count, Number + 1) - before(Count, Number);
  }

private:
  /// Of \p Count the shares before one.
  uint64_t before(uint64_t Count, size_t Number) const {
    return uint64_t(static_cast<unsigned __int128>(Count) * UpTo[Number] /
                    UpTo.back());
  }

  /// Sums of the weights before each, and of all.
  std::vector<uint64_t> UpTo;
};

} // namespace

StackTree::StackTree(const Profile &Data) : Data(Data) {
  addCalls();
  for (const ProfileInstruction &Instruction : Data.Instructions)
    addInstruction(Instruction);
}

std::vector<uint32_t> StackTree::functionsOf(uint32_t Node) const {
  std::vector<uint32_t> Functions = {Nodes[Node].Function};
  for (std::optional<uint32_t> Outer = Nodes[Node].Outer; Outer;
       Outer = Nodes[*Outer].Outer)
    Functions.push_back(Nodes[*Outer].Function);
  std::ranges::reverse(Functions);
  return Functions;
}

uint32_t StackTree::child(std::optional<uint32_t> Outer, uint32_t Function) {
  auto [Known, IsNew] =
      Children.try_emplace({Outer, Function}, uint32_t(Nodes.size()));
  if (IsNew)
    Nodes.push_back({Function, Outer, {}, {}});
  return Known->second;
}

uint32_t StackTree::nodeOf(std::optional<uint32_t> Base, uint32_t Frame) {
  std::vector<uint32_t> Chain = Data.framesFrom(Frame);
  for (uint32_t Place : reverse(Chain))
    Base = child(Base, Data.Frames[Place].Function);
  assert(Base && "a chain has a frame");
  return *Base;
}

void StackTree::addCalls() {
  for (auto [I, Call] : enumerate(Data.Calls)) {
    CallsOf[Call.Function].push_back(uint32_t(I));
    std::optional<uint32_t> Base;
    if (Call.Caller && Call.CallSite)
      Base =
          nodeOf(Bases[*Call.Caller], Data.Instructions[*Call.CallSite].Frame);
    Bases.push_back(Base);
  }
}

void StackTree::addInstruction(const ProfileInstruction &Instruction) {
  uint32_t Outermost = Data.framesFrom(Instruction.Frame).back();
  const std::vector<uint32_t> &Calls = CallsOf[Data.Frames[Outermost].Function];
  if (Calls.empty()) {
    StackNode &Node = Nodes[nodeOf(std::nullopt, Instruction.Frame)];
    Node.Self += Instruction.Counts;
    Node.Memory += Instruction.Memory;
    return;
  }
  auto SharesBy = [&](function_ref<uint64_t(const ProfileCounts &)> Weight) {
    std::vector<uint64_t> Weights;
    Weights.reserve(Calls.size());
    for (uint32_t Call : Calls)
      Weights.push_back(Weight(Data.Calls[Call].Self));
    return Shares(Weights);
  };
  Shares Issued =
      SharesBy([](const ProfileCounts &Counts) { return Counts.Instructions; });
  std::vector<StackNode> Parts(Calls.size());
  for (size_t I = 0; I != Calls.size(); ++I) {
    Parts[I].Self.Instructions = Issued.of(Instruction.Counts.Instructions, I);
    Parts[I].Memory.Global = Issued.of(Instruction.Memory.Global, I);
    for (auto [Part, Whole] :
         zip(Parts[I].Memory.Served, Instruction.Memory.Served))
      Part = {Issued.of(Whole.Accesses, I), Issued.of(Whole.Cycles, I)};
  }
  for (unsigned Reason = 0; Reason != NumLosses; ++Reason) {
    if (Instruction.Counts.Lost[Reason] == 0)
      continue;
    Shares Lost = SharesBy(
        [&](const ProfileCounts &Counts) { return Counts.Lost[Reason]; });
    for (size_t I = 0; I != Calls.size(); ++I)
      Parts[I].Self.Lost[Reason] = Lost.of(Instruction.Counts.Lost[Reason], I);
  }
  for (auto [Call, Part] : zip(Calls, Parts)) {
    StackNode &Node = Nodes[nodeOf(Bases[Call], Instruction.Frame)];
    Node.Self += Part.Self;
    Node.Memory += Part.Memory;
  }
}

} // namespace tp
