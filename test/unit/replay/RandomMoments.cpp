//===- RandomMoments.cpp - Goes back to random moments of a kernel --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// tp-random-moments COUNT SEED OPTIONS-OF-TPSIM: continues a program backward
// to breakpoints at random places, and compares where it lands with an engine
// that runs from the start to there and knows no replay: registers, both
// memories, the counts of each instruction and the losses of each thread. With
// --functional, moments are numbers of instructions.
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/ChipSelection.h"
#include "simulator/tools/RunSetup.h"
#include "test/unit/oracle/RandomProgram.h"
#include "test/unit/replay/State.h"

#include "llvm/Support/raw_ostream.h"

#include <cstring>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

/// A program with its memory as it was loaded.
struct Subject {
  ChipConfig Chip;
  std::unique_ptr<RunSetup> Setup;
  std::vector<uint8_t> Loaded;

  bool IsFunctional;

  State stateAt(uint64_t Time) const {
    Memory Global(Chip.MemoryBytes);
    std::memcpy(Global.data(), Loaded.data(), Loaded.size());
    if (IsFunctional) {
      FunctionalMachine Machine(Chip, Setup->Text, Global);
      FunctionalLimits Limits;
      Limits.PauseBefore = Time;
      Machine.run(Limits);
      return stateOf(Machine, Chip, Global);
    }
    Engine Machine(Chip, Setup->Text, Global, makeMemorySystem(Chip));
    RunLimits Limits;
    Limits.MaxCycles = Time;
    Machine.run(Limits);
    return stateOf(Machine, Chip, Setup->Text, Global);
  }
  std::unique_ptr<Replay> makeReplay(std::string &Problem) {
    auto Make = IsFunctional ? makeFunctionalReplay : makeCycleReplay;
    return Make(Chip, Setup->Text, Setup->Global, {}, Problem);
  }
};

} // namespace

static Expected<Subject> load(ArrayRef<const char *> Arguments,
                              const char *Argv0) {
  Expected<Options> Request = parseOptions(Arguments);
  if (!Request)
    return Request.takeError();
  Expected<ChipConfig> Chip = selectChip(*Request, chipFolder(Argv0));
  if (!Chip)
    return Chip.takeError();
  Expected<std::unique_ptr<RunSetup>> Setup = setUp(*Request, *Chip);
  if (!Setup)
    return Setup.takeError();
  Subject Result{*Chip, std::move(*Setup), {}, Request->Functional};
  const Memory &Global = Result.Setup->Global;
  Result.Loaded.assign(Global.data(), Global.data() + Global.size());
  return Result;
}

/// Goes to a random moment, and back to where one of the threads was at the
/// instruction of a random one. Where that was; 0 if nowhere.
static uint64_t goBack(Replay &Run, uint64_t End, RandomSource &Random) {
  Run.goTo({1 + Random.word() % (End - 1), 0});
  const uint32_t Thread = Random.below(Run.threadCount());
  Events Wanted;
  Wanted.Instructions.push_back(
      {{Run.thread(Thread).Pc}, std::nullopt, nullptr});
  const ReplayStop Stop = Run.backward(Wanted);
  return Stop.Kind == ReplayStop::Instruction ? Stop.At.Time : 0;
}

static llvm::Error compare(Subject &S, unsigned Count, uint64_t Seed) {
  std::string Problem;
  std::unique_ptr<Replay> Run = S.makeReplay(Problem);
  if (!Run)
    return createStringError(Problem);
  const uint64_t End = Run->forward({}).At.Time;
  const StringRef Unit = S.IsFunctional ? "instruction " : "cycle ";
  RandomSource Random(Seed);
  for (unsigned Done = 0; Done != Count;) {
    const uint64_t Time = goBack(*Run, End, Random);
    if (Time == 0)
      continue;
    if (stateOf(*Run, S.Chip, S.Setup->Global) != S.stateAt(Time))
      return createStringError(Unit + Twine(Time) +
                               " is not as forward execution had it");
    ++Done;
  }
  outs() << Count << " moments of " << End << ' ' << Unit.rtrim()
         << "s are the same\n";
  return llvm::Error::success();
}

static llvm::Error run(ArrayRef<const char *> Arguments) {
  unsigned Count;
  uint64_t Seed;
  if (Arguments.size() < 4 || StringRef(Arguments[1]).getAsInteger(10, Count) ||
      StringRef(Arguments[2]).getAsInteger(10, Seed))
    return createStringError(
        "usage: tp-random-moments COUNT SEED OPTIONS-OF-TPSIM");
  Expected<Subject> S = load(Arguments.drop_front(3), Arguments[0]);
  if (!S)
    return S.takeError();
  return compare(*S, Count, Seed);
}

int main(int Argc, char **Argv) {
  if (llvm::Error E = run(ArrayRef<const char *>(Argv, Argc))) {
    errs() << "error: " << llvm::toString(std::move(E)) << '\n';
    return 1;
  }
  return 0;
}
