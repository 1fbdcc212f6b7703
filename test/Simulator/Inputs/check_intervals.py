# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_intervals.py LENGTH SERIES.csv TRACE.json STATISTICS.json: checks that
the intervals of a run add up to its statistics, and that the trace is the same
series."""

import csv
import json
import sys


def check(what, actual, expected):
    if actual != expected:
        sys.exit(f"{what}: {actual} instead of {expected}")


length = int(sys.argv[1])
with open(sys.argv[2], encoding="utf-8", newline="") as file:
    rows = list(csv.DictReader(file))
with open(sys.argv[3], encoding="utf-8") as file:
    events = json.load(file)["traceEvents"]
with open(sys.argv[4], encoding="utf-8") as file:
    statistics = json.load(file)

run, chip = statistics["run"], statistics["chip"]
window = chip["arbitration_window_cycles"]
check("first cycle", int(rows[0]["begin_cycle"]), 0)
check("last cycle", int(rows[-1]["end_cycle"]), run["cycles"])
for row, following in zip(rows, rows[1:]):
    begin, end = int(row["begin_cycle"]), int(row["end_cycle"])
    wanted = (begin // length + 1) * length
    check("end of an interval", end, -(-wanted // window) * window)
    check("begin of an interval", int(following["begin_cycle"]), end)


def total(column):
    return sum(int(row[column]) for row in rows)


check("instructions", total("instructions"), run["instructions"])
for reason, cycles in statistics["thread_cycles"]["lost"].items():
    check(reason, total(f"lost_{reason}"), cycles)
for level, counts in statistics.get("memory", {}).items():
    if not isinstance(counts, dict):
        continue
    columns = [name for name in counts if f"{level}_{name}" in rows[0]
               and isinstance(counts[name], int)]
    if not columns:
        sys.exit(f"no column of {level}")
    for name in columns:
        check(f"{level}_{name}", total(f"{level}_{name}"), counts[name])

counters = [event for event in events if event["ph"] == "C"]
issued = [event for event in counters if event["name"] == "thread-cycles (%)"]
check("intervals and the end in the trace", len(issued), len(rows) + 1)
for event, row in zip(issued, rows):
    check("time", round(event["ts"] * chip["clock_ghz"] * 1000),
          int(row["begin_cycle"]))
    shares = sum(event["args"].values())
    if abs(shares - 100) > 1e-6:
        sys.exit(f"shares of the thread-cycles add up to {shares}")
print("all intervals agree")
