# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""An experiment of two scenes; as a program it writes its results to a file."""

import pathlib
import sys

from experiment.configurations import Kernel, all_configurations
from experiment.results import make_results, write_results
from experiment.simulator import Run
from statistics_of_runs import make_statistics

CACHED = Kernel("HighestBranch", "FullSlots")


def cycles_of(configuration):
    """The larger the local store, the faster the cached kernel."""
    factor = configuration.local_store / 2 if configuration.kernel.is_cached else 1
    scene = {"near": 1000, "far_away": 64000}[configuration.scene]
    return int(scene * configuration.latency / 100 / factor)


def make_runs(kernels=(CACHED,)):
    configurations = all_configurations(
        ["near", "far_away"], kernels, [2, 8], [100, 300])
    return {c: Run(make_statistics(cycles_of(c), c.kernel.is_cached), 60.0,
                   f"image of {c.scene}", f"key of {c}")
            for c in configurations}


def results_of(runs):
    return make_results(runs, "2x2", ["--size", "4x4"], 2)


if __name__ == "__main__":
    write_results(results_of(make_runs()), pathlib.Path(sys.argv[1]))
