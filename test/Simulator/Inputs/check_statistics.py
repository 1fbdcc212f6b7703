# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_statistics.py FILE [--part]: checks that the sums in a tpsim JSON, maybe
of a part of a run, agree."""

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
if run["outcome"] == "finished" and "--part" not in sys.argv:
    check("last finish", max(threads["finish_cycle"]), run["cycles"])
for name, unit in statistics["units"].items():
    if not 0 <= unit["utilisation"] <= 1:
        sys.exit(f"utilisation of {name}: {unit['utilisation']}")


def check_near(what, actual, expected):
    if abs(actual - expected) > 1e-9 * abs(expected):
        sys.exit(f"{what}: {actual} instead of {expected}")


if "area_mm2" in chip:
    areas = dict(chip["area_mm2"])
    total = areas.pop("total")
    check_near("area", sum(areas.values()), total)
    energy = statistics["energy"]
    for unit in "joules", "watts":
        check_near(unit, sum(p[unit] for p in energy["parts"].values()),
                   energy[unit])
    check_near("power", energy["watts"] * run["seconds_at_chip_clock"],
               energy["joules"])
if "instructions_by_pc" in statistics:
    pcs = statistics["instructions_by_pc"]
    check("instructions by pc", sum(p["executed"] for p in pcs),
          run["instructions"])
    for reason, total in lost.items():
        by_pc = sum(p["lost"].get(reason, 0) for p in pcs)
        check(f"{reason} by pc", by_pc, 0 if reason == "finished" else total)
    for name, opcode in opcodes.items():
        check(f"{name} by pc",
              sum(p["executed"] for p in pcs if p["opcode"] == name),
              opcode["executed"])
memory = statistics.get("memory", {})
for level in memory.keys() & {"l1", "l2"}:
    cache = memory[level]
    lookups = cache["loads"]
    if level == "l2":
        lookups += cache["fetches"] + cache["atomics"]
    check(f"{level} requests", cache["hits"] + cache["misses"] + cache["merged"],
          lookups)
if "l2" in memory:
    cache = memory["l2"]
    check("requests of TMs", sum(cache[kind] for kind in
                                 ("loads", "stores", "atomics", "fetches"))
          + memory["sent_by_tms_under_way"], memory["sent_by_tms"])
if "dram" in memory:
    dram = memory["dram"]
    for name, value in dram.items():
        if isinstance(value, int) and not name.startswith("max_"):
            check(f"channels' {name}", sum(c[name] for c in dram["channels"]),
                  value)
    check("rows", dram["row_hits"] + dram["row_misses"] + dram["row_conflicts"],
          dram["reads"] + dram["writes"])
    check("latencies", sum(dram["read_latency_histogram"]),
          dram["reads"] + dram["forwarded_reads"])
    sender = "l2s" if "l2" in memory else "tms"
    check("bursts", sum(dram[kind] for kind in
                        ("reads", "writes", "forwarded_reads", "merged_writes",
                         "pending")) + memory[f"sent_by_{sender}_under_way"],
          memory[f"sent_by_{sender}"])
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
