#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds a comparison against the statistics that it compares.

usage: check_comparison.py BEFORE AFTER COMPARISON
"""

import json
import sys
from collections import Counter


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def uses(statistics):
    """Thread-cycles by reason."""
    cycles = statistics["thread_cycles"]
    return Counter(issued=cycles["issued"], **cycles["lost"])


def lines(statistics):
    """Thread-cycles by line and reason."""
    counts = Counter()
    for entry in statistics["instructions_by_pc"]:
        place = (entry.get("function", ""), entry.get("file", ""),
                 entry.get("line", 0))
        counts[place, "issued"] += entry["executed"]
        for reason, cycles in entry["lost"].items():
            counts[place, reason] += cycles
    return counts


def check(what, expected, found):
    if expected != found:
        sys.exit(f"error: {what}: {found} instead of {expected}")


def check_changes(entry, before, after):
    """Holds a counted entry against the counts by reason of both runs."""
    for reason in set(before) | set(after):
        pair = (before[reason], after[reason])
        found = entry["counts_by_reason"].get(
            reason, {"before": 0, "after": 0, "change": 0})
        check(reason, (*pair, pair[1] - pair[0]),
              (found["before"], found["after"], found["change"]))
    for side in ("before", "after", "change"):
        check(f"sum of {side}", entry["counts"][side],
              sum(part[side] for part in entry["counts_by_reason"].values()))


def of_place(counts, place):
    return Counter({reason: cycles for (where, reason), cycles in counts.items()
                    if where == place})


def check_lines(comparison, before, after):
    found = set()
    for entry in comparison["lines"]:
        place = (entry["function"], entry["file"], entry.get("line", 0))
        found.add(place)
        check_changes(entry, of_place(before, place), of_place(after, place))
    check("lines", {place for place, _ in {**before, **after}}, found)


def check_sum(comparison, kind):
    """All places and the halted threads are the whole."""
    for side in ("before", "after", "change"):
        halted = comparison["counts_by_reason"].get("finished", {side: 0})[side]
        check(f"{side} of {kind}", comparison["counts"][side],
              halted + sum(e["counts"][side] for e in comparison[kind]))


def main():
    before, after, comparison = map(load, sys.argv[1:])
    check_changes(comparison, uses(before), uses(after))
    check_lines(comparison, lines(before), lines(after))
    check_sum(comparison, "lines")
    check_sum(comparison, "functions")


main()
