# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs a command once for each case of a program and prints what came of it.

run_cases.py SOURCE COMMAND...: the cases are the words in double quotes behind
`CASE(` in SOURCE; each is appended to COMMAND. Prints the case, the exit status
and standard error, without the cycle and the address of traps.
"""

import re
import subprocess
import sys


def shorten(message):
    message = re.sub(r" \(TM \d+, TP \d+\) trapped at cycle \d+", "", message)
    return re.sub(r"pc 0x[0-9a-f]+ ", "", message)


def main():
    source, *command = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        cases = re.findall(r'CASE\("([^"]+)"', file.read())
    if not cases:
        sys.exit(f"{source}: no CASE(...) in it")
    for case in cases:
        run = subprocess.run([*command, case], capture_output=True, text=True)
        print(f"{case}: {run.returncode}")
        print(run.stdout + shorten(run.stderr), end="", flush=True)


if __name__ == "__main__":
    main()
