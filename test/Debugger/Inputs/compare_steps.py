# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Executes the same script in gdb, on a program of the host, and in tpdbg, and
compares the lines of the source that both show. gdb records the run, in order
to go back.

usage: compare_steps.py <script> <host program> <tpdbg command...>
"""

import pathlib
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


def lines_in_gdb(script, program):
    """Those of a run that is recorded from its first stop on."""
    commands = ["set debuginfod enabled off"]
    for line in pathlib.Path(script).read_text(encoding="utf-8").splitlines():
        commands += [line, "record"] if line == "run" else [line]
    return source_lines(
        ["gdb", "-q", "-nx", "--batch", program]
        + [word for line in commands for word in ("-ex", line)])


def main():
    script, program, tpdbg = sys.argv[1], sys.argv[2], sys.argv[3:]
    expected = lines_in_gdb(script, program)
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
