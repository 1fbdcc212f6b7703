#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What tpsim's checkers cost: times as long as the functional mode with
generated code, on the path tracer. All are measured in turn in one run, the
best of several. Fails if there is a report, or with --limits if one costs more
than it may."""

import argparse
import pathlib
import re
import sys
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = (("scenes/cornell/cornell.gltf", "512x512", "4"),
            ("out/scenes/bunny.glb", "512x512", "2"),
            ("out/scenes/conference_room.glb", "256x256", "2"))
# The checkers of --check=, and times the functional mode at most.
CHECKS = {"": None, "memory,init": 6.0, "stack": None, "race": 12.0,
          "memory,init,stack,race": None}


def seconds(tpsim, program, picture, checks):
    scene, size, depth = picture
    command = [tpsim, program, "--functional", "--scene", scene, "--size", size,
               "--depth", depth]
    if checks:
        command.append(f"--check={checks}")
    words = run(command, cwd=ROOT).stderr
    if "fault" in words:
        sys.exit(f"error: --check={checks} reports on {scene}:\n{words}")
    return float(re.search(r"executed in ([0-9.]+) s", words).group(1))


def measure(tpsim, program, picture, repeats):
    """The least seconds of each set of checkers."""
    best = dict.fromkeys(CHECKS, float("inf"))
    for _ in range(repeats):
        for checks in CHECKS:
            best[checks] = min(best[checks],
                               seconds(tpsim, program, picture, checks))
    return best


def show(scene, best):
    """Prints the ratios; gives the sets of checkers that cost too much."""
    print(f"{pathlib.Path(scene).stem}: {best['']:.2f} s without checkers")
    too_dear = []
    for checks, limit in CHECKS.items():
        if not checks:
            continue
        ratio = best[checks] / best[""]
        print(f"  --check={checks:24}{ratio:6.2f} times"
              + (f", at most {limit:g}" if limit else ""))
        if limit and ratio > limit:
            too_dear.append(checks)
    return too_dear


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", type=pathlib.Path,
                        default=ROOT / "build" / "bin")
    parser.add_argument("--picture", nargs=3, action="append",
                        metavar=("SCENE", "SIZE", "DEPTH"))
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--limits", action="store_true")
    arguments = parser.parse_args()
    too_dear = []
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "program.elf"
        run([arguments.bin / "tpcc", "-O3", "-g", "-I", ".",
             "kernels/pathtracer/PathTracer.cpp", "-o", program], cwd=ROOT)
        tpsim = (arguments.bin / "tpsim").resolve()
        for picture in arguments.picture or PICTURES:
            if not (ROOT / picture[0]).exists():
                print(f"{picture[0]}: not there; scripts/scenes.sh makes it")
                continue
            too_dear += show(picture[0], measure(tpsim, program, picture,
                                                 arguments.repeats))
    if arguments.limits and too_dear:
        sys.exit(f"error: too much: {', '.join(too_dear)}")


if __name__ == "__main__":
    main()
