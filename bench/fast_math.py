#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Measures what fast math gains on the chip, and how much of that is kept when
the bits no longer depend on context.

Simulated cycles and instructions of the path tracer, the BVH builders and some
loops (bench/FloatLoops.cpp) under strict float rules, stock fast math (the pass
tp-fp-canonicalize switched off) and ours. The gain kept is (strict - ours) /
(strict - stock). Simulated cycles do not vary from run to run, but they do with
the allocation of registers, by more than fast math gains in the path tracer and
the builders: these are compiled in several ways, and geometric means compared."""

import argparse
import json
import math
import pathlib
import sys
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent

STOCK = ["-mllvm", "-tp-fp-canonicalize=0"]
INFINITIES = ["-ffast-math", "-fno-finite-math-only"]
FLAG_SETS = {
    "strict": ["-ftp-fp=strict"],
    "stock": ["-ffast-math", *STOCK],
    "fast": ["-ftp-fp=fast"],
    "stock-inf": [*INFINITIES, *STOCK],
    "fast-inf": INFINITIES,
    "reproducible": ["-ftp-fp=reproducible"],
}
# Ours, and the stock compiler's set of flags to compare with.
COMPARED = {"fast": "stock", "fast-inf": "stock-inf", "reproducible": "stock-inf"}

# Ways to compile the kernels: each places spills elsewhere.
VARIANTS = [
    ["-O3"],
    ["-Os"],
    ["-O3", "-mllvm", "-greedy-reverse-local-assignment=0"],
    ["-O3", "-mllvm", "-enable-misched=0"],
    ["-O3", "-mllvm", "-regalloc=basic"],
]

BVH = ["kernels/bvhbuilder/BuildBvh.cpp", "kernels/bvhbuilder/SceneBvh.cpp",
       "kernels/bvh/WideBvh.cpp"]
CORNELL = ROOT / "scenes/cornell/cornell.gltf"
# Below this share of the strict cycles, stock's gain is noise of the schedule.
LEAST_GAIN = 0.005


class Bench:
    def __init__(self, binaries, folder):
        self.binaries = binaries
        self.folder = folder

    def compile(self, sources, flags):
        program = self.folder / "program.elf"
        run([self.binaries / "tpcc", *flags, "-I", ROOT,
             *(ROOT / source for source in sources), "-o", program])
        return program

    def simulate(self, program, chip, *options):
        return run([self.binaries / "tpsim", program, "--quiet",
                    "--chip", chip, *options]).stdout

    def statistics(self, program, chip, *options):
        """(cycles, instructions) of a whole run."""
        path = self.folder / "statistics.json"
        self.simulate(program, chip, *options, "--stats", path)
        summary = json.loads(path.read_text(encoding="utf-8"))["run"]
        return summary["cycles"], summary["instructions"]

    def kernel(self, sources, flags, chip, *options):
        """(cycles, instructions) for each variant."""
        return [self.statistics(self.compile(sources, [*variant, *flags]), chip,
                                *options)
                for variant in VARIANTS]

    def kernels(self, flags, size, scene):
        return {
            "path tracer": self.kernel(
                ["kernels/pathtracer/PathTracer.cpp"], flags, "report-512x8",
                "--scene", CORNELL, "--size", size, "--spp", "1", "--depth", "4"),
            "builder": self.kernel(
                [*BVH, "kernels/bvh/BvhBuilder.cpp"], flags, "1x1",
                "--scene", scene, "--bvh", "kernel"),
            "two-pass builder": self.kernel(
                [*BVH, "kernels/examples/TwoPassBuilder.cpp"], flags, "1x1",
                "--scene", scene, "--bvh", "kernel"),
        }

    def loops(self, flags):
        """[(cycles, instructions)] of each loop."""
        program = self.compile(["bench/FloatLoops.cpp"], ["-O3", *flags])
        found = {}
        for line in self.simulate(program, "1x1").splitlines():
            name, cycles, instructions, _ = line.split()
            found[name] = [(int(cycles), int(instructions))]
        return found

    def write_scene(self):
        """A mesh on which the two-pass builder does not fail."""
        scene = self.folder / "knot.glb"
        run([sys.executable, ROOT / "scenes/knot/make_knot.py", scene,
             "80", "24"])
        return scene


def mean(measures, index):
    """The geometric mean of the cycles (0) or instructions (1)."""
    return math.exp(math.fsum(math.log(m[index]) for m in measures)
                    / len(measures))


def gain_kept(strict, stock, ours):
    """None where stock gains nothing that could be kept."""
    if strict - stock < LEAST_GAIN * strict:
        return None
    return (strict - ours) / (strict - stock)


def print_measures(results, quantity, index):
    print(f"\n{quantity}".ljust(18) + "".join(
        f"{name:>14}" for name in FLAG_SETS))
    for kernel, by_flags in results.items():
        print(f"{kernel:17}" + "".join(
            f"{mean(by_flags[name], index):14,.0f}" for name in FLAG_SETS))


def print_gains(results):
    """Speed-ups over strict, the gain kept in cycles, and totals."""
    others = list(FLAG_SETS)[1:]
    print("\nstrict cycles over those of        " + "".join(
        f"{name:>14}" for name in others))
    for kernel, by_flags in results.items():
        print(f"{kernel:35}" + "".join(
            f"{mean(by_flags['strict'], 0) / mean(by_flags[name], 0):14.3f}"
            for name in others))
        if len(by_flags["strict"]) > 1:
            print(f"{'  by variant, from':35}" + "".join(
                f"{min(speed_ups(by_flags, name)):14.3f}" for name in others))
            print(f"{'  to':35}" + "".join(
                f"{max(speed_ups(by_flags, name)):14.3f}" for name in others))
    print("\ngain kept, of the stock compiler's " + "".join(
        f"{name:>14}" for name in COMPARED))
    for kernel, by_flags in results.items():
        cells = []
        for ours, stock in COMPARED.items():
            kept = gain_kept(*(mean(by_flags[name], 0)
                               for name in ("strict", stock, ours)))
            cells.append("stock gains 0" if kept is None else f"{kept:.0%}")
        print(f"{kernel:35}" + "".join(f"{cell:>14}" for cell in cells))
    print(f"{'all, by geometric mean':35}" + "".join(
        f"{mean_gain_kept(results, ours):14.0%}" for ours in COMPARED))


def speed_ups(by_flags, name):
    """Over strict, one for each variant."""
    return [strict[0] / other[0]
            for strict, other in zip(by_flags["strict"], by_flags[name])]


def mean_gain_kept(results, ours):
    """With logarithms of cycles, so that every kernel weighs alike."""
    def total(name):
        return math.fsum(math.log(mean(r[name], 0)) for r in results.values())
    strict = total("strict")
    return (strict - total(ours)) / (strict - total(COMPARED[ours]))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin")
    parser.add_argument("--size", default="256x256",
                        help="of the path tracer's picture (256x256)")
    parser.add_argument("--json", help="also write the figures to this file")
    arguments = parser.parse_args()

    results = {}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.bin, pathlib.Path(folder))
        scene = bench.write_scene()
        for name, flags in FLAG_SETS.items():
            for kernel, figures in {
                    **bench.kernels(flags, arguments.size, scene),
                    **bench.loops(flags)}.items():
                results.setdefault(kernel, {})[name] = figures
    print_measures(results, "cycles", 0)
    print_measures(results, "instructions", 1)
    print_gains(results)
    if arguments.json:
        pathlib.Path(arguments.json).write_text(
            json.dumps(results, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
