//===- ComparedRun.cpp - What is compared of a run ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/ComparedRun.h"

#include "simulator/compare/RunReader.h"
#include "simulator/profile/ProfileNames.h"

#include "llvm/Support/MemoryBuffer.h"

using namespace llvm;

namespace tp {

bool readLost(const json::Value &Json, CycleCounts &Counts, json::Path Path) {
  const json::Object *Object = Json.getAsObject();
  if (!Object) {
    Path.report("expected object");
    return false;
  }
  for (const auto &[Name, Value] : *Object) {
    std::optional<Loss> Reason = findLoss(Name);
    if (!Reason) {
      Path.field(Name).report("no reason that this tpsim knows");
      return false;
    }
    if (!json::fromJSON(Value, Counts[useOf(*Reason)], Path.field(Name)))
      return false;
  }
  return true;
}

static Error inconsistent(const std::string &Path, const Twine &What) {
  return createStringError(Path + ": " + What +
                           "; the file is not as tpsim wrote it");
}

/// Holds the sums of \p Run against each other.
static Error checkSums(const ComparedRun &Run) {
  if (Run.HasCycles && sumOf(Run.Counts) != int64_t(Run.threads() * Run.Cycles))
    return inconsistent(Run.Path, Twine(sumOf(Run.Counts)) +
                                      " thread-cycles by reason "
                                      "for " +
                                      Twine(Run.threads()) + " threads and " +
                                      Twine(Run.Cycles) + " cycles");
  if (!Run.Lines)
    return Error::success();
  CycleCounts ByLine{};
  for (const auto &[Line, Counts] : *Run.Lines)
    add(ByLine, Counts);
  ByLine[useOf(Loss::Finished)] += Run.Counts[useOf(Loss::Finished)];
  for (unsigned Use = 0; Use != NumCycleUses; ++Use)
    if (ByLine[Use] != Run.Counts[Use])
      return inconsistent(Run.Path, Twine(Run.Counts[Use]) +
                                        " thread-cycles '" + cycleUseName(Use) +
                                        "', but by address " +
                                        Twine(ByLine[Use]));
  return Error::success();
}

static Expected<ComparedRun> readStatisticsRun(const json::Value &Json,
                                               StringRef Name) {
  ComparedRun Run;
  json::Path::Root Root(Name);
  if (readStatistics(Json, Run, Root))
    return Run;
  return createStringError(
      toString(Root.getError()) +
      "; expected what tpsim of this version writes by --stats or --profile");
}

Expected<ComparedRun> readComparedRun(const std::string &Path, StringRef Text) {
  Expected<json::Value> Json = json::parse(Text);
  if (!Json)
    return createStringError(Path +
                             ": not JSON: " + toString(Json.takeError()));
  const json::Object *Object = Json->getAsObject();
  Expected<ComparedRun> Run = Object && Object->get("frames")
                                  ? readProfileRun(Text, Path)
                                  : readStatisticsRun(*Json, Path);
  if (!Run)
    return Run.takeError();
  Run->Path = Path;
  if (Error E = checkSums(*Run))
    return std::move(E);
  return Run;
}

Expected<ComparedRun> loadComparedRun(const std::string &Path) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> File = MemoryBuffer::getFile(Path);
  if (!File)
    return createStringError("cannot read " + Path + ": " +
                             File.getError().message());
  return readComparedRun(Path, (*File)->getBuffer());
}

} // namespace tp
