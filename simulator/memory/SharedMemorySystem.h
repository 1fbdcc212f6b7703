//===- SharedMemorySystem.h - Memory of all the TMs -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_SHAREDMEMORYSYSTEM_H
#define TP_SIMULATOR_MEMORY_SHAREDMEMORYSYSTEM_H

#include "simulator/chip/MinimumRoundTrip.h"
#include "simulator/memory/DramChannels.h"
#include "simulator/memory/MemorySystem.h"
#include "simulator/memory/TmGroup.h"
#include "simulator/memory/TmPath.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// The memory system of any chip that has one.
///
/// After the window that ends in cycle E all requests of the TMs before E are
/// known; later ones reach the shared part from E + ToShared on (ShortestWays).
/// So the L2s do all before that, as nothing that DRAM has not yet answered
/// comes back earlier. What the L2s then still send reaches DRAM after another
/// L2 latency: the channels decide all before that. And what departs to the TMs
/// within InShared of the L2s' limit is then known to the last.
class SharedMemorySystem final : public MemorySystem {
public:
  explicit SharedMemorySystem(const ChipConfig &Chip);

  TmMemory &tm(uint32_t Tm) override { return *Tms[Tm]; }
  void prefetch(uint32_t Tm) const override {
    if (Tm + 2 < Tms.size())
      Tms[Tm + 2]->prefetchObject();
    if (Tm < Tms.size())
      Tms[Tm]->prefetchBuffers();
  }
  unsigned stages() const override { return unsigned(Stages.size()); }
  unsigned parts(unsigned Stage) const override;
  void runPart(unsigned Stage, unsigned Part, uint64_t WindowEnd) override;
  uint64_t nextEvent() const override;
  MemoryStatistics statistics(uint64_t WindowEnd) const override;
  void serialize(Archive &A) override;

private:
  enum class Step : uint8_t {
    /// Of each group.
    Groups,
    /// Each request to its channel.
    ToChannels,
    /// Of each channel.
    Channels,
    /// Each answer to its group.
    ToGroups,
    /// Of each group.
    Deliver,
    /// Of each group, if no DRAM is in between.
    GroupsAndDeliver,
  };

  uint64_t deliveryLimit(uint64_t WindowEnd) const {
    return WindowEnd + Ways.ToShared + Ways.InShared;
  }
  uint64_t dramLimit(uint64_t WindowEnd) const {
    return WindowEnd + Ways.ToShared + (HasL2 ? Ways.InShared : 0);
  }

  const ShortestWays Ways;
  const bool HasL1;
  const bool HasCrossbar;
  const bool HasL2;
  std::vector<Step> Stages;
  std::vector<std::unique_ptr<TmPath>> Tms;
  std::vector<std::unique_ptr<TmGroup>> Groups;
  /// Null without DRAM.
  std::unique_ptr<DramChannels> Dram;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_SHAREDMEMORYSYSTEM_H
