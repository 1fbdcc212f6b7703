# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_profile.py PROFILE STATISTICS FOLDED SPEEDSCOPE: everything that was
written of one run adds up to the same.

STATISTICS is what --stats --per-pc has written of that run.
"""

import json
import sys
from collections import Counter


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def check(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found}, not {wanted}")


def counts(entry, issued):
    return Counter({"issued": entry[issued], **entry["lost"]})


def sum_of(entries, issued="instructions"):
    result = Counter()
    for entry in entries:
        result.update(counts(entry, issued))
    return +result


def folded_counts(path):
    result = Counter()
    with open(path, encoding="utf-8") as file:
        for line in file:
            stack, cycles = line.rsplit(" ", 1)
            result[stack.rsplit(";", 1)[1].strip("[]")] += int(cycles)
    return result


def speedscope_counts(speedscope):
    result = Counter()
    for profile in speedscope["profiles"]:
        check("samples", len(profile["samples"]), len(profile["weights"]))
        check("end", profile["endValue"], sum(profile["weights"]))
        for stack in profile["samples"]:
            for frame in stack:
                speedscope["shared"]["frames"][frame]
        result[profile["name"]] = sum(profile["weights"])
    return result


def check_instructions(profile, statistics):
    by_pc = {entry["pc"]: entry for entry in statistics["instructions_by_pc"]}
    check("addresses", [entry["pc"] for entry in profile["instructions"]],
          list(by_pc))
    for entry in profile["instructions"]:
        known = by_pc[entry["pc"]]
        check(f"executed at {entry['pc']}", entry["executed"],
              known["executed"])
        check(f"lost at {entry['pc']}", entry["lost"], known["lost"])
        served = sum(level["accesses"]
                     for level in entry.get("served", {}).values())
        if served > entry.get("global", 0):
            sys.exit(f"{entry['pc']}: more answers than accesses")


def check_dram(served, accesses, dram):
    rows = {level: count for level, count in served.items()
            if level.startswith("dram_row_")}
    check("bursts read", sum(rows.values()), dram["reads"])
    check("bursts in queues", served["dram_queue"],
          accesses - dram["reads"])
    for kind, row in (("hit", "hits"), ("miss", "misses"),
                      ("conflict", "conflicts")):
        if rows.get(f"dram_row_{kind}", 0) > dram[f"row_{row}"]:
            sys.exit(f"row {row}: more than DRAM had")


def check_memory(profile, statistics):
    """What a level that is asked first served is what it says itself."""
    served = Counter()
    for entry in profile["instructions"]:
        for level, counts_there in entry.get("served", {}).items():
            served[level] += counts_there["accesses"]
    accesses = sum(entry.get("global", 0) for entry in profile["instructions"])
    if "memory" not in statistics:
        stores = sum(entry.get("global", 0)
                     for entry in profile["instructions"]
                     if entry["text"].startswith("s"))
        check("served by memory", served,
              Counter({"memory": accesses - stores}))
        return
    if "l1" not in statistics["memory"]:
        check_dram(served, accesses, statistics["memory"]["dram"])
        return
    first = statistics["memory"]["l1"]
    check("accesses", accesses,
          first["loads"] + first["stores"] + first["atomics"])
    check("served by the L1", served["l1"], first["hits"])


def check_utilisation(profile, whole):
    tms = profile["utilisation"]
    finished = profile["run"]["finished"]
    check("utilisation", sum_of(tms["chip"]),
          +(whole + Counter({"finished": finished})))
    waits = sum(whole[reason] for reason in
                ("memory", "l1", "l2", "dram", "store_buffer"))
    for name, wanted in (("issued", whole["issued"]), ("memory", waits),
                         ("finished", finished)):
        check(f"TMs of {name}", len(tms[name]), profile["run"]["tm_count"])
        check(f"sum of {name}", sum(map(sum, tms[name])), wanted)
    check("order of intervals", sorted(set(tms["ends"])), tms["ends"])
    check("last interval", tms["ends"][-1], profile["run"]["cycles"])


def main():
    profile, statistics = load(sys.argv[1]), load(sys.argv[2])
    run = profile["run"]
    check("thread-cycles", run["thread_cycles"],
          run["cycles"] * run["tm_count"] * run["tps_per_tm"])
    whole = sum_of(profile["instructions"], "executed")
    check("sum of instructions", whole.total() + run["finished"],
          run["thread_cycles"])
    lost = Counter(statistics["thread_cycles"]["lost"])
    check("finished", run["finished"], lost.pop("finished"))
    check("losses", +(whole - Counter({"issued": whole["issued"]})), +lost)
    check("sum of call tree", sum_of(profile["call_tree"]), whole)
    check("sum of stacks", folded_counts(sys.argv[3]), whole)
    speedscope = speedscope_counts(load(sys.argv[4]))
    check("all of speedscope", speedscope.pop("thread-cycles"), whole.total())
    check("speedscope", speedscope, whole)
    check_instructions(profile, statistics)
    check_memory(profile, statistics)
    check_utilisation(profile, whole)
    print("everything adds up")


main()
