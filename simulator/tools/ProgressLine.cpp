//===- ProgressLine.cpp - How far a run is, on a terminal -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ProgressLine.h"

#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/Process.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp {

/// Seconds as `4 s`, `3 min 20 s` or `2 h 5 min`.
static std::string duration(double Seconds) {
  uint64_t Whole = uint64_t(Seconds + 0.5);
  if (Whole < 60)
    return formatv("{0} s", Whole);
  if (Whole < 3600)
    return formatv("{0} min {1} s", Whole / 60, Whole % 60);
  return formatv("{0} h {1} min", Whole / 3600, Whole / 60 % 60);
}

std::string progressText(const ProgressPoint &Start, const ProgressPoint &Now,
                         double Seconds) {
  uint64_t Instructions = Now.Counts.Instructions - Start.Counts.Instructions;
  std::string Text;
  if (Now.Counts.Cycles != 0)
    Text = formatv("cycle {0:N}, ", Now.Counts.Cycles);
  Text += formatv("{0:F1} million thread-instructions/s",
                  Seconds > 0 ? Instructions / Seconds / 1e6 : 0);
  if (!Now.Share)
    return Text +
           formatv(", {0:N} threads halted", Now.Counts.HaltedThreads).str();
  Text += formatv(", {0:F1} % done", *Now.Share * 100);
  double Done = *Now.Share - Start.Share.value_or(0);
  if (Done > 0)
    Text += ", " + duration(Seconds * (1 - *Now.Share) / Done) + " left";
  return Text;
}

ProgressLine::ProgressLine(bool Enabled)
    : Enabled(Enabled && sys::Process::StandardErrIsDisplayed()),
      Start(std::chrono::steady_clock::now()) {}

void ProgressLine::update(const Progress &Now, std::optional<double> Share) {
  if (!Enabled)
    return;
  errs() << "\r\033[K" << progressText(First, {Now, Share}, seconds());
  errs().flush();
  Visible = true;
}

void ProgressLine::clear() {
  if (!Visible)
    return;
  errs() << "\r\033[K";
  Visible = false;
}

double ProgressLine::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - Start)
      .count();
}

} // namespace tp
