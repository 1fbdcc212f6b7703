//===- Replay.h - A run that goes forward and backward ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A run depends on nothing but chip, program and memory. So going back is to
// restore an earlier state and to execute from there: the same happens again.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_REPLAY_H
#define TP_SIMULATOR_REPLAY_REPLAY_H

#include "runtime/include/tp/profile.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Engine.h"
#include "simulator/core/Memory.h"
#include "simulator/core/Program.h"
#include "simulator/memory/MemoryRequest.h"
#include "simulator/replay/Events.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tp {

/// A load or atomic of a thread that the memory system has not answered, or
/// whose result is not ready.
struct RequestUnderWay {
  /// The register that waits for it, 0..63.
  uint8_t Register = 0;
  Opcode Producer = Opcode(0);
  /// The cycle in which the result is ready; none: not known yet.
  std::optional<uint64_t> ReadyCycle;
  bool FromGlobalMemory = false;
  /// It has gone beyond the L1.
  bool IsBeyondL1 = false;
};

/// What a thread does at the moment, on a chip with timing.
struct ThreadTiming {
  /// Why its next instruction is not issued in this cycle, and on which
  /// producer it waits if it waits for data; none if it can issue.
  std::optional<Loss> Reason;
  Opcode Producer = Opcode(0);
  std::vector<RequestUnderWay> UnderWay;
  uint32_t UnansweredStores = 0;
  LossCounts Lost{};
};

/// A thread at the moment.
struct ReplayThread {
  std::array<uint32_t, NumRegisters> Registers{};
  uint32_t Pc = 0;
  ThreadState State = ThreadState::Running;
  /// With which it halted.
  int32_t Status = 0;
  /// That it has issued so far.
  uint64_t Instructions = 0;
  /// None without timing.
  std::optional<ThreadTiming> Timing;
};

/// An instruction that wrote to memory.
struct WriteRecord {
  Moment At;
  uint32_t Thread = 0;
  uint32_t Pc = 0;
};

/// Nobody wrote: the bytes are as the program was loaded.
struct AsLoaded {};
/// The user wrote, at this moment.
struct WrittenByUser {
  Moment At;
};
/// The stop flag was set before the answer was found.
struct SearchInterrupted {};
using LastWrite =
    std::variant<AsLoaded, WrittenByUser, WriteRecord, SearchInterrupted>;

/// What going back costs at the moment.
struct CheckpointUse {
  size_t Checkpoints = 0;
  /// Bytes of host memory of all of them, and how many they may have.
  uint64_t Bytes = 0;
  uint64_t Budget = 0;
};

struct ReplayOptions {
  /// For checkpoints, in bytes of host memory. Those that are kept lie closer
  /// together near the moment than far from it. The one of the beginning and
  /// one more are kept even if they need more.
  uint64_t CheckpointBytes = uint64_t(512) << 20;
  /// Makes a checkpoint every so many cycles; 0: as often as is worth the
  /// host's time.
  uint64_t CheckpointCycles = 0;
  /// Ends the run; 0: no limit.
  uint64_t MaxCycles = 0;
  unsigned HostThreads = 1;
  /// Who gets what the program writes, each byte once however often it is
  /// executed again.
  OutputFunction Output;
};

/// A run of a program on a chip that can be moved to any of its moments. What
/// happens in it does not depend on how it is moved.
class Replay {
public:
  virtual ~Replay() = default;

  /// Stops forward(), backward() and lastWrite() soon when this becomes true.
  void setStopFlag(const std::atomic<bool> *Flag) { StopFlag = Flag; }
  /// Called about ten times a second in long moves.
  void setProgress(ProgressFunction Function) { Report = std::move(Function); }

  virtual Moment now() const = 0;
  virtual uint32_t threadCount() const = 0;
  virtual ReplayThread thread(uint32_t Number) const = 0;
  /// Memory at the moment as thread \p Number addresses it. False, and nothing
  /// done, for what is no memory.
  virtual bool read(uint32_t Number, uint32_t Address,
                    std::span<uint8_t> Bytes) const = 0;

  /// Runs until the first event behind now.
  virtual ReplayStop forward(const Events &Wanted) = 0;
  /// Goes back to the last event before now, or to the beginning.
  virtual ReplayStop backward(const Events &Wanted) = 0;
  /// Goes to a moment, or to where the run ends before it.
  virtual ReplayStop goTo(Moment Target) = 0;
  /// Calls \p Function at another moment and comes back. The events behind now
  /// are then the same as before.
  virtual void visit(Moment There, const std::function<void()> &Function) = 0;

  /// Changes a running program. From here on it goes another way, and what was
  /// known of later moments is forgotten; going back before the change and
  /// forward again makes it again. False, and nothing done, for what is no
  /// memory, or text.
  virtual bool write(uint32_t Number, uint32_t Address,
                     std::span<const uint8_t> Bytes) = 0;
  /// Likewise for a register, 0..63; not r0.
  virtual void setRegister(uint32_t Number, unsigned Register,
                           uint32_t Value) = 0;
  /// Likewise for the next instruction of a running thread; false if \p Pc is
  /// outside the text.
  virtual bool setPc(uint32_t Number, uint32_t Pc) = 0;

  /// Who wrote last to one of the bytes, of all that is in memory now; in the
  /// local store of thread \p Number if they are there. The moment stays.
  virtual LastWrite lastWrite(uint32_t Number, uint32_t Address,
                              uint32_t Bytes) = 0;

  /// The counts up to now.
  virtual Statistics statistics() const = 0;
  virtual CheckpointUse checkpoints() const = 0;

protected:
  const std::atomic<bool> *StopFlag = nullptr;
  ProgressFunction Report;
};

/// A run with timing. Chip, program and memory must outlive it; \p Global is as
/// the program was loaded, and belongs to the replay. Null and \p Error if the
/// chip cannot be simulated.
std::unique_ptr<Replay> makeCycleReplay(const ChipConfig &Chip,
                                        const Program &Text, Memory &Global,
                                        ReplayOptions Request,
                                        std::string &Error);
/// Likewise without timing.
std::unique_ptr<Replay>
makeFunctionalReplay(const ChipConfig &Chip, const Program &Text,
                     Memory &Global, ReplayOptions Request, std::string &Error);

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_REPLAY_H
