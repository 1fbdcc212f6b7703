//===- SessionOptions.cpp - What to debug ---------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Session.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

/// The options of tpsim that say what is run, and not what is written about it.
static constexpr StringLiteral RunOptions[] = {
    "--chip",       "--set",        "--scene", "--size",
    "--spp",        "--depth",      "--seed",  "--bvh",
    "--functional", "--max-cycles", "--quiet", "--host-threads"};

static constexpr StringLiteral CheckpointOption = "--checkpoint-memory";

/// Mebibytes.
static Expected<uint64_t> parseBudget(StringRef Text) {
  uint64_t Megabytes;
  if (Text.getAsInteger(10, Megabytes) || Megabytes == 0 ||
      Megabytes > (uint64_t(1) << 24))
    return createStringError(CheckpointOption + " '" + Text +
                             "': expected a whole number of MiB from 1 to " +
                             Twine(uint64_t(1) << 24));
  return Megabytes << 20;
}

Expected<SessionOptions> parseSessionOptions(ArrayRef<const char *> Arguments) {
  SessionOptions Result;
  SmallVector<const char *> ForRun;
  for (size_t I = 0; I != Arguments.size(); ++I) {
    StringRef Argument = Arguments[I];
    if (Argument == "--") {
      append_range(ForRun, Arguments.drop_front(I));
      break;
    }
    auto [Name, Value] = Argument.split('=');
    if (Name == CheckpointOption) {
      if (!Argument.contains('=')) {
        if (++I == Arguments.size())
          return createStringError(CheckpointOption + " needs a value in MiB");
        Value = Arguments[I];
      }
      Expected<uint64_t> Bytes = parseBudget(Value);
      if (!Bytes)
        return Bytes.takeError();
      Result.CheckpointBytes = *Bytes;
      continue;
    }
    if (Name.starts_with("-") && Name.size() > 1 &&
        !is_contained(RunOptions, Name))
      return createStringError("the debugger has no option '" + Name +
                               "' (see --help)");
    ForRun.push_back(Arguments[I]);
  }
  Expected<Options> Run = parseOptions(ForRun);
  if (!Run)
    return Run.takeError();
  Result.Run = std::move(*Run);
  return Result;
}

} // namespace tp
