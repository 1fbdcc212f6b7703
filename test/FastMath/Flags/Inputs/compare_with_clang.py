# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the floating-point IR of tpcc with that of clang for another target.

usage: compare_with_clang.py source.cpp file-with-options

Each line of the file is a set of options. Prints where the instructions, their
fast-math flags or the floating-point attributes differ.
"""

import difflib
import re
import subprocess
import sys

# What tpcc assumes where the user says nothing.
TPCC_DEFAULTS = [
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-strict-float-cast-overflow",
]
RAW_IR = ["-S", "-emit-llvm", "-O1", "-Xclang", "-disable-llvm-passes", "-o", "-"]
INSTRUCTION = re.compile(
    r"^\s+(?:%\S+ = )?(?:tail )?(f(?:add|sub|mul|div|neg|cmp|ptosi)\b[^%]*|"
    r"select[^%]*|call [^@]*@llvm\.(?:f|experimental\.constrained)[^(]*)"
)
DEFINITION = re.compile(r"^define .*?@(\w+)\(")
ATTRIBUTE = re.compile(r"strictfp|\"denormal-fp-math\w*\"=\"[^\"]*\"")


def floating_point(ir):
    """The lines of IR that say how arithmetic is compiled."""
    lines = []
    for line in ir.splitlines():
        definition = DEFINITION.match(line)
        instruction = INSTRUCTION.match(line)
        if definition:
            lines.append(definition.group(1))
        elif instruction:
            lines.append("  " + " ".join(instruction.group(1).split()))
        elif line.startswith("attributes"):
            lines += ATTRIBUTE.findall(line)
    return lines


def compile_with(compiler, options, source):
    command = [*compiler, *options, *RAW_IR, source]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        sys.exit(run.stderr)
    return floating_point(run.stdout)


def main():
    source, option_file = sys.argv[1:]
    clang = ["clang", "--target=x86_64-unknown-elf", *TPCC_DEFAULTS]
    differ = False
    with open(option_file, encoding="utf-8") as lines:
        option_sets = [line.split() for line in lines if line.strip()]
    for options in option_sets:
        expected = compile_with(clang, options, source)
        actual = compile_with(["tpcc"], options, source)
        if not any("fmul" in line or "constrained" in line for line in actual):
            sys.exit(f"no arithmetic found under {' '.join(options)}")
        if expected != actual:
            differ = True
            print("differs under", " ".join(options))
            print("\n".join(difflib.unified_diff(expected, actual, "clang", "tpcc")))
    sys.exit(differ)


main()
