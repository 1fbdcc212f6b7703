//===- BatchCompiler.cpp - Compiles segments ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/BatchCompiler.h"

#include "simulator/jit/BodyLibrary.h"

using namespace llvm;

namespace tp {

Expected<Batch> BatchCompiler::compile(std::span<const Segment> Segments) {
  auto Context = std::make_unique<LLVMContext>();
  Expected<std::unique_ptr<Module>> M = cycleSteps().instantiate(*Context);
  if (!M)
    return M.takeError();
  Batch Result;
  std::vector<std::string> Names;
  for (const Segment &Steps : Segments) {
    Names.push_back("segment" + std::to_string(Steps.front().Word));
    Result.Counts.push_back(
        addSegment(**M, Names.back(), Subject, Steps, NumCounts));
    NumCounts += Result.Counts.back().Exits.size();
  }
  optimize(**M, [this](Function &F) { foldConstants(F, Subject); });
  Expected<std::vector<const void *>> Entries =
      Session->compile(std::move(*M), std::move(Context), Names);
  if (!Entries)
    return Entries.takeError();
  for (size_t I = 0; I != Segments.size(); ++I)
    Result.Handlers.push_back({Segments[I].front().Word, (*Entries)[I]});
  return Result;
}

} // namespace tp
