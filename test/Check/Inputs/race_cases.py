# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares what tpsim --check=race says of each case of race_cases.cpp with
what its author and ThreadSanitizer say.

    race_cases.py <program.elf> [<native program with ThreadSanitizer>]
"""

import subprocess
import sys

TPSIM = ["tpsim", "--chip", "1x1", "--set", "tm.tps=4", "--functional",
         "--quiet"]


def run(command):
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def races_on_chip(program, case):
    result = run([*TPSIM, "--check=race", program, "--", case])
    found = "data-race" in result.stderr
    if found != (result.returncode != 0):
        sys.exit(f"{case}: status {result.returncode}\n{result.stderr}")
    return found


def races_natively(program, case):
    """Which accesses meet depends on the host's schedule: three tries."""
    return any(run([program, case]).returncode != 0 for _ in range(3))


def main(program, native=None):
    lines = run([*TPSIM, program]).stdout.split("\n")[:-1]
    for line in lines:
        case, _, races = line.partition(" ")
        verdicts = [races == "races", races_on_chip(program, case)]
        if native and case != "fences":
            verdicts.append(races_natively(native, case))
        if len(set(verdicts)) != 1:
            sys.exit(f"{case}: author, tpsim, ThreadSanitizer say {verdicts}")
    print(f"{len(lines)} cases agree")


if __name__ == "__main__":
    main(*sys.argv[1:])
