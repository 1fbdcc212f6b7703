//===- HostThreadPool.h - Host threads for one short job --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_HOSTTHREADPOOL_H
#define TP_SIMULATOR_CORE_HOSTTHREADPOOL_H

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace tp {

class HostThreadPool {
public:
  /// Gets the number of the host thread, 0 for the caller of run().
  using Job = std::function<void(unsigned)>;

  explicit HostThreadPool(unsigned Count);
  ~HostThreadPool();

  unsigned size() const { return unsigned(Helpers.size()) + 1; }
  /// Runs the job on this thread, and on those others that are there before
  /// it has ended here: jobs share out work until none is left.
  void run(const Job &ToDo);

private:
  void help(unsigned Number);
  /// Whether the calling helper may take part in job \p Number.
  bool enter(uint32_t Number);
  /// Waits until there is another job than \p Seen, and gives its number.
  uint32_t awaitJob(uint32_t Seen);

  /// Fields of State: the number of the job, whether helpers may still enter
  /// it, and how many are in it.
  static constexpr unsigned NumberShift = 16;
  static constexpr uint32_t Open = 1 << (NumberShift - 1);
  static constexpr uint32_t ActiveMask = Open - 1;

  const Job *Current = nullptr;
  std::atomic<uint32_t> State = 0;
  std::atomic<bool> Ending = false;
  /// How often to look before sleeping.
  unsigned Patience;
  std::vector<std::thread> Helpers;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_HOSTTHREADPOOL_H
