//===- ProfileNames.cpp - Names of what a profile counts ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileNames.h"

#include "simulator/stats/RunSummary.h"

#include "llvm/Support/ErrorHandling.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp {

const char *levelName(ServedBy Level) {
  switch (Level) {
  case ServedBy::L1:
    return "l1";
  case ServedBy::L2:
    return "l2";
  case ServedBy::DramQueue:
    return "dram_queue";
  case ServedBy::DramRowHit:
    return "dram_row_hit";
  case ServedBy::DramRowMiss:
    return "dram_row_miss";
  case ServedBy::DramRowConflict:
    return "dram_row_conflict";
  case ServedBy::Memory:
    return "memory";
  }
  llvm_unreachable("every level has a name");
}

std::optional<ServedBy> findLevel(StringRef Name) {
  for (unsigned I = 0; I != NumServedBy; ++I)
    if (Name == levelName(ServedBy(I)))
      return ServedBy(I);
  return std::nullopt;
}

std::optional<Loss> findLoss(StringRef Name) {
  for (unsigned I = 0; I != NumLosses; ++I)
    if (Name == lossName(Loss(I)))
      return Loss(I);
  return std::nullopt;
}

std::string nameOf(const ProfileFunction &Function) {
  if (!Function.Name.empty())
    return Function.Name;
  return "(no symbol)";
}

/// Without the type of the result, which names of templates begin with.
static std::string withoutResult(StringRef Name) {
  StringRef Rest = Name.rsplit(' ').second;
  return (Rest.empty() ? Name : Rest).str();
}

std::string shortName(StringRef Name) {
  std::string Short;
  unsigned Depth = 0;
  for (size_t I = 0; I != Name.size(); ++I) {
    // Not what brackets anything: `operator<`, `operator()`, `->`.
    if (Depth == 0 && Name.substr(I).starts_with("operator")) {
      StringRef Operator = Name.substr(I);
      size_t Begin = Operator.starts_with("operator()") ? 10 : 8;
      return withoutResult(Short) +
             Operator.take_front(Operator.find('(', Begin)).str();
    }
    if (Depth == 0 && Name.substr(I).starts_with("(anonymous namespace)")) {
      I += sizeof("(anonymous namespace)") - 2;
      Short += "(anonymous)";
      continue;
    }
    if (Name[I] == '(' || Name[I] == '<')
      ++Depth;
    else if (Name[I] == ')' || Name[I] == '>')
      Depth -= Depth != 0;
    else if (Depth == 0)
      Short += Name[I];
    if (Depth == 0 && Name[I] == ')')
      break;
  }
  return withoutResult(Short);
}

std::string placeOf(const Profile &Data, const ProfileFrame &Frame) {
  if (!Frame.File)
    return "";
  StringRef File = sys::path::filename(Data.Files[*Frame.File].Path);
  return File.str() + ":" +
         (Frame.Line ? std::to_string(Frame.Line) : std::string("?"));
}

} // namespace tp
