#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What a change of the simulator costs those who do not use it: the host's
instructions of this build's tpsim over those of another build's, such as of an
earlier commit, for the same runs. Counted by valgrind, so other work on the host
changes nothing; generated code is left out, whose compilation depends on time.
With --limit it fails if a ratio is above it."""

import argparse
import pathlib
import re
import sys
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENE = ("--scene", "scenes/cornell/cornell.gltf", "--size", "96x96")
RUNS = {
    "4x32": ("--chip", "4x32", "--engine", "reference"),
    "report-512x8": ("--chip", "report-512x8", "--engine", "reference"),
    "hbm2-256x16": ("--chip", "hbm2-256x16", "--engine", "reference"),
    "functional": ("--functional", "--engine", "reference"),
}


def instructions(tpsim, program, options):
    result = run(["valgrind", "--tool=cachegrind", "--cache-sim=no",
                  "--cachegrind-out-file=/dev/null", tpsim, program, *options,
                  *SCENE, "--host-threads", "1"], cwd=ROOT)
    counted = re.search(r"I +refs: +([0-9,]+)", result.stderr).group(1)
    return int(counted.replace(",", ""))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("baseline", type=pathlib.Path,
                        help="the other build's tpsim")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin")
    parser.add_argument("--limit", type=float, help="the highest ratio")
    arguments = parser.parse_args()
    tools = arguments.bin.resolve()
    highest = 0
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "program.elf"
        run([tools / "tpcc", "-O3", "kernels/pathtracer/PathTracer.cpp", "-I",
             ".", "-o", program], cwd=ROOT)
        print(f"{'run':14}{'baseline':>12}{'now':>12}{'ratio':>8}  "
              "(million host instructions)")
        for name, options in RUNS.items():
            before, now = (instructions(tpsim, program, options) for tpsim in
                           (arguments.baseline.resolve(), tools / "tpsim"))
            highest = max(highest, now / before)
            print(f"{name:14}{before / 1e6:12.1f}{now / 1e6:12.1f}"
                  f"{now / before:8.3f}")
    if arguments.limit and highest > arguments.limit:
        sys.exit(f"error: {highest:.3f} is above {arguments.limit}")


if __name__ == "__main__":
    main()
