# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_statistics.py FILE: checks that the sums in a tpsim JSON agree."""

import json
import sys


def check(what, actual, expected):
    if actual != expected:
        sys.exit(f"{what}: {actual} instead of {expected}")


with open(sys.argv[1], encoding="utf-8") as file:
    statistics = json.load(file)

run, chip = statistics["run"], statistics["chip"]
cycles, opcodes = statistics["thread_cycles"], statistics["instructions_by_opcode"]
lost, threads = cycles["lost"], statistics["threads"]
thread_count = chip["tm_count"] * chip["tps_per_tm"]

check("threads x cycles", cycles["total"], thread_count * run["cycles"])
check("issued and lost", cycles["issued"] + sum(lost.values()), cycles["total"])
check("issued", cycles["issued"], run["instructions"])
check("instructions by opcode", sum(o["executed"] for o in opcodes.values()),
      run["instructions"])
check("data stalls by opcode", sum(o["data_stall_cycles"] for o in opcodes.values()),
      sum(lost[reason] for reason in
          ("data", "memory", "l1", "l2", "dram", "store_buffer")))
check("unit conflicts by opcode",
      sum(o["unit_conflict_cycles"] for o in opcodes.values()),
      lost["unit_conflict"])
check("operations of the units",
      sum(u["operations"] for u in statistics["units"].values()),
      run["instructions"])
check("instructions by thread", sum(threads["instructions"]), run["instructions"])
check("number of threads", len(threads["instructions"]), thread_count)
check("icache conflicts", statistics["icache"]["conflict_cycles"],
      lost["icache_conflict"])
if run["outcome"] == "finished":
    check("last finish", max(threads["finish_cycle"]), run["cycles"])
for name, unit in statistics["units"].items():
    if not 0 <= unit["utilisation"] <= 1:
        sys.exit(f"utilisation of {name}: {unit['utilisation']}")
areas = dict(chip["area_mm2"])
total = areas.pop("total")
if abs(sum(areas.values()) - total) > 1e-9 * total:
    sys.exit(f"area: {sum(areas.values())} instead of {total}")
if "rays" in threads:
    total_rays = statistics["rays"]["total"] if "rays" in statistics else 0
    check("rays", sum(threads["rays"]), total_rays)
if "ray_profile" in statistics:
    profile = statistics["ray_profile"]
    check("rays with events", sum(profile["rays"].values()),
          statistics["rays"]["total"])
    for name in profile["per_ray"]:
        check(f"{name} by thread", sum(threads[name]), profile[name])
    if "cache" in profile:
        cache = profile["cache"]
        misses = cache["visits"] - cache["hits"]
        check("misses up to the loads", min(misses, cache["loads"]), misses)
        check("hits by depth", sum(cache["hits_by_depth"]), cache["hits"])
        check("loads by depth", sum(cache["loads_by_depth"]), cache["loads"])
        check("deletions by size", sum(cache["slots_freed"]["histogram"]),
              cache["deletions"])
        check("hits by thread", sum(threads["cache_hits"]), cache["hits"])
print("all sums agree")
