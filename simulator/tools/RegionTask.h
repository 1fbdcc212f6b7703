//===- RegionTask.h - Measures only a part of a run -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_REGIONTASK_H
#define TP_SIMULATOR_TOOLS_REGIONTASK_H

#include "simulator/tools/RunLoop.h"
#include "simulator/tools/RunSetup.h"

namespace tp {

/// Adds up what happens while threads are between two profile markers: from the
/// end of the window in which more threads have passed the first one than the
/// second, to the end of the window in which that is over.
class RegionTask : public RunTask {
public:
  /// The markers of --regions. Both must outlive it.
  RegionTask(const Options &Request, const RunSetup &Loaded);

  std::vector<uint32_t> markers() const override {
    return {Region.Begin, Region.End};
  }
  llvm::Error pause(Engine &Machine, RunResult::EndKind Now) override;
  void serialize(Archive &A) override;

  /// The sum over the regions of a run that has ended, and the rays in them by
  /// thread. An error if there was none.
  llvm::Expected<Statistics> statistics(const Engine &Machine) const;
  const std::vector<uint32_t> &rays() const { return RaysInside; }

private:
  /// By thread so far; empty if there is no scene.
  std::vector<uint32_t> countRays() const;

  const MarkerRegion Region;
  const RunSetup &Loaded;
  bool IsOpen = false;
  /// When the open one began.
  Statistics Before;
  std::vector<uint32_t> RaysBefore;
  Statistics Inside;
  std::vector<uint32_t> RaysInside;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_REGIONTASK_H
