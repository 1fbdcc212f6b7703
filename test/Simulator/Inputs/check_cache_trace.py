# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""check_cache_trace.py FILE: checks that a traced deletion is one."""

import json
import sys


def check(condition, what):
    if not condition:
        sys.exit(what)


def check_tree(slots):
    """Pointers and parents agree; returns the loaded slots."""
    loaded = {i for i, slot in enumerate(slots) if slot["loaded"]}
    pointed = {}
    for number in loaded:
        slot = slots[number]
        expected = 4 if slot["type"] == "interior" else 1
        check(len(slot["pointers"]) == expected, f"pointers of slot {number}")
        for pointer in slot["pointers"]:
            if pointer["to"] == "slot":
                pointed[pointer["slot"]] = number
    for number in loaded:
        parent = slots[number]["parent"]
        check(pointed.get(number) == parent, f"parent of slot {number}")
        depth = 0 if parent is None else slots[parent]["depth"] + 1
        check(slots[number]["depth"] == depth, f"depth of slot {number}")
    check(set(pointed) <= loaded, "a pointer to a free slot")
    return loaded


with open(sys.argv[1], encoding="utf-8") as file:
    trace = json.load(file)

before, after = trace["before"], trace["after"]
freed, path = trace["freed"], trace["path"]
check(len(before) == len(after) == trace["slots"], "number of slots")
check(check_tree(before) - set(freed) == check_tree(after), "what was freed")
top = freed[0]
for number in set(freed) - {top}:
    while number != top:
        number = before[number]["parent"]
        check(number is not None, "a freed slot outside the branch")
check(path and before[path[0]]["parent"] is None, "the path does not begin at the root")
for above, below in zip(path, path[1:]):
    check(after[below]["parent"] == above, "the path is interrupted")
# Nothing changes but the freed slots and the pointer to them.
holder = before[top]["parent"]
for number in set(range(len(before))) - set(freed) - {holder}:
    check(before[number] == after[number], f"slot {number} has changed")
changed = [
    new
    for old, new in zip(before[holder]["pointers"], after[holder]["pointers"])
    if old != new
]
kind = before[top]["type"]
expected = {"to": "memory", "type": kind, "reference": before[top]["source"]}
check(changed == [expected], f"pointers of slot {holder}")
