# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Executes the same script in gdb, on a program of the host, and in tpdbg, and
compares the lines of the source that both show.

usage: compare_steps.py <script> <host program> <tpdbg command...>
"""

import re
import subprocess
import sys

SOURCE_LINE = re.compile(r"^(?:0x[0-9a-f]+\t|\(gdb\) )*(\d+\t.*)$")


def source_lines(command):
    """The source lines that a debugger prints."""
    output = subprocess.run(
        command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
        timeout=60, check=False).stdout
    matches = (SOURCE_LINE.match(line) for line in output.splitlines())
    return [match.group(1) for match in matches if match]


def main():
    script, program, tpdbg = sys.argv[1], sys.argv[2], sys.argv[3:]
    expected = source_lines(
        ["gdb", "-q", "-nx", "--batch", "-ex", "set debuginfod enabled off",
         "-x", script, program])
    found = source_lines(tpdbg + ["--batch", "-x", script])
    if len(expected) < 20:
        sys.exit(f"gdb shows only {len(expected)} lines")
    for number, (one, other) in enumerate(zip(expected, found)):
        if one != other:
            sys.exit(f"stop {number}: gdb shows '{one}', tpdbg '{other}'")
    if len(expected) != len(found):
        sys.exit(f"gdb shows {len(expected)} lines, tpdbg {len(found)}")
    print(f"{len(found)} lines are the same")


if __name__ == "__main__":
    main()
