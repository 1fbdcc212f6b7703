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

/// Runs the same job on several host threads again and again, each time until
/// all are done. Made for jobs of microseconds: waiting threads spin for a
/// moment before they sleep.
class HostThreadPool {
public:
  /// Gets the number of the host thread, 0 for the caller of run().
  using Job = std::function<void(unsigned)>;

  explicit HostThreadPool(unsigned Count);
  ~HostThreadPool();

  unsigned size() const { return unsigned(Helpers.size()) + 1; }
  /// Runs the job once on all threads.
  void run(const Job &ToDo);

private:
  void help(unsigned Number);

  const Job *Current = nullptr;
  /// Number of jobs started.
  std::atomic<uint32_t> Started = 0;
  /// Helpers that have not finished the current job.
  std::atomic<uint32_t> Busy = 0;
  std::atomic<bool> Ending = false;
  std::vector<std::thread> Helpers;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_HOSTTHREADPOOL_H
