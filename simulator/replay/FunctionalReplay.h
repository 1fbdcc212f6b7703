//===- FunctionalReplay.h - Without timing, forward and back ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H
#define TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H

#include "simulator/core/AddressSpace.h"
#include "simulator/replay/FunctionalTimeline.h"
#include "simulator/replay/Replay.h"

namespace tp {

/// See Replay.h and makeFunctionalReplay().
class FunctionalReplay final : public Replay {
public:
  FunctionalReplay(const ChipConfig &Chip, const Program &Text, Memory &Global,
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

  Statistics statistics() const override { return Time.machine().statistics(); }
  CheckpointUse checkpoints() const override { return Time.use(); }

private:
  uint8_t *host(uint32_t Number, uint32_t Address, uint64_t Bytes) const {
    return hostBytes(Space, Time.machine().thread(Number).LocalStoreBias,
                     Address, Bytes);
  }
  /// The stop at the end of a run that came to no event.
  ReplayStop endOf(const RunResult &Result);
  /// Goes there, or to where the run ends before.
  std::optional<ReplayStop> moveTo(uint64_t Target);
  /// The stop for an event; nothing if it turns out not to be wanted.
  std::optional<ReplayStop> stopAt(const FoundEvent &Found,
                                   const Events &Wanted, bool IsForward);
  std::vector<uint8_t> watchedBytes(const AccessEvents &Event) const;
  /// The last event before \p Before; WasStopped: the user did not wait.
  std::optional<FoundEvent> findLast(const Events &Wanted, EventPlace Before,
                                     bool &WasStopped);
  /// That stands in the history, if it knows.
  std::optional<LastWrite> knownWrite(uint32_t Address, uint32_t Bytes);

  const ChipConfig Chip;
  const Program &Text;
  const AddressSpace Space;
  FunctionalTimeline Time;
  Moment Now;
  /// Events up to this one have been seen.
  EventPlace Seen;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H
