# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Statistics of a run of 4 threads and 10 rays in the form that tpsim writes."""

LOST = {"data": 100, "memory": 300, "unit_conflict": 30, "icache_conflict": 20,
        "branch": 0, "barrier": 40, "sync": 5, "sleep": 0, "finished": 5}
CACHE = {"slots": 16, "slot_bytes": 120, "visits": 50, "hits": 40, "loads": 10,
         "bypasses": 1, "hits_by_depth": [20, 20], "loads_by_depth": [4, 6],
         "deletions": 2,
         "slots_freed": {"mean": 3.5, "maximum": 4, "histogram": [0, 2]},
         "peak_slots_used": 16}


def make_statistics(cycles, cached):
    """A cached run finds most of what it tests in its slots."""
    rate = 10 / (cycles * 1e-9)
    profile = {"rays": {"closest": 6, "any": 4}, "nodes_visited": 30,
               "triangles_visited": 20,
               "nodes_from_memory": 3 if cached else 30,
               "triangles_from_memory": 2 if cached else 20}
    if cached:
        profile["cache"] = CACHE
    return {
        "format_version": 2,
        "run": {"cycles": cycles, "seconds_at_chip_clock": cycles * 1e-9},
        "chip": {"tm_count": 2, "tps_per_tm": 2},
        "rays": {"total": 10, "per_second": rate, "per_thread": {
            "minimum": rate / 8, "mean": rate / 3.5, "median": rate / 4,
            "maximum": rate / 2}},
        "ray_profile": profile,
        "thread_cycles": {"total": 1000, "issued": 500, "lost": LOST},
        "instructions_by_opcode": {
            "add": {"unit_conflict_cycles": 0},
            "mul_s": {"unit_conflict_cycles": 20},
            "div_s": {"unit_conflict_cycles": 10}},
        "threads": {"rays": [1, 2, 3, 4]}}
