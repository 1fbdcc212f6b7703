#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Simulated cycles and instructions of the kernels, to compare compilers.

Path tracer, stack-cached path tracer and BVH builder on the chips 4x32 and
report-512x8. They do not vary from run to run. With --baseline, the figures of
an earlier run's --json, the ratio to them is printed too."""

import argparse
import json
import math
import pathlib
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHIPS = ("4x32", "report-512x8")
CORNELL = "scenes/cornell/cornell.gltf"
BUNNY = "out/scenes/bunny.glb"
PICTURES = ((CORNELL, "64x64", "4"), (BUNNY, "64x64", "1"))
TRACERS = {
    "path tracer": ["kernels/pathtracer/PathTracer.cpp"],
    "stack-cached": ["kernels/stackcache/StackCached.cpp"],
}
BUILDER = ["kernels/bvhbuilder/BuildBvh.cpp", "kernels/bvhbuilder/SceneBvh.cpp",
           "kernels/bvh/BvhBuilder.cpp", "kernels/bvh/WideBvh.cpp"]


class Bench:
    def __init__(self, arguments, folder):
        self.tpcc = arguments.bin / "tpcc"
        self.tpsim = (arguments.tpsim or arguments.bin / "tpsim").resolve()
        self.flags = arguments.flags
        self.folder = folder

    def compile(self, sources):
        program = self.folder / "program.elf"
        run([self.tpcc, "-O3", *self.flags, "-I", ".", *sources, "-o", program],
            cwd=ROOT)
        return program

    def simulate(self, program, chip, scene, *options):
        path = self.folder / "statistics.json"
        run([self.tpsim, program, "--quiet", "--chip", chip, "--scene", scene,
             *options, "--stats", path], cwd=ROOT)
        figures = json.loads(path.read_text(encoding="utf-8"))["run"]
        return figures["cycles"], figures["instructions"]

    def measure(self):
        """Yields (name, cycles, instructions)."""
        for name, sources in TRACERS.items():
            program = self.compile(sources)
            for scene, size, depth in PICTURES:
                for chip in CHIPS:
                    yield (f"{name}, {pathlib.Path(scene).stem}, {chip}",
                           *self.simulate(program, chip, scene, "--size", size,
                                          "--spp", "1", "--depth", depth))
        program = self.compile(BUILDER)
        for chip in CHIPS:
            yield (f"builder, cornell, {chip}",
                   *self.simulate(program, chip, CORNELL, "--bvh", "kernel"))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin")
    parser.add_argument("--tpsim", type=pathlib.Path,
                        help="simulator, if not that of --bin")
    parser.add_argument("--json", type=pathlib.Path,
                        help="also write the figures to this file")
    parser.add_argument("--baseline", type=pathlib.Path)
    parser.add_argument("flags", nargs="*", help="of the compiler, behind --")
    arguments = parser.parse_args()

    baseline = (json.loads(arguments.baseline.read_text(encoding="utf-8"))
                if arguments.baseline else {})
    figures = {}
    ratios = []
    with tempfile.TemporaryDirectory() as folder:
        for name, cycles, instructions in Bench(
                arguments, pathlib.Path(folder)).measure():
            figures[name] = [cycles, instructions]
            line = f"{name:36}{cycles:12,}{instructions:14,}"
            if name in baseline:
                ratios.append([new / old for new, old in
                               zip(figures[name], baseline[name])])
                line += f"{ratios[-1][0]:8.4f}{ratios[-1][1]:8.4f}"
            print(line, flush=True)
    if ratios:
        print(f"{'geometric mean':62}" + "".join(
            f"{math.prod(column) ** (1 / len(column)):8.4f}"
            for column in zip(*ratios)))
    if arguments.json:
        arguments.json.write_text(json.dumps(figures, indent=1) + "\n",
                                  encoding="utf-8")


if __name__ == "__main__":
    main()
