# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs all configurations, some at once, and says how long the rest will take."""

import concurrent.futures
import statistics
import sys


class Progress:
    """Prints a line for each finished run."""

    def __init__(self, configurations, jobs):
        self.waiting = list(configurations)
        self.total = len(self.waiting)
        self.jobs = jobs
        self.seconds = {}

    def finish(self, configuration, run):
        self.waiting.remove(configuration)
        self.seconds.setdefault(configuration.scene, []).append(run.seconds)
        done = self.total - len(self.waiting)
        how = "kept" if run.was_kept else f"{run.seconds:.1f} s"
        print(f"[{done}/{self.total}] {configuration}: {how}; "
              f"{self.time_left()}", file=sys.stderr, flush=True)

    def time_left(self):
        """A scene's runs take about alike; of an unknown one, the mean."""
        known = {scene: statistics.fmean(found)
                 for scene, found in self.seconds.items()}
        other = statistics.fmean(known.values())
        left = sum(known.get(configuration.scene, other)
                   for configuration in self.waiting) / self.jobs
        return f"{left / 60:.0f} min left" if left >= 90 else f"{left:.0f} s left"


def run_all(simulator, configurations, jobs):
    """{configuration: Run}. The largest scenes first, so that the jobs end
    together; the first failure ends everything after the runs under way."""
    order = sorted(configurations,
                   key=lambda c: -simulator.scene_bytes(c.scene))
    progress = Progress(order, jobs)
    runs = {}
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(simulator.run, configuration): configuration
                   for configuration in order}
        try:
            for future in concurrent.futures.as_completed(futures):
                configuration = futures[future]
                runs[configuration] = future.result()
                progress.finish(configuration, runs[configuration])
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return {configuration: runs[configuration]
            for configuration in configurations}
