#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What tpsim --profile costs: times as long as the cycle mode, on the path
tracer, on a chip without and one with caches. Processor time is measured, which
other work on the host disturbs least, both in turn in one run, the best of
several. With --limit it fails if a profile costs more."""

import argparse
import pathlib
import resource
import sys
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHIPS = ("report-512x8", "hbm2-256x16")
PICTURES = (("scenes/cornell/cornell.gltf", "192x192"),
            ("out/scenes/conference_room.glb", "128x128"))


def seconds(tpsim, program, chip, picture, options):
    scene, size = picture
    command = [tpsim, program, "--chip", chip, "--scene", scene, "--size", size,
               "--depth", "2", "--host-threads", "1", *options]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run(command, cwd=ROOT)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def measure(tpsim, program, chip, picture, repeats):
    """The least seconds without and with a profile."""
    best = [float("inf")] * 2
    for _ in range(repeats):
        for number, options in enumerate(((), ("--profile",))):
            best[number] = min(best[number], seconds(tpsim, program, chip,
                                                     picture, options))
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path)
    parser.add_argument("--repeats", default=3, type=int)
    parser.add_argument("--limit", type=float,
                        help="times the cycle mode at most")
    arguments = parser.parse_args()
    tpsim = arguments.build.resolve() / "bin" / "tpsim"
    worst = 0
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "pathtracer.elf"
        run([arguments.build.resolve() / "bin" / "tpcc", "-O3", "-g", "-I",
             ROOT, ROOT / "kernels/pathtracer/PathTracer.cpp", "-o", program])
        for picture in PICTURES:
            if not (ROOT / picture[0]).exists():
                print(f"{picture[0]} is not there (scripts/scenes.sh makes it)")
                continue
            for chip in CHIPS:
                without, profiled = measure(tpsim, program, chip, picture,
                                            arguments.repeats)
                ratio = profiled / without
                worst = max(worst, ratio)
                print(f"{pathlib.Path(picture[0]).stem} on {chip}: "
                      f"{without:.2f} s, with --profile {profiled:.2f} s, "
                      f"{ratio:.2f} times")
    if arguments.limit and worst > arguments.limit:
        sys.exit(f"error: more than {arguments.limit} times")


main()
