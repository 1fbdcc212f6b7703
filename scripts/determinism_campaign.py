#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs kernels in many ways that must make no difference and compares all that
they leave behind byte for byte: the results (an image, or the kernel's variable
`Results`), the standard output and the statistics as JSON. The ways: both
engines, any number of host threads, saved in the middle and restored. Exit
status 1 if anything differs."""

import argparse
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
INPUTS = ROOT / "test/Determinism/Inputs"
PATH_TRACER = ROOT / "kernels/pathtracer/PathTracer.cpp"
KERNELS = {source.stem: source for source in sorted(INPUTS.glob("*.cpp"))}
KERNELS[PATH_TRACER.stem] = PATH_TRACER

ENGINES = ("reference", "jit")
HOST_THREADS = (1, 2, 3, 7)
CHIPS = ("1x1", "4x32", "trax-32x32", "report-512x8-gddr6", "hbm2-256x16")


@dataclasses.dataclass
class Way:
    """A way to run a kernel on a chip."""

    engine: str
    host_threads: int
    options: tuple = ()

    def __str__(self):
        words = [self.engine, f"{self.host_threads} host threads"]
        return ", ".join(words + [str(option) for option in self.options])


@dataclasses.dataclass
class Campaign:
    """What all runs of a campaign share."""

    tools: pathlib.Path
    folder: pathlib.Path
    image_size: str
    failures: int = 0
    runs: int = 0

    def compile(self, name):
        """The kernel as a program for the chip."""
        program = self.folder / f"{name}.elf"
        subprocess.run(
            [self.tools / "tpcc", "-O2", "-DTP_NO_RAY_EVENTS", "-I", ROOT,
             KERNELS[name], "-o", program], check=True)
        return program

    def outputs(self, program):
        """tpsim's options for the files to compare, and those files."""
        statistics = self.folder / "statistics.json"
        results = self.folder / "results"
        if program.stem != PATH_TRACER.stem:
            return ["--stats", statistics, "--dump-memory",
                    f"Results={results}"], [statistics, results]
        image = self.folder / "image.png"
        scene = ROOT / "scenes/cornell/cornell.gltf"
        return ["--stats", statistics, "--scene", scene, "--size",
                self.image_size, "--depth", "2", "-o", image], [statistics, image]

    def run(self, program, chip, way):
        """All that a run leaves behind: name and bytes."""
        options, files = self.outputs(program)
        for file in files:
            file.unlink(missing_ok=True)
        command = [self.tools / "tpsim", program, "--quiet", "--chip", chip,
                   "--engine", way.engine, "--host-threads", way.host_threads,
                   "--per-pc", *options, *way.options]
        result = subprocess.run([str(word) for word in command], check=False,
                                capture_output=True)
        self.runs += 1
        if result.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))} failed:\n"
                     f"{result.stderr.decode()}")
        found = {file.name: file.read_bytes() for file in files}
        found["standard output"] = result.stdout
        return found

    def compare(self, program, chip, way, expected):
        """Runs and says what differs from the expected."""
        found = self.run(program, chip, way)
        for name, content in expected.items():
            if found[name] != content:
                self.failures += 1
                print(f"{program.stem} on {chip}, {way}: {name} differs")


def check(campaign, program, chip, engines, host_threads):
    """All ways of one kernel on one chip; gives its cycles."""
    expected = campaign.run(program, chip, Way(engines[0], host_threads[0]))
    cycles = json.loads(expected["statistics.json"])["run"]["cycles"]
    saved = campaign.folder / "saved"
    middle = ("--checkpoint", saved, "--checkpoint-every", cycles * 5 // 8 + 1)
    for index, engine in enumerate(engines):
        for count in host_threads:
            if (engine, count) != (engines[0], host_threads[0]):
                campaign.compare(program, chip, Way(engine, count), expected)
        # Saved by one engine with some host threads, continued by either with
        # others.
        saved.unlink(missing_ok=True)
        count = host_threads[index % len(host_threads)]
        campaign.compare(program, chip, Way(engine, count, middle), expected)
        for other, restoring in enumerate(engines):
            count = host_threads[(index + other + 1) % len(host_threads)]
            campaign.compare(program, chip,
                             Way(restoring, count, ("--restore", saved)), expected)
    return cycles


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tools", default=ROOT / "build/bin", type=pathlib.Path,
                        help="folder of tpcc and tpsim (default: build/bin)")
    parser.add_argument("--chips", nargs="+", default=CHIPS)
    parser.add_argument("--kernels", nargs="+", default=list(KERNELS),
                        choices=list(KERNELS))
    parser.add_argument("--engines", nargs="+", default=ENGINES)
    parser.add_argument("--host-threads", nargs="+", type=int,
                        default=HOST_THREADS)
    parser.add_argument("--size", default="48x48",
                        help="of the path tracer's image (default: 48x48)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        campaign = Campaign(arguments.tools, pathlib.Path(folder), arguments.size)
        for kernel in arguments.kernels:
            program = campaign.compile(kernel)
            for chip in arguments.chips:
                cycles = check(campaign, program, chip, arguments.engines,
                               arguments.host_threads)
                print(f"{kernel} on {chip}: {cycles} cycles", flush=True)
        print(f"{campaign.runs} runs, {campaign.failures} differences")
        sys.exit(1 if campaign.failures else 0)


if __name__ == "__main__":
    main()
