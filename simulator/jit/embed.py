#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the bytes of a file as elements of a C array.

usage: embed.py INPUT OUTPUT
"""

import sys

BYTES_PER_LINE = 20


def main():
    source, target = sys.argv[1:]
    with open(source, "rb") as file:
        contents = file.read()
    with open(target, "w", encoding="ascii") as file:
        for begin in range(0, len(contents), BYTES_PER_LINE):
            line = contents[begin : begin + BYTES_PER_LINE]
            file.write(",".join(str(byte) for byte in line) + ",\n")


main()
