# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Instructions per function, from the text of a disassembler."""

import math
import re

LABEL = re.compile(r"^[0-9a-f]+ <(.+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\s")
# The first half of riscv32's far call, which the linker makes one jump.
FAR_CALL = re.compile(r"\tauipc\t(ra|t1),")


def count_instructions(disassembly):
    """By function name. Local labels belong to the function around them."""
    counts, name = {}, None
    for line in disassembly.splitlines():
        label = LABEL.match(line)
        if label and not label.group(1).startswith((".L", "$")):
            name = label.group(1)
            counts[name] = 0
        elif (name and INSTRUCTION.match(line)
              and not FAR_CALL.search(line)):
            counts[name] += 1
    return counts


def geometric_mean(values):
    values = list(values)
    return math.exp(sum(map(math.log, values)) / len(values))
