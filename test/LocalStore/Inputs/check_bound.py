# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Checks that the linker's bound of a program's stack is exact.

usage: check_bound.py PROGRAM.elf tpcc ARGUMENT...

Links the program twice: with the linker's own bound it must end with status 0;
with 16 bytes less the stack pointer must fall below the limit.
"""

import re
import subprocess
import sys


def run(*command):
    return subprocess.run(command, capture_output=True, text=True)


def link(program, command, *options):
    linked = run(*command, *options, "-o", program)
    if linked.returncode != 0:
        sys.exit(f"cannot link: {linked.stderr}")
    return linked.stderr


def simulate(program):
    return run("tpsim", "--chip", "1x1", "--quiet", program)


def bound_of(program):
    symbols = run("llvm-nm", program).stdout
    return int(re.search(r"^(\w+) A __tp_stack_bytes$", symbols, re.M)[1], 16)


def main():
    program, *command = sys.argv[1:]
    link(program, command)
    bound = bound_of(program)
    result = simulate(program)
    if result.returncode != 0:
        sys.exit(f"status {result.returncode} with {bound} bytes: {result.stderr}")

    warning = link(program, command, f"-Wl,-z,stack-size={bound - 16}")
    if f"the stack may take {bound} bytes, more than" not in warning:
        sys.exit(f"no warning of {bound - 16} bytes: {warning}")
    result = simulate(program)
    if "stack overflow: the stack pointer fell to" not in result.stderr:
        sys.exit(f"{bound} bytes are more than the stack takes")


if __name__ == "__main__":
    main()
