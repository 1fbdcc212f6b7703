//===- RunProgress.cpp - Tells a client how far a run is ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/RunProgress.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp::dap {

/// Before the first event of a run, and between two.
constexpr std::chrono::seconds Patience(1);

void RunProgress::begin(StringRef RunTitle, bool Wanted) {
  Title = RunTitle.str();
  IsWanted = Wanted;
  IsShown = false;
  Told = Clock::now();
  ++Number;
}

json::Object RunProgress::body() const {
  return json::Object{{"progressId", "run" + utostr(Number)}};
}

void RunProgress::update(const Progress &Now) {
  if (!IsWanted || Clock::now() - Told < Patience)
    return;
  Told = Clock::now();
  json::Object Body = body();
  Body["message"] = "cycle " + utostr(Now.Cycles) + ", " +
                    utostr(Now.Instructions) + " instructions";
  if (!IsShown)
    Body["title"] = Title;
  Out.event(IsShown ? "progressUpdate" : "progressStart", std::move(Body));
  IsShown = true;
}

void RunProgress::end() {
  if (IsShown)
    Out.event("progressEnd", body());
  IsWanted = IsShown = false;
}

} // namespace tp::dap
