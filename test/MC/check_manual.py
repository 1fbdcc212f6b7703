#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Checks that the manual has one row for every instruction.

usage: check_manual.py TPInstrs.json ISA.md
"""

import json
import re
import sys


def main():
    source, manual = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        records = json.load(file)
    with open(manual, encoding="utf-8") as file:
        rows = re.findall(r"^\| `(\w+)` \|.*` \|$", file.read(), re.MULTILINE)
    expected = sorted(
        records[name]["Mnemonic"]
        for name in records["!instanceof"]["TPInst"]
        if not records[name]["isCodeGenOnly"]
    )
    if sorted(set(rows) & set(expected)) != expected:
        sys.exit(f"missing: {sorted(set(expected) - set(rows))}")
    twice = {row for row in expected if rows.count(row) != 1}
    if twice:
        sys.exit(f"more than once: {sorted(twice)}")


if __name__ == "__main__":
    main()
