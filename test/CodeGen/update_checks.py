# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the CHECK lines of the given tests anew from llc's output:

    update_checks.py <llc> <libLLVMTP.so> <test.ll>...

The first RUN line says with which options. Read the difference: the lines say
what the code generator does, not what it should do.
"""

import re
import subprocess
import sys


def function_bodies(assembly):
    """The instructions of each function by name, without comments, each with
    whether it follows the one before directly."""
    bodies, name, adjacent = {}, None, False
    for line in assembly.splitlines():
        line = line.split("#")[0].rstrip()
        label = re.match(r"([A-Za-z_]\w*):$", line)
        if label:
            name, adjacent = label.group(1), False
            bodies[name] = []
        elif line.startswith(".Lfunc_end"):
            name = None
        elif name and (
            re.match(r"\t(\.cfi_(?!startproc)|\.zero|[a-z])", line)
            or re.match(r"\.LBB", line)
        ):
            bodies[name].append((re.sub(r"\s+", " ", line.strip()), adjacent))
            adjacent = True
        else:
            adjacent = False
    return bodies


def update(llc, backend, path):
    source = [
        line
        for line in open(path).read().splitlines()
        if not re.match(r"; CHECK", line)
    ]
    run = next(line for line in source if line.startswith("; RUN: %llc_tp"))
    options = re.match(r"; RUN: %llc_tp (.*?) < %s", run).group(1).split()
    command = [llc, "-load", backend, "-mtriple=tp-unknown-elf", *options]
    text = "\n".join(source) + "\n"
    assembly = subprocess.run(
        command, input=text, capture_output=True, text=True, check=True
    ).stdout
    bodies = function_bodies(assembly)
    result = []
    for line in source:
        result.append(line)
        define = re.match(r"define .*?@(\w+)\(", line)
        if define and bodies.get(define.group(1)):
            name = define.group(1)
            result.append(f"; CHECK-LABEL: {name}:")
            for instruction, adjacent in bodies[name]:
                suffix = "-NEXT" if adjacent else ""
                result.append(f"; CHECK{suffix}: {instruction}")
    open(path, "w").write("\n".join(result) + "\n")


if __name__ == "__main__":
    for test in sys.argv[3:]:
        update(sys.argv[1], sys.argv[2], test)
