//===- JobPlan.cpp - What the jobs of a compilation make ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/JobPlan.h"
#include "clang/Driver/InputInfo.h"

using namespace clang::driver;
using namespace llvm;

namespace tp {

JobPlan::JobPlan(const Compilation &Jobs, bool IsWholeProgram) {
  if (!IsWholeProgram)
    return;
  for (const Command &Job : Jobs.getJobs())
    if (isa<LinkJobAction>(Job.getSource()))
      for (const InputInfo &Input : Job.getInputInfos())
        if (const Action *Maker = Input.getAction())
          addUnit(*Maker, Jobs.getJobs());
}

static const Command *findCommand(const Action &Source, const JobList &Jobs) {
  for (const Command &Job : Jobs)
    if (&Job.getSource() == &Source)
      return &Job;
  return nullptr;
}

// Compilation, code generation and assembly are one job, or three.
void JobPlan::addUnit(const Action &Assembly, const JobList &Jobs) {
  if (!isa<AssembleJobAction>(Assembly) ||
      !isa<BackendJobAction>(Assembly.getInputs().front()))
    return;
  const Action &CodeGeneration = *Assembly.getInputs().front();
  const Action &Compilation = *CodeGeneration.getInputs().front();
  const Command *Last = findCommand(Assembly, Jobs);
  if (const Command *First = findCommand(Compilation, Jobs)) {
    Units.insert(First);
    Dropped.insert(findCommand(CodeGeneration, Jobs));
    Dropped.insert(Last);
    Replacements[Last->getOutputFilenames().front()] =
        First->getOutputFilenames().front();
    return;
  }
  Units.insert(Last);
}

} // namespace tp
