//===- CycleReplay.h - A run with timing, forward and backward --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_CYCLEREPLAY_H
#define TP_SIMULATOR_REPLAY_CYCLEREPLAY_H

#include "simulator/core/AddressSpace.h"
#include "simulator/replay/Replay.h"
#include "simulator/replay/Timeline.h"

namespace tp {

/// See Replay.h and makeCycleReplay().
class CycleReplay final : public Replay {
public:
  CycleReplay(const ChipConfig &Chip, const Program &Text, Memory &Global,
              ReplayOptions Request);

  const std::string &error() const { return Time.error(); }

  Moment now() const override { return Now; }
  uint32_t threadCount() const override { return Chip.threadCount(); }
  ReplayThread thread(uint32_t Number) const override;
  bool read(uint32_t Number, uint32_t Address,
            std::span<uint8_t> Bytes) const override;

  ReplayStop forward(const Events &Wanted) override;
  ReplayStop backward(const Events &Wanted) override;
  ReplayStop goTo(Moment Target) override;

  bool write(uint32_t Number, uint32_t Address,
             std::span<const uint8_t> Bytes) override;
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value) override;
  bool setPc(uint32_t Number, uint32_t Pc) override;

  LastWrite lastWrite(uint32_t Number, uint32_t Address,
                      uint32_t Bytes) override;

  Statistics statistics() const override { return Time.engine().statistics(); }
  CheckpointUse checkpoints() const override { return Time.use(); }

private:
  ThreadTiming timing(uint32_t Number) const;
  /// Host address of \p Bytes bytes as the thread addresses them; null if they
  /// are no memory.
  uint8_t *host(uint32_t Number, uint32_t Address, uint64_t Bytes) const;
  /// Goes there; behind is what has happened up to \p Behind.
  std::optional<ReplayStop> moveTo(Moment Target, EventPlace Behind);
  ReplayStop endOf(const RunResult &Result);
  /// The stop for an event; nothing if it turns out not to be wanted.
  std::optional<ReplayStop> stopAt(const FoundEvent &Found,
                                   const Events &Wanted, bool IsForward);
  std::vector<uint8_t> watchedBytes(const AccessEvents &Event) const;
  std::optional<FoundEvent> findLast(const Events &Wanted, EventPlace Before,
                                     bool &WasStopped);

  const ChipConfig Chip;
  const Program &Text;
  const AddressSpace Space;
  const uint64_t MaxCycles;
  Timeline Time;
  Moment Now;
  /// Events up to this one have been seen.
  EventPlace Seen;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_CYCLEREPLAY_H
