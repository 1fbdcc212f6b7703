# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Which kernels run on which scenes and chips."""

import dataclasses

BASELINE = "baseline"
POLICIES = ("HighestBranch", "LeastRecentlyUsed", "KeepTop")
FORMATS = ("FullSlots", "QuantizedSlots")


@dataclasses.dataclass(frozen=True)
class Kernel:
    """A program: the baseline, which has no policy, or a stack-cached one."""

    policy: str = ""
    slot_format: str = ""

    @property
    def is_cached(self):
        return bool(self.policy)

    @property
    def name(self):
        return f"{self.policy}, {self.slot_format}" if self.policy else BASELINE

    @property
    def source(self):
        return ("kernels/stackcache/StackCached.cpp" if self.is_cached
                else "kernels/pathtracer/PathTracer.cpp")

    @property
    def node_bytes(self):
        """What a test or load reads of a node; NodeBytes in SlotFormat.h."""
        return 56 if self.slot_format == "QuantizedSlots" else 112

    @property
    def defines(self):
        if not self.is_cached:
            return []
        return [f"-DTP_CACHE_POLICY={self.policy}",
                f"-DTP_CACHE_FORMAT={self.slot_format}"]


@dataclasses.dataclass(frozen=True)
class Configuration:
    """One run: local store in KiB, memory latency in cycles."""

    scene: str
    kernel: Kernel
    local_store: int
    latency: int

    def __str__(self):
        return (f"{self.scene}, {self.kernel.name}, {self.local_store} KiB, "
                f"latency {self.latency}")

    @property
    def settings(self):
        """What differs from the chip file, for tpsim --set."""
        return [f"local_store.bytes={self.local_store}KiB",
                f"memory.latency_cycles={self.latency}"]


def all_configurations(scenes, kernels, local_stores, latencies):
    """Every run of the experiment. The baseline uses the local store for its
    stack only: it runs with the largest one, and at the highest latency also
    with the smallest, to prove that."""
    found = []
    for scene in scenes:
        for latency in latencies:
            found.append(Configuration(scene, Kernel(), max(local_stores),
                                       latency))
            found += [Configuration(scene, kernel, size, latency)
                      for kernel in kernels for size in local_stores]
        if min(local_stores) != max(local_stores):
            found.append(Configuration(scene, Kernel(), min(local_stores),
                                       max(latencies)))
    return found
