# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The figures of one run, from tpsim's statistics (docs/statistics.md)."""

from .errors import BenchError

# Where a thread-cycle can go; the names of docs/statistics.md.
REASONS = ("data", "memory", "unit_conflict", "icache_conflict", "branch",
           "barrier", "sync", "sleep", "finished")

# Words of a node or triangle that the chip reads: 4 bytes each.
TRIANGLE_BYTES = 48


def figures(statistics):
    """Everything that table and charts show of a run but comparisons."""
    try:
        return {**speed(statistics), **work(statistics["ray_profile"]),
                "cache": cache(statistics["ray_profile"].get("cache")),
                "shares": shares(statistics),
                "worst_unit_conflict": worst_unit_conflict(statistics)}
    except KeyError as error:
        raise BenchError(f"tpsim's statistics lack {error}; build tpsim and the "
                         "kernels of one version") from error


def speed(statistics):
    """Rays per second of the chip and of its threads."""
    rays = statistics["rays"]
    return {"cycles": statistics["run"]["cycles"],
            "threads": statistics["chip"]["tm_count"]
                       * statistics["chip"]["tps_per_tm"],
            "rays": rays["total"],
            "rays_per_second": rays["per_second"],
            "thread_rays_per_second": {
                name: rays["per_thread"][name]
                for name in ("minimum", "mean", "median", "maximum")}}


def work(profile):
    """Per ray: what it tests, and what of that comes from global memory,
    straight or by being loaded into a slot."""
    rays = sum(profile["rays"].values())
    loads = profile["cache"]["loads"] if "cache" in profile else 0
    direct = profile["nodes_from_memory"] + profile["triangles_from_memory"]
    return {"nodes_per_ray": profile["nodes_visited"] / rays,
            "triangles_per_ray": profile["triangles_visited"] / rays,
            "direct_per_ray": direct / rays,
            "loads_per_ray": loads / rays}


def cache(profile):
    """What the cache did; None for the baseline."""
    if profile is None:
        return None
    visits = profile["visits"]
    return {"slots": profile["slots"],
            "hit_rate": profile["hits"] / visits if visits else None,
            "deletions": profile["deletions"],
            "slots_freed": profile["slots_freed"]["mean"],
            "bypasses": profile["bypasses"],
            "hits_by_depth": profile["hits_by_depth"],
            "loads_by_depth": profile["loads_by_depth"]}


def shares(statistics):
    """Of all thread-cycles, by what they went to."""
    cycles = statistics["thread_cycles"]
    return {name: count / cycles["total"]
            for name, count in [("issued", cycles["issued"]),
                                *((reason, cycles["lost"][reason])
                                  for reason in REASONS)]}


def worst_unit_conflict(statistics):
    """The opcode that waited longest for units, and its share of all
    thread-cycles; None if none waited."""
    opcodes = statistics["instructions_by_opcode"]
    if not opcodes:
        return None
    name = max(opcodes, key=lambda opcode: opcodes[opcode]["unit_conflict_cycles"])
    cycles = opcodes[name]["unit_conflict_cycles"]
    if not cycles:
        return None
    return {"opcode": name,
            "share": cycles / statistics["thread_cycles"]["total"]}
