# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Gives every command of tpdbg arguments that make no sense. Whatever it says
to them, it must go on and end as it was told.

usage: bad_arguments.py <tpdbg command...>
"""

import re
import subprocess
import sys

ARGUMENTS = [
    "", "0", "-1", "1", "4294967296", "18446744073709551616", "0x", "$", "$$9",
    "*", "*0", "*0xffffffff", "nosuch", "nosuch.cpp:3", "tour.cpp:0",
    "tour.cpp:99999", "tour.cpp:nosuch", ":", ":3", "+99999", "-99999", "make",
    "shapes::", "make if", "make if Value", "make thread 99", "thread",
    "thread 9.9", "1 = 2", "Pool", "Pool[-1]", "Pool[99999999]", "&Pool[1", "(",
    "*(int *)0", "*(int *)0xffffffff", "{int} 3", "{float} &Pool", "Used / 0",
    "Used % 0", "Used << 99", "Used before", "Used before 99999999",
    "Used before -1", "r0 = 7", "$pc = 0", "$r40", "$sp 1 2 3", "0 1 2 300",
    "-r", "-r 0 0", "-r &Pool 0", "-l", "-l 5", "/", "/q 1", "/999999999x 0",
    "/4294967296i $pc", "1-", "3-1", "1-99999999", "all", "apply", "apply all",
    "apply all apply all print 1", "find", "\"", "'", "\\", "a\tb", "é",
    "print print", "listsize 0", "listsize -1", "var", "var 5 = 6",
    "register", "memory", "memory 0x10000", "substitute-path", "print nosuch",
    "on", "off", "a.b.c", "Root->", "Root->Nosuch", "sizeof", "sizeof(nosuch)",
    "(nosuch)1", "1 ? 2", "-" * 300, "(" * 300, "9" * 300,
]
END = "the end of all commands"


def output_of(tpdbg, lines):
    return subprocess.run(tpdbg, input="\n".join(lines) + "\n", text=True,
                          errors="backslashreplace",
                          capture_output=True, timeout=120, check=False)


def commands(tpdbg):
    """Those of help, but quit, and the ones of info and set."""
    listed = output_of(tpdbg, ["help", "help info", "help set"]).stdout
    names = re.findall(r"^  ([a-z][a-z-]+(?: [a-z-]+)?) {2,}", listed, re.M)
    if len(names) < 60:
        sys.exit(f"error: only {len(names)} commands are listed:\n{listed}")
    return [name for name in names if name != "quit"]


def main():
    tpdbg = sys.argv[1:]
    for command in commands(tpdbg):
        lines = ["tbreak make", "run"]
        for argument in ARGUMENTS:
            separator = "" if argument.startswith("/") else " "
            lines += [command + separator + argument, "end"]
        result = output_of(tpdbg, lines + [f"echo {END}\\n"])
        if result.returncode not in (0, 1) or END not in result.stdout:
            sys.exit(f"error: '{command}' ended with {result.returncode}:\n"
                     f"{result.stdout[-2000:]}{result.stderr[-2000:]}")


if __name__ == "__main__":
    main()
