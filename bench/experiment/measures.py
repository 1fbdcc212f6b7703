# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The figures of one run, from tpsim's statistics (docs/statistics.md)."""

from .errors import BenchError

# Where a thread-cycle can go; the names of docs/statistics.md.
REASONS = ("data", "memory", "unit_conflict", "icache_conflict", "branch",
           "barrier", "sync", "sleep", "finished")

# What a test of a triangle reads of it (kTriangleTestBytes).
TRIANGLE_BYTES = 36


def figures(statistics, node_bytes):
    """Everything that table and charts show of a run but comparisons. Tests
    and loads read node_bytes of a node."""
    try:
        return {**speed(statistics), **work(statistics, node_bytes),
                "cache": cache(statistics["ray_profile"].get("cache"),
                               statistics["rays"]["total"]),
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


def work(statistics, node_bytes):
    """Per ray: what it tests, and what of that is read from global memory, to
    be tested there or loaded into a slot. bytes_per_second is that of all
    threads together."""
    profile = statistics["ray_profile"]
    rays = sum(profile["rays"].values())
    nodes, triangles = (profile["nodes_from_memory"],
                        profile["triangles_from_memory"])
    bytes_read = nodes * node_bytes + triangles * TRIANGLE_BYTES
    return {"nodes_per_ray": profile["nodes_visited"] / rays,
            "triangles_per_ray": profile["triangles_visited"] / rays,
            "nodes_read_per_ray": nodes / rays,
            "triangles_read_per_ray": triangles / rays,
            "bytes_per_ray": bytes_read / rays,
            "bytes_per_second": bytes_read
                                / statistics["run"]["seconds_at_chip_clock"]}


def cache(profile, rays):
    """What the cache did; None for the baseline."""
    if profile is None:
        return None
    visits = profile["visits"]
    return {"slots": profile["slots"],
            "hit_rate": profile["hits"] / visits if visits else None,
            "deletions": profile["deletions"],
            "deletions_per_ray": profile["deletions"] / rays,
            "slots_freed": profile["slots_freed"]["mean"],
            "bypasses_per_ray": profile["bypasses"] / rays,
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
