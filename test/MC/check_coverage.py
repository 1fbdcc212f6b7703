#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Checks that every instruction of the TP has its assembler tests.

usage: check_coverage.py TPInstrs.json TEST-DIRECTORY

An instruction is covered if a file in TEST-DIRECTORY/encoding that also does
the round trip has lines `# CHECK: <statement> # encoding: [<4 bytes>]` for it,
with every bit of its operands' fields once 0 and once 1. Special registers
have to occur in the statements of mfsr, aliases and macros in aliases.s.
Names what is missing and exits with 1.
"""

import json
import os
import re
import sys

CHECK = re.compile(
    r"^# CHECK: (\S+)(.*?) # encoding: \[(0x\w\w),(0x\w\w),(0x\w\w),(0x\w\w)\]$"
)
ROUND_TRIP = ("tp-objdump --assembly", "cmp %t.o %t.again.o")


def read_tests(directory):
    """Statements and words by mnemonic, of files with the round trip."""
    tests = {}
    for name in sorted(os.listdir(directory)):
        with open(os.path.join(directory, name), encoding="utf-8") as file:
            lines = file.read().splitlines()
        runs = "\n".join(line for line in lines if line.startswith("# RUN:"))
        if not all(step in runs for step in ROUND_TRIP):
            continue
        for line, statement in zip(lines, lines[1:]):
            match = CHECK.match(line)
            if not match or statement != match[1] + match[2]:
                continue
            word = sum(int(match[3 + i], 16) << 8 * i for i in range(4))
            tests.setdefault(match[1], []).append((statement, word))
    return tests


def uncovered_bits(record, words):
    """The varying bits of an instruction that no test has as 0, or as 1."""
    missing = []
    for position, bit in enumerate(record["Inst"]):
        if bit in (0, 1):
            continue
        if len({word >> position & 1 for word in words}) < 2:
            missing.append(position)
    return missing


def main():
    source, directory = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        records = json.load(file)
    tests = read_tests(os.path.join(directory, "encoding"))
    missing = []

    special = [
        records[name]["Name"]
        for name in records["!instanceof"]["TPSpecialRegister"]
    ]
    for name in records["!instanceof"]["TPInst"]:
        record = records[name]
        if record["isCodeGenOnly"]:
            continue
        mnemonic = record["Mnemonic"]
        found = tests.get(mnemonic)
        if not found:
            missing.append(f"{mnemonic}: no encoding and round trip test")
            continue
        operands = {a[0]["def"] for a in record["InOperandList"]["args"]}
        if "sreg" in operands:
            tested = {statement.split()[-1] for statement, _ in found}
            missing += [
                f"{mnemonic}: no test of special register {register}"
                for register in special
                if register not in tested
            ]
            continue
        bits = uncovered_bits(record, [word for _, word in found])
        if bits:
            missing.append(f"{mnemonic}: bits {bits} never vary in the tests")

    with open(os.path.join(directory, "aliases.s"), encoding="utf-8") as file:
        statements = {
            line.split()[0] for line in file if line[:1].isalpha()
        }
    aliases = {
        re.split(r"[\s]", records[name]["AsmString"])[0]
        for name in records["!instanceof"]["InstAlias"]
    } | {
        records[name]["Mnemonic"] for name in records["!instanceof"]["TPMacro"]
    }
    missing += [
        f"{alias}: not in aliases.s" for alias in sorted(aliases - statements)
    ]

    for line in missing:
        print(line, file=sys.stderr)
    sys.exit(1 if missing else 0)


if __name__ == "__main__":
    main()
