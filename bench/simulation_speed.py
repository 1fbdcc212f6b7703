#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Measures how fast tpsim simulates: million thread-instructions per second.

Runs the demo (Cornell box, 256x256, 1 sample, depth 1, chip report-512x8) with
one and two host threads, in turns, and prints the medians. Run it on an idle
machine after scripts/demo.sh. Not a test: a time fails no one."""

import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run_once(command, host_threads):
    """One run: million thread-instructions per second, as tpsim measured it."""
    result = subprocess.run(
        command + ["--host-threads", str(host_threads)],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    speed = re.search(r"([0-9.]+) million thread-instructions/s", result.stderr)
    if result.returncode != 0 or not speed:
        sys.exit(f"{' '.join(command)} failed:\n{result.stderr}")
    return float(speed.group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path)
    parser.add_argument("--runs", default=5, type=int, help="of each kind (default: 5)")
    parser.add_argument("--chip", default="report-512x8")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--json", help="also write the figures to this file")
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        kernel = pathlib.Path(folder, "pathtracer.elf")
        subprocess.run(
            [arguments.build / "bin/tpcc", "-O3", "-DTP_NO_RAY_EVENTS", "-I", ROOT,
             ROOT / "kernels/pathtracer/PathTracer.cpp", "-o", kernel], check=True)
        command = [
            str(arguments.build / "bin/tpsim"), str(kernel),
            "--chip", arguments.chip,
            "--scene", str(ROOT / "scenes/cornell/cornell.gltf"),
            "--size", arguments.size, "--spp", "1", "--depth", "1"]
        speeds = {1: [], 2: []}
        for _ in range(arguments.runs):
            for host_threads, found in speeds.items():
                found.append(run_once(command, host_threads))

    medians = {count: statistics.median(found) for count, found in speeds.items()}
    print(f"{arguments.chip}, {arguments.size}, median of {arguments.runs} "
          "(lowest, highest), million thread-instructions/s")
    for count, found in speeds.items():
        print(f"  {count} host thread{'s' if count > 1 else ' '}: "
              f"{medians[count]:7.1f} ({min(found):.1f}, {max(found):.1f}), "
              f"{medians[count] / count:7.1f} per host core")
    print(f"  two threads over one: {medians[2] / medians[1]:.2f}")
    if arguments.json:
        pathlib.Path(arguments.json).write_text(
            json.dumps({"chip": arguments.chip, "size": arguments.size,
                        "million_thread_instructions_per_second":
                            {str(count): found for count, found in speeds.items()}},
                       indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
