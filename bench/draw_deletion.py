#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a deletion in the cache as the final project report did: the table of
slots before and after, and the tree that they hold.

    tpsim --trace-cache trace.json ... stackcached.elf -- slots=12
    bench/draw_deletion.py trace.json deletion.svg"""

import argparse
import pathlib
import sys

from deletion.picture import draw_picture
from deletion.trace import read_trace
from experiment.errors import BenchError


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trace", type=pathlib.Path, metavar="TRACE.json")
    parser.add_argument("picture", type=pathlib.Path, metavar="PICTURE.svg")
    arguments = parser.parse_args()
    try:
        picture = draw_picture(read_trace(arguments.trace))
        arguments.picture.write_text(picture, encoding="utf-8")
    except (BenchError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
