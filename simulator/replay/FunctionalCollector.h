//===- FunctionalCollector.h - Events of a run without timing ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_FUNCTIONALCOLLECTOR_H
#define TP_SIMULATOR_REPLAY_FUNCTIONALCOLLECTOR_H

#include "simulator/functional/InstructionStops.h"
#include "simulator/replay/EventMatcher.h"
#include "simulator/replay/HostBytes.h"

#include <cstring>
#include <optional>

namespace tp {

/// Stops at the first event, or remembers the last one.
class FunctionalCollector final : public InstructionObserver {
public:
  /// Both must outlive it.
  FunctionalCollector(const EventMatcher &Matcher, const AddressSpace &Space)
      : Matcher(Matcher), Space(Space) {}

  const std::vector<bool> &words() const { return Matcher.words(); }
  bool hasStopped() const {
    return Found && Matcher.kept() == EventMatcher::First;
  }
  const std::optional<FoundEvent> &found() const { return Found; }

  bool stopsBefore(const FunctionalThread &T, uint32_t Word,
                   uint64_t Number) override {
    const Moment At{Number, 0};
    if (!Matcher.mayMatch(At))
      return false;
    const std::function<bool(uint32_t, std::span<uint8_t>)> Read =
        [&](uint32_t Address, std::span<uint8_t> Bytes) {
          const uint8_t *Source =
              hostBytes(Space, T.LocalStoreBias, Address, Bytes.size());
          if (Source)
            std::memcpy(Bytes.data(), Source, Bytes.size());
          return Source != nullptr;
        };
    const Probe Place{T.Number, Space.TextBegin + Word * 4, At, T.Registers,
                      Read};
    if (std::optional<FoundEvent> Here = Matcher.match(Place))
      Found = Here;
    return hasStopped();
  }

private:
  const EventMatcher &Matcher;
  const AddressSpace &Space;
  std::optional<FoundEvent> Found;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_FUNCTIONALCOLLECTOR_H
