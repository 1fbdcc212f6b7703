//===- Report.cpp - What a checker has found ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/Report.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/WithColor.h"

using namespace llvm;

namespace tp {

/// More reports than this help nobody.
static constexpr size_t MaxWritten = 1000;

Reports::Reports(const ElfProgram &Program, const ChipConfig &Chip,
                 const Suppressions &Suppressed, raw_ostream &OS)
    : Chip(Chip), Suppressed(Suppressed), OS(OS), Symbols(Program) {}

const std::vector<SourceFrame> &Reports::frames(uint32_t Pc) {
  auto [Known, IsNew] = FramesOf.try_emplace(Pc);
  if (IsNew)
    Known->second = Symbols.frames(Pc);
  return Known->second;
}

bool Reports::isSuppressed(const Report &R) {
  if (Suppressed.isEmpty())
    return false;
  for (const ReportSide &Side : R.Sides)
    for (uint32_t Pc : Side.Stack)
      for (const SourceFrame &Frame : frames(Pc))
        if (Suppressed.covers(R.Check, Frame.Function))
          return true;
  return false;
}

std::string Reports::causeOf(const Report &R) {
  std::string Cause = R.Kind;
  if (!R.Cause.empty())
    return Cause + '|' + R.Cause;
  raw_string_ostream OS(Cause);
  for (const ReportSide &Side : R.Sides) {
    OS << '|' << Side.What << '|';
    if (Side.Stack.empty())
      continue;
    const std::vector<SourceFrame> &Places = frames(Side.Stack.front());
    if (Places.empty())
      OS << Side.Stack.front();
    else
      OS << Symbolizer::describe(Places.front());
  }
  return Cause;
}

void Reports::add(const Report &R) {
  const std::string Cause = causeOf(R);
  if (isSuppressed(R)) {
    SuppressedCauses.insert(Cause);
    return;
  }
  if (Written >= MaxWritten || !Causes.insert(Cause).second)
    return;
  ++Written;
  write(R);
  Kept.push_back(json(R));
}

void Reports::write(const Report &R) {
  WithColor::error(OS, "tpsim") << R.Kind << ": " << R.Title;
  if (R.Address)
    OS << " at " << format_hex(*R.Address, 10);
  OS << '\n';
  if (!R.Object.empty())
    OS << "  " << R.Object << '\n';
  for (const ReportSide &Side : R.Sides)
    writeSide(Side);
  if (Written == MaxWritten)
    OS << "  further reports are left out\n";
  OS.flush();
}

void Reports::writeSide(const ReportSide &Side) {
  OS << "  " << Side.What;
  if (Side.Thread)
    OS << " by thread " << *Side.Thread << " (TM "
       << *Side.Thread / Chip.TpsPerTm << ", TP "
       << *Side.Thread % Chip.TpsPerTm << ')';
  OS << '\n';
  // Of an endless recursion the ends say all.
  constexpr size_t MaxInner = 16, MaxOuter = 4;
  ArrayRef<uint32_t> Stack = Side.Stack;
  unsigned Number = 0;
  if (Stack.size() <= MaxInner + MaxOuter)
    return writeStack(Stack, Number);
  writeStack(Stack.take_front(MaxInner), Number);
  OS << "    ... " << Stack.size() - MaxInner - MaxOuter
     << " calls are left out\n";
  Number += unsigned(Stack.size() - MaxInner - MaxOuter);
  writeStack(Stack.take_back(MaxOuter), Number);
}

void Reports::writeStack(ArrayRef<uint32_t> Stack, unsigned &Number) {
  for (uint32_t Pc : Stack) {
    const std::vector<SourceFrame> &Places = frames(Pc);
    for (const SourceFrame &Place : Places)
      OS << "    #" << Number++ << ' ' << Symbolizer::describe(Place) << '\n';
    if (Places.empty())
      OS << "    #" << Number++ << " pc " << format_hex(Pc, 10) << '\n';
  }
}

void Reports::writeSummary() const {
  if (Written == 0 && suppressed() == 0)
    return;
  OS << "tpsim: checks: " << Written << (Written == 1 ? " fault" : " faults");
  if (suppressed() != 0)
    OS << ", " << suppressed() << " suppressed";
  OS << '\n';
}

json::Value Reports::json(const Report &R) {
  json::Array Sides;
  for (const ReportSide &Side : R.Sides) {
    json::Array Stack;
    for (uint32_t Pc : Side.Stack) {
      json::Array Places;
      for (const SourceFrame &Place : frames(Pc))
        Places.push_back(json::Object{{"function", Place.Function},
                                      {"file", Place.File},
                                      {"line", Place.Line},
                                      {"column", Place.Column}});
      Stack.push_back(json::Object{{"pc", Pc}, {"frames", std::move(Places)}});
    }
    json::Object Entry{{"what", Side.What}, {"stack", std::move(Stack)}};
    if (const std::optional<uint32_t> Thread = Side.Thread)
      Entry["thread"] = *Thread;
    Sides.push_back(std::move(Entry));
  }
  json::Object Entry{{"check", R.Check},
                     {"kind", R.Kind},
                     {"title", R.Title},
                     {"sides", std::move(Sides)}};
  if (!R.Object.empty())
    Entry["object"] = R.Object;
  if (R.Address) {
    Entry["address"] = *R.Address;
    Entry["bytes"] = R.Bytes;
  }
  return Entry;
}

json::Value Reports::json() const {
  return json::Object{{"version", 1},
                      {"faults", json::Array(Kept)},
                      {"suppressed", uint64_t(suppressed())}};
}

} // namespace tp
