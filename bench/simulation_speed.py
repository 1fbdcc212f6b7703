#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Measures how fast tpsim simulates, in million thread-instructions per second
of one path-traced scene, and how much memory it takes: both engines and the
functional mode, one and two host threads, chips of 128 to 65,536 TPs, and one
with L1, L2 and GDDR6. Each figure is the median of several runs, taken in turns
so that a busy spell of the machine hits all alike. Run it on an idle machine
after scripts/demo.sh and scripts/scenes.sh. Not a test: a time fails no one."""

import argparse
import dataclasses
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


@dataclasses.dataclass(frozen=True)
class Row:
    """A kind of run, and what it should reach."""

    name: str
    options: tuple
    host_threads: int = 1
    # Runs at the same time, whose speeds are added up.
    copies: int = 1
    # Million thread-instructions per second.
    goal: float = 0
    # Of the speed of another row.
    goal_of: str = ""
    goal_share: float = 0


REPORT = ("--chip", "report-512x8")
LARGE = REPORT + ("--set", "tm.count=8192")
ROWS = (
    Row("reference 512x8", REPORT + ("--engine", "reference"), goal=70),
    Row("reference 512x8, 2 host threads", REPORT + ("--engine", "reference"), 2,
        goal_of="reference 512x8", goal_share=1.8),
    # What the machine has to give two host threads that never wait.
    Row("reference 512x8, 2 runs at once", REPORT + ("--engine", "reference"),
        copies=2),
    Row("jit 512x8", REPORT, goal=140),
    Row("jit 512x8, 2 host threads", REPORT, 2, goal_of="jit 512x8", goal_share=1.8),
    Row("jit 4x32", ("--chip", "4x32"), goal_of="jit 512x8", goal_share=0.8),
    Row("jit 128x32", ("--chip", "128x32"), goal_of="jit 512x8", goal_share=0.8),
    Row("jit 8192x8", LARGE, goal_of="jit 512x8", goal_share=0.7),
    Row("jit 512x8 L1 L2 GDDR6", ("--chip", "report-512x8-gddr6"), goal=35),
    Row("functional 512x8", REPORT + ("--functional",), goal=600),
)


@dataclasses.dataclass
class Measured:
    """Of each run the speed, and the resident memory in MB."""

    speeds: list = dataclasses.field(default_factory=list)
    megabytes: list = dataclasses.field(default_factory=list)


def finish(process, errors, command):
    """Speed and memory of a run, as tpsim and the host's kernel measured them."""
    _, status, usage = os.wait4(process.pid, 0)
    errors.seek(0)
    text = errors.read()
    speed = re.search(r"([0-9.,]+) million thread-instructions/s", text)
    if os.waitstatus_to_exitcode(status) != 0 or not speed:
        sys.exit(f"{' '.join(command)} failed:\n{text}")
    return float(speed.group(1).replace(",", "")), usage.ru_maxrss / 1024


def run_once(command, copies, found):
    """One run, or several at once: the sum of their speeds, the memory of one."""
    started = []
    for _ in range(copies):
        errors = tempfile.TemporaryFile("w+")
        started.append((subprocess.Popen(command, stdout=subprocess.DEVNULL,
                                         stderr=errors), errors, command))
    speeds, megabytes = zip(*(finish(*each) for each in started))
    found.speeds.append(sum(speeds))
    found.megabytes.append(max(megabytes))


def measure(arguments, rows, kernel):
    """All rows, in turns."""
    found = {row.name: Measured() for row in rows}
    common = [str(arguments.build / "bin/tpsim"), str(kernel),
              "--scene", str(arguments.scene), "--size", arguments.size,
              "--spp", str(arguments.spp), "--depth", "1"]
    for _ in range(arguments.runs):
        for row in rows:
            run_once(common + list(row.options)
                     + ["--host-threads", str(row.host_threads)], row.copies,
                     found[row.name])
    return found


def goal_of(row, medians):
    """The speed that the row should reach; 0 if it is measured with no other."""
    if row.goal_of:
        return row.goal_share * medians.get(row.goal_of, 0)
    return row.goal


def print_table(rows, found):
    """One line for each row."""
    medians = {name: statistics.median(each.speeds) for name, each in found.items()}
    print(f"{'':34}{'median':>8}{'lowest':>8}{'highest':>8}{'goal':>8}{'of it':>8}"
          f"{'MB':>8}")
    for row in rows:
        each = found[row.name]
        goal = goal_of(row, medians)
        share = f"{100 * medians[row.name] / goal:6.0f} %" if goal else ""
        print(f"{row.name:34}{medians[row.name]:8.1f}{min(each.speeds):8.1f}"
              f"{max(each.speeds):8.1f}{goal:8.1f}{share:>8}"
              f"{statistics.median(each.megabytes):8.0f}")


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path)
    parser.add_argument("--runs", default=5, type=int, help="of each kind (default: 5)")
    parser.add_argument("--scene", type=pathlib.Path,
                        default=ROOT / "out/scenes/conference_room.glb")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--spp", default=4, type=int)
    parser.add_argument("--rows", default="", metavar="TEXT",
                        help="only the rows whose names contain this")
    parser.add_argument("--json", help="also write the figures to this file")
    arguments = parser.parse_args()
    rows = [row for row in ROWS if arguments.rows in row.name]
    if not rows:
        sys.exit(f"no row's name contains '{arguments.rows}'")
    if not arguments.scene.exists():
        sys.exit(f"{arguments.scene} is missing; scripts/scenes.sh makes it")

    with tempfile.TemporaryDirectory() as folder:
        kernel = pathlib.Path(folder, "pathtracer.elf")
        subprocess.run(
            [arguments.build / "bin/tpcc", "-O3", "-DTP_NO_RAY_EVENTS", "-I", ROOT,
             ROOT / "kernels/pathtracer/PathTracer.cpp", "-o", kernel], check=True)
        found = measure(arguments, rows, kernel)

    print(f"{arguments.scene.name}, {arguments.size}, {arguments.spp} samples, median "
          f"of {arguments.runs}, million thread-instructions/s and resident memory")
    print_table(rows, found)
    if arguments.json:
        pathlib.Path(arguments.json).write_text(
            json.dumps({"scene": arguments.scene.name, "size": arguments.size,
                        "samples": arguments.spp,
                        "rows": {name: dataclasses.asdict(each)
                                 for name, each in found.items()}},
                       indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
