# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""All runs of the experiment with their figures and comparisons, as one JSON."""

import json

from .configurations import BASELINE, Kernel
from .errors import BenchError
from .measures import figures

FORMAT_VERSION = 1


class Results:
    """Reads what make_results() made."""

    def __init__(self, content):
        self.content = content
        self.runs = content["runs"]

    def values(self, name):
        """The different values of a member of all runs, in their order."""
        return list(dict.fromkeys(run[name] for run in self.runs))

    @property
    def scenes(self):
        return self.values("scene")

    @property
    def latencies(self):
        return self.values("latency")

    @property
    def local_stores(self):
        return sorted({run["local_store"] for run in self.runs
                       if run["kernel"] != BASELINE})

    @property
    def kernels(self):
        """Names of the stack-cached ones."""
        return [name for name in self.values("kernel") if name != BASELINE]

    def baseline(self, scene, latency):
        return self.find(scene, BASELINE, None, latency)

    def find(self, scene, kernel, local_store, latency):
        """One run; None if the experiment has no such run. The baseline has the
        largest local store unless another is asked for."""
        found = [run for run in self.runs
                 if (run["scene"], run["kernel"], run["latency"])
                 == (scene, kernel, latency)
                 and local_store in (None, run["local_store"])]
        return max(found, key=lambda run: run["local_store"], default=None)

    def rows(self, is_short):
        """The runs that are rows of a table: without the baseline's proofs. A
        short table has all local stores of the first cached kernel only, of
        the others the largest."""
        return [run for run in self.runs
                if self.is_baseline_row(run) or run["kernel"] != BASELINE
                and not (is_short and self.is_extra(run))]

    def is_baseline_row(self, run):
        return run is self.baseline(run["scene"], run["latency"])

    def is_extra(self, run):
        return (run["kernel"] != self.kernels[0]
                and run["local_store"] != max(self.local_stores))


def describe(configuration, run):
    """One run as an entry of the JSON; the counters of single threads stay in
    the run's own file."""
    kernel = configuration.kernel
    return {"scene": configuration.scene, "kernel": kernel.name,
            "policy": kernel.policy, "slot_format": kernel.slot_format,
            "local_store": configuration.local_store,
            "latency": configuration.latency,
            "seconds": run.seconds, "key": run.key,
            "image_digest": run.image_digest,
            "figures": figures(run.statistics, kernel.node_bytes),
            "statistics": {name: value for name, value in run.statistics.items()
                           if name != "threads"}}


def make_results(runs, chip, picture, jobs):
    """Of {configuration: Run}."""
    entries = [describe(configuration, run)
               for configuration, run in runs.items()]
    results = Results({"format_version": FORMAT_VERSION, "chip": chip,
                       "picture": picture, "jobs": jobs,
                       "seconds": sum(entry["seconds"] for entry in entries),
                       "runs": entries})
    for entry in entries:
        compare(entry, results.baseline(entry["scene"], entry["latency"]))
    return results


def compare(entry, baseline):
    """Adds what a run has over the baseline at the same latency."""
    entry["image_equals_baseline"] = (
        entry["image_digest"] == baseline["image_digest"])
    entry["speed_up"] = (entry["figures"]["rays_per_second"]
                         / baseline["figures"]["rays_per_second"])


def problems(results):
    """What should be equal and is not, in words."""
    found = []
    for run in results.runs:
        place = f"{run['scene']}, {run['kernel']}, {run['local_store']} KiB, " \
                f"latency {run['latency']}"
        baseline = results.baseline(run["scene"], run["latency"])
        if not run["image_equals_baseline"]:
            found.append(f"{place}: not the baseline's image")
        if (run["kernel"] == BASELINE
                and run["figures"]["cycles"] != baseline["figures"]["cycles"]):
            found.append(f"{place}: the baseline takes "
                         f"{run['figures']['cycles']} cycles, "
                         f"{baseline['figures']['cycles']} with "
                         f"{baseline['local_store']} KiB")
    for scene in results.scenes:
        images = {results.baseline(scene, latency)["image_digest"]
                  for latency in results.latencies}
        if len(images) > 1:
            found.append(f"{scene}: the image depends on the latency")
    return found


def read_results(path):
    """A file that write_results() wrote, with figures of today's making."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        if content["format_version"] != FORMAT_VERSION:
            raise ValueError(f"format {content['format_version']}, not "
                             f"{FORMAT_VERSION}")
        for run in content["runs"]:
            kernel = Kernel(run["policy"], run["slot_format"])
            run["figures"] = figures(run["statistics"], kernel.node_bytes)
        return Results(content)
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BenchError(f"{path}: cannot read the results ({error}); run the "
                         "experiment again") from error


def write_results(results, path):
    path.write_text(json.dumps(results.content, indent=1) + "\n",
                    encoding="utf-8")
