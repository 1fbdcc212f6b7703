//===- DebuggedProgram.cpp - A program that runs under test --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/source/DebuggedProgram.h"

#include "debugger/source/Expression.h"
#include "debugger/source/ValuePrinter.h"
#include "simulator/chip/ChipFile.h"
#include "simulator/core/LocalStore.h"
#include "simulator/tools/Options.h"

#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Program.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <map>

using namespace llvm;

namespace tp::test {

template <class T> static T must(Expected<T> Result, const char *What) {
  if (Result)
    return std::move(*Result);
  ADD_FAILURE() << What << ": " << toString(Result.takeError());
  std::abort();
}

namespace {

/// Programs that have been made, by their source and options.
class Programs {
public:
  ~Programs() {
    for (const auto &[Key, Path] : Paths)
      sys::fs::remove(Path);
  }

  const std::string &get(const std::string &Source,
                         const std::vector<std::string> &Options) {
    std::string &Path = Paths[{Source, Options}];
    if (Path.empty())
      Path = compile(Source, Options);
    return Path;
  }

private:
  std::map<std::pair<std::string, std::vector<std::string>>, std::string> Paths;

  static std::string compile(const std::string &Source,
                             const std::vector<std::string> &Options) {
    SmallString<128> Path;
    if (sys::fs::createTemporaryFile("debugged", "elf", Path))
      std::abort();
    std::string Input =
        Source.front() == '/' ? Source : std::string(TP_TESTS) + "/" + Source;
    std::vector<StringRef> Arguments = {TP_TPCC, Input, "-o", Path};
    Arguments.insert(Arguments.end(), Options.begin(), Options.end());
    std::string Problem;
    if (sys::ExecuteAndWait(TP_TPCC, Arguments, std::nullopt, {}, 120, 0,
                            &Problem) != 0) {
      ADD_FAILURE() << "tpcc failed: " << Problem;
      std::abort();
    }
    return std::string(Path);
  }
};

} // namespace

DebuggedProgram::DebuggedProgram(const std::string &Source,
                                 const std::vector<std::string> &Flags)
    : Chip(must(loadChip("1x1", std::string(TP_TESTS) + "/../simulator/chips"),
                "chip")) {
  Options Request;
  static Programs Made;
  Request.Program = Made.get(Source, Flags);
  Loaded = must(setUp(Request, Chip), "program");
  Information = std::make_unique<DebugInformation>(Loaded->Elf);
}

void DebuggedProgram::run(
    const std::function<void(const FrameContext &)> &Function) {
  FunctionalMachine Machine(Chip, Loaded->Text, Loaded->Global);
  Machine.setOutput([](int, std::string_view) {});
  LocalStoreRange Local(Chip.LocalStoreBytes);
  auto *Store = const_cast<uint8_t *>(Machine.threads()[0].LocalStore);
  MachineAccess Access;
  Access.Read = [&](uint32_t Address, MutableArrayRef<uint8_t> Bytes) {
    if (Local.contains(Address, uint32_t(Bytes.size()))) {
      std::memcpy(Bytes.data(), Store + (Address - Local.Begin), Bytes.size());
      return true;
    }
    return Loaded->Global.read(Address, Bytes.data(), Bytes.size());
  };
  Access.Write = [&](uint32_t Address, ArrayRef<uint8_t> Bytes) {
    if (Local.contains(Address, uint32_t(Bytes.size()))) {
      std::memcpy(Store + (Address - Local.Begin), Bytes.data(), Bytes.size());
      return true;
    }
    return Loaded->Global.write(Address, Bytes.data(), Bytes.size());
  };
  Access.WriteRegister = [&](unsigned Register, uint32_t Value) {
    WrittenRegister = Register;
    WrittenValue = Value;
    return true;
  };
  Machine.setStepObserver(
      0, [&](uint32_t Pc, const std::array<uint32_t, NumRegisters> &Registers) {
        FrameContext Frame;
        std::copy_n(Registers.begin(), DwarfRegisters,
                    Frame.Registers.Values.begin());
        Frame.Pc = Pc;
        Frame.Machine = &Access;
        Function(Frame);
      });
  RunResult Result = Machine.run();
  EXPECT_FALSE(Result.TrapInfo) << Result.TrapInfo->what();
}

void DebuggedProgram::runToCallsOf(
    const std::string &Name,
    const std::function<void(const FrameContext &)> &Function) {
  std::vector<uint32_t> Found = map().findFunctions(Name);
  ASSERT_EQ(Found.size(), 1u) << Name;
  uint32_t Entry = map().function(Found[0]).Entry;
  run([&](const FrameContext &Frame) {
    if (Frame.Pc == Entry)
      Function(frame(Frame, 1));
  });
}

std::vector<Frame> DebuggedProgram::backtrace(const FrameContext &Innermost) {
  Backtrace Stack = Information->unwinder().backtrace(Innermost);
  EXPECT_EQ(Stack.Problem, "");
  return Stack.Frames;
}

FrameContext DebuggedProgram::frame(const FrameContext &Innermost,
                                    size_t Number) {
  Backtrace Stack = Information->unwinder().backtrace(Innermost, Number + 1);
  if (Stack.Frames.size() <= Number) {
    ADD_FAILURE() << "no frame " << Number << ": " << Stack.Problem;
    return Innermost;
  }
  return Stack.Frames[Number].Context;
}

std::string print(DebugInformation &Information, const FrameContext &Frame,
                  const std::string &Text, char Format) {
  Expected<Expression> Parsed = Expression::parse(Text, Information, &Frame);
  if (!Parsed)
    return "error: " + toString(Parsed.takeError());
  Expected<Value> Result = Parsed->evaluate(Frame);
  if (!Result)
    return "error: " + toString(Result.takeError());
  PrintOptions Options;
  Options.Format = Format;
  return ValuePrinter(Information.map()).print(*Result, Frame, Options);
}

} // namespace tp::test
