# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Steps over or into lines from main on, and as often back: each step back must
come to the cycle and the instruction at which the step forward began.

usage: step_and_back.py <step or next> <count> <tpdbg command...>
"""

import re
import subprocess
import sys

SHOW = ["cycle", "info registers pc", r"echo shown\n"]
MOMENT = re.compile(r"^(?:Cycle|Instruction) (\d+),.*?^pc +(0x[0-9a-f]+)",
                    re.M | re.S)


def moments(tpdbg, commands):
    """Where the program is at first and behind each of the commands."""
    lines = ["tbreak main", "run", r"echo shown\n", *SHOW]
    for command in commands:
        lines += [command, *SHOW]
    output = subprocess.run(tpdbg, input="\n".join(lines) + "\n", text=True,
                            capture_output=True, timeout=60, check=True).stdout
    return [MOMENT.search(part).groups()
            for part in output.split("shown\n")[1:-1]]


def main():
    step, count, tpdbg = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    visited = moments(tpdbg, [step] * count + [f"reverse-{step}"] * count)
    forward, backward = visited[:count + 1], visited[count:]
    if len(set(forward)) != count + 1:
        sys.exit(f"the program does not take {count} steps")
    for number, (there, back) in enumerate(zip(forward, reversed(backward))):
        if there != back:
            sys.exit(f"step {number} began in {there}, back in {back}")
    print(f"{count} steps are undone")


if __name__ == "__main__":
    main()
