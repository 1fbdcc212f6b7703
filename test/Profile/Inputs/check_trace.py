# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_trace.py [--range FIRST:END] TRACE [STATISTICS] TM.TP...: spans of each
TP follow each other without a gap, from the first cycle to the end; with
STATISTICS of the same run their sums are those of the thread.
"""

import json
import sys
from collections import Counter

TRACKS_PER_TP = 1024


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def spans_of(events, tm, tracks):
    spans = [event for event in events
             if event["ph"] == "X" and event["pid"] == tm
             and event["tid"] in tracks]
    return sorted(spans, key=lambda span: span["args"]["cycle"])


def end_of(span):
    return span["args"]["cycle"] + span["args"]["cycles"]


def check_spans(spans, first, end):
    at = first
    for span in spans:
        if (span["ts"], span["dur"]) != (span["args"]["cycle"],
                                         span["args"]["cycles"]):
            sys.exit(f"{span}: its time is not that of its cycles")
        if span["args"]["cycle"] != at:
            sys.exit(f"gap before {span}: expected cycle {at}")
        at = end_of(span)
    if at != end:
        sys.exit(f"spans end in cycle {at}, not {end}")


def check_accesses(events, tm, tp):
    """Spans of one track do not overlap."""
    first = tp * TRACKS_PER_TP
    for track in range(first + 1, first + TRACKS_PER_TP):
        at = 0
        for span in spans_of(events, tm, {track}):
            if span["args"]["cycle"] < at:
                sys.exit(f"{span} overlaps the one before")
            at = end_of(span)


def check_sums(spans, statistics, thread):
    found = Counter()
    for span in spans:
        name = "issued" if span["cat"] == "issue" else span["name"]
        found[name] += span["args"]["cycles"]
    threads = statistics["threads"]
    wanted = {"issued": threads["instructions"][thread]}
    if finish := threads["finish_cycle"][thread]:
        wanted["finished"] = statistics["run"]["cycles"] - finish
    if len(threads["instructions"]) == 1:
        wanted.update(statistics["thread_cycles"]["lost"])
    for name, cycles in wanted.items():
        if found[name] != cycles:
            sys.exit(f"thread {thread}: {found[name]} {name}, not {cycles}")


def main():
    arguments = sys.argv[1:]
    cycles = None
    if arguments[0] == "--range":
        cycles = tuple(map(int, arguments[1].split(":")))
        arguments = arguments[2:]
    events = load(arguments.pop(0))["traceEvents"]
    statistics = load(arguments.pop(0)) if cycles is None else None
    for name in arguments:
        tm, tp = map(int, name.split("."))
        spans = spans_of(events, tm, {tp * TRACKS_PER_TP})
        first, end = cycles or (0, statistics["run"]["cycles"])
        check_spans(spans, first, end)
        check_accesses(events, tm, tp)
        if statistics:
            check_sums(spans, statistics,
                       tm * statistics["chip"]["tps_per_tm"] + tp)
    print("all cycles are there")


main()
