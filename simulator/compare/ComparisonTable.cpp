//===- ComparisonTable.cpp - What changed between two runs, for people ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/Comparison.h"
#include "simulator/stats/TableText.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallVector.h"
#include "llvm/Support/Format.h"

#include <cmath>

using namespace llvm;

namespace tp {

static std::string groupedSigned(int64_t Value) {
  return (Value < 0 ? "-" : "") +
         grouped(Value < 0 ? uint64_t(-Value) : uint64_t(Value));
}

/// With a few digits that matter.
static std::string numberText(double Value) {
  constexpr double Large = 1000;
  if (std::abs(Value) >= Large)
    return groupedSigned(std::llround(Value));
  std::string Text;
  raw_string_ostream(Text) << format("%.4g", Value);
  return Text;
}

/// With a sign also if it is more.
static std::string changeText(int64_t Change) {
  return (Change > 0 ? "+" : "") + groupedSigned(Change);
}

/// \p Change as a share of \p Whole, with its sign.
static std::string changeOf(double Change, double Whole) {
  if (Change == 0)
    return "";
  if (Whole == 0)
    return "new";
  double Share = Change / Whole;
  if (std::abs(Share) >= 10)
    return formatv("{0:F0} x", Share + 1).str();
  std::string Text = percent(std::abs(Share));
  return StringRef(Text).starts_with("<") ? Text
                                          : (Share < 0 ? "-" : "+") + Text;
}

namespace {

class TableWriter {
public:
  TableWriter(const Comparison &Runs, unsigned Rows, raw_ostream &OS)
      : Runs(Runs), Rows(Rows), OS(OS),
        Whole(double(sumOf(Runs.Counts.Before))) {}

  void write() {
    writeRun("before", Runs.Before);
    writeRun("after", Runs.After);
    OS << '\n';
    writeFigures();
    writeUses();
    writePlaces("function", Runs.Functions);
    writePlaces("line", Runs.Lines);
    if (!Runs.HasPlaces)
      OS << "no lines: both files must be profiles, or statistics with "
            "--per-pc\n\n";
    writeOpcodes();
  }

private:
  const Comparison &Runs;
  const unsigned Rows;
  raw_ostream &OS;
  /// What changes are shown as a share of.
  const double Whole;

  void writeRun(const char *Name, const ComparedRun &Run) {
    OS << formatv("{0,-8}{1}: {2}, {3} TMs x {4} TPs, {5}\n", Name, Run.Path,
                  Run.Chip, Run.TmCount, Run.TpsPerTm,
                  Run.Outcome == "finished" ? "finished"
                                            : "ended early: " + Run.Outcome);
  }

  void heading(StringRef Name) { row(Name, "before", "after", "change", ""); }

  void row(StringRef Name, StringRef Before, StringRef After, StringRef Change,
           StringRef Share) {
    std::string Line = formatv("{0,-20} {1,15} {2,15} {3,15} {4,8}", Name,
                               Before, After, Change, Share);
    OS << StringRef(Line).rtrim() << '\n';
  }

  void countRow(StringRef Name, int64_t Before, int64_t After, double Of) {
    row(Name, groupedSigned(Before), groupedSigned(After),
        changeText(After - Before), changeOf(double(After - Before), Of));
  }

  void writeFigures() {
    heading("");
    if (Runs.Before.HasCycles)
      countRow("cycles", int64_t(Runs.Before.Cycles),
               int64_t(Runs.After.Cycles), double(Runs.Before.Cycles));
    countRow("instructions", Runs.Counts.Before[0], Runs.Counts.After[0],
             double(Runs.Counts.Before[0]));
    for (const Figure &Before : Runs.Before.Figures)
      for (const Figure &After : Runs.After.Figures)
        if (Before.Name == After.Name)
          writeFigure(Before, After);
    OS << '\n';
  }

  void writeFigure(const Figure &Before, const Figure &After) {
    double Change = After.Value - Before.Value;
    switch (Before.Is) {
    case Figure::Count:
      return countRow(Before.Name, int64_t(Before.Value), int64_t(After.Value),
                      Before.Value);
    case Figure::Share:
      return row(
          Before.Name, percent(Before.Value), percent(After.Value),
          formatv("{0}{1:F1} points", Change > 0 ? "+" : "", Change * 100)
              .str(),
          "");
    case Figure::Number:
      return row(Before.Name, numberText(Before.Value), numberText(After.Value),
                 (Change > 0 ? "+" : "") + numberText(Change),
                 changeOf(Change, Before.Value));
    }
  }

  void writeUses() {
    if (!Runs.Before.HasCycles)
      return;
    heading("thread-cycles");
    for (unsigned Use = 0; Use != NumCycleUses; ++Use)
      if (Runs.Counts.Before[Use] || Runs.Counts.After[Use])
        countRow(cycleUseName(Use), Runs.Counts.Before[Use],
                 Runs.Counts.After[Use], Whole);
    countRow("all", sumOf(Runs.Counts.Before), sumOf(Runs.Counts.After), Whole);
    OS << "(shares are of all thread-cycles before)\n\n";
  }

  /// The uses with the largest changes, largest first.
  std::string mostly(const ComparedCounts &Counts) {
    constexpr size_t Shown = 3;
    SmallVector<unsigned, NumCycleUses> Uses;
    for (unsigned Use = 0; Use != NumCycleUses; ++Use)
      if (Counts.change(Use) != 0)
        Uses.push_back(Use);
    sort(Uses, [&](unsigned A, unsigned B) {
      int64_t First = std::abs(Counts.change(A));
      int64_t Second = std::abs(Counts.change(B));
      return First != Second ? First > Second : A < B;
    });
    std::string Text;
    for (unsigned Use : ArrayRef(Uses).take_front(Shown))
      Text += formatv("{0}{1} {2}", Text.empty() ? "" : ", ", cycleUseName(Use),
                      changeText(Counts.change(Use)));
    return Text;
  }

  void placeRow(const ComparedCounts &Counts, StringRef Name) {
    std::string Mostly = Runs.Before.HasCycles ? mostly(Counts) : "";
    OS << formatv("{0,15} {1,15} {2,15} {3,8}  {4}\n",
                  groupedSigned(sumOf(Counts.Before)),
                  groupedSigned(sumOf(Counts.After)),
                  changeText(Counts.change()),
                  changeOf(double(Counts.change()), Whole), Name);
    if (!Mostly.empty())
      OS << formatv("{0,60}{1}\n", "", Mostly);
  }

  static std::string nameOf(const SourceLine &Place) {
    std::string Name;
    if (Place.Line != 0)
      Name = formatv("{0}:{1}", Place.File, Place.Line);
    if (!Place.Function.empty())
      Name += (Name.empty() ? "" : " ") + Place.Function;
    constexpr size_t Longest = 72;
    if (Name.size() > Longest)
      Name = Name.substr(0, Longest - 3) + "...";
    return Name.empty() ? "(unknown)" : Name;
  }

  void writePlaces(StringRef Kind, ArrayRef<ComparedPlace> Places) {
    if (!Runs.HasPlaces)
      return;
    OS << formatv("{0,15} {1,15} {2,15} {3,8}  by {4}\n", "before", "after",
                  "change", "", Kind);
    ComparedCounts Others;
    size_t NumOthers = 0, NumShown = 0;
    for (const ComparedPlace &Place : Places) {
      if (NumShown != Rows && Place.Counts.Before != Place.Counts.After) {
        placeRow(Place.Counts, nameOf(Place.Name));
        ++NumShown;
        continue;
      }
      add(Others.Before, Place.Counts.Before);
      add(Others.After, Place.Counts.After);
      ++NumOthers;
    }
    if (NumOthers != 0)
      placeRow(Others, formatv("({0} others)", NumOthers).str());
    constexpr unsigned Finished = useOf(Loss::Finished);
    ComparedCounts Halted;
    Halted.Before[Finished] = Runs.Counts.Before[Finished];
    Halted.After[Finished] = Runs.Counts.After[Finished];
    if (Halted != ComparedCounts())
      placeRow(Halted, "(halted threads)");
    placeRow(Runs.Counts, "(all)");
    OS << '\n';
  }

  void writeOpcodes() {
    heading("instructions");
    ComparedOpcode Others;
    size_t NumOthers = 0, NumShown = 0;
    for (const ComparedOpcode &Opcode : Runs.Opcodes) {
      if (NumShown != Rows && Opcode.change() != 0) {
        countRow(Opcode.Name, Opcode.Before, Opcode.After,
                 double(Opcode.Before));
        ++NumShown;
        continue;
      }
      Others.Before += Opcode.Before;
      Others.After += Opcode.After;
      ++NumOthers;
    }
    if (NumOthers != 0)
      countRow(formatv("({0} others)", NumOthers).str(), Others.Before,
               Others.After, double(Others.Before));
    countRow("all", Runs.Counts.Before[0], Runs.Counts.After[0],
             double(Runs.Counts.Before[0]));
  }
};

} // namespace

void writeTable(const Comparison &Runs, unsigned Rows, raw_ostream &OS) {
  TableWriter(Runs, Rows, OS).write();
}

} // namespace tp
