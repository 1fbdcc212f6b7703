#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws the course of a run.

    tpsim --interval 10000 --interval-output course.csv ... kernel.elf
    bench/draw_intervals.py course.csv course.svg"""

import argparse
import pathlib
import sys

from experiment.errors import BenchError
from intervals.picture import draw_picture
from intervals.series import read_series


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("series", type=pathlib.Path, metavar="SERIES.csv")
    parser.add_argument("picture", type=pathlib.Path, metavar="PICTURE.svg")
    arguments = parser.parse_args()
    try:
        picture = draw_picture(read_series(arguments.series))
        arguments.picture.write_text(picture, encoding="utf-8")
    except (BenchError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
