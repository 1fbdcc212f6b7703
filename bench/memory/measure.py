#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Measures what a program sees of a chip's memory system and holds it against
the chip file: the bandwidth of a stream of loads against the DRAM's peak less
refresh, and the latency of dependent loads over their working set, whose steps
must be at the sizes of L1 and L2 and of the heights that docs/memory-system.md
gives. Draws the latencies. Exit status 1 if a figure is not as it should be."""

import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "bench/memory"
# So many misses under way that they do not limit the stream.
STREAM_SETTINGS = ("tm.count=128", "l2.miss_registers=1024")
CHASE_SETTINGS = ("tm.count=64",)
MOST_BELOW_PEAK = 0.03


def settings(values):
    """tpsim's options that set these."""
    return [word for value in values for word in ("--set", value)]


def read_chip(tools, chip):
    """The numbers of the resolved chip file by their paths, such as l1.bytes."""
    text = subprocess.run([tools / "tpsim", "--print-chip", "--chip", chip],
                          check=True, capture_output=True, text=True).stdout
    numbers, path = {}, []
    for line in text.splitlines():
        found = re.match(r"( *)([a-z0-9_]+): *(.*)", line)
        if not found:
            continue
        path = path[:len(found[1]) // 2] + [found[2]]
        if re.fullmatch(r"[0-9.]+", found[3]):
            numbers[".".join(path)] = float(found[3])
    return numbers


class Dram:
    """Figures of the chip's DRAM in cycles of the chip."""

    def __init__(self, chip):
        self.chip = chip
        self.ticks_per_cycle = self.of("clock_khz") / (chip["clock_ghz"] * 1e6)

    def of(self, key):
        """A value of the DRAM file."""
        return self.chip["memory.dram." + key]

    def peak(self):
        """Bytes per cycle of all channels, less the time of refreshes."""
        busy = self.of("burst_bytes") / self.of("burst_ticks")
        refresh = self.of("ticks.rfc") / self.of("ticks.refi")
        return busy * self.of("channels") * self.ticks_per_cycle * (1 - refresh)

    def read(self, *before):
        """Cycles of a read of an idle channel that needs these commands."""
        ticks = (sum(self.of("ticks." + name) for name in before)
                 + self.of("ticks.cl") + self.of("burst_ticks"))
        return (math.ceil(ticks / self.ticks_per_cycle)
                + self.of("controller_cycles"))


def compile_kernel(tools, folder, name):
    """A kernel of this folder as a program for the chip."""
    program = folder / f"{name}.elf"
    subprocess.run([tools / "tpcc", "-O2", "-I", ROOT, FOLDER / f"{name}.cpp",
                    "-o", program], check=True)
    return program


def measure_stream(tools, folder, chip_name):
    """Bytes per cycle that DRAM gave over the whole run."""
    program = compile_kernel(tools, folder, "Streaming")
    output = folder / "statistics.json"
    subprocess.run([tools / "tpsim", program, "--quiet", "--chip", chip_name,
                    "--stats", output, *settings(STREAM_SETTINGS)], check=True)
    found = json.loads(output.read_text(encoding="utf-8"))
    return found["memory"]["dram"]["bytes"] / found["run"]["cycles"]


def measure_chase(tools, folder, chip_name):
    """Pairs of working set in bytes and cycles per load."""
    program = compile_kernel(tools, folder, "PointerChase")
    result = subprocess.run([tools / "tpsim", program, "--quiet", "--chip", chip_name,
                             *settings(CHASE_SETTINGS)],
                            check=True, capture_output=True, text=True)
    return [(int(size), int(cycles) / 100)
            for size, cycles in re.findall(r"(\d+) (\d+)", result.stdout)]


def expected_latencies(chip):
    """Of L1, L2 and DRAM the least and greatest latency of a load."""
    header = math.ceil(chip["crossbar.header_bytes"]
                       / chip["crossbar.request_bytes_per_cycle"])
    data = math.ceil(chip["l1.sector_bytes"] / chip["crossbar.answer_bytes_per_cycle"])
    l1 = chip["l1.latency_cycles"]
    l2 = (l1 + header - 1 + data - 1 + 2 * chip["crossbar.latency_cycles"]
          + chip["l2.latency_cycles"])
    dram = Dram(chip)
    # A command can come a tick late, and a read behind a refresh.
    return {"L1": (l1, l1), "L2": (l2, l2),
            "DRAM": (l2 + dram.read("rcd_read") - 1,
                     l2 + dram.read("rp", "rcd_read") + 3)}


def level_of(chip, size):
    """The level that holds a working set."""
    if size <= chip["l1.bytes"]:
        return "L1"
    return "L2" if size <= chip["l2.bytes"] else "DRAM"


def check_chase(chip, points):
    """What is not as expected. Small rings are measured with the clock's
    overhead: 8 % and a load's share of 64 cycles are allowed."""
    errors = []
    expected = expected_latencies(chip)
    for size, cycles in points:
        least, most = expected[level_of(chip, size)]
        most = 1.08 * most + 64 / (size / 64)
        if not least <= cycles <= most:
            errors.append(f"{size} bytes: {cycles} cycles per load, expected "
                          f"{least} to {most:.1f}")
    return errors


def draw(chip, chip_name, points, path):
    """The latencies, with the sizes and heights of the chip file."""
    import matplotlib  # pylint: disable=import-outside-toplevel
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "memory-latency"
    from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
    figure, axes = pyplot.subplots(figsize=(7, 4))
    axes.plot([size / 1024 for size, _ in points], [cycles for _, cycles in points],
              "o-", color="#1f5fa8", markersize=4)
    for level in ("l1", "l2"):
        size = chip[f"{level}.bytes"] / 1024
        axes.axvline(size, color="#999999", linestyle="--", linewidth=1)
        axes.annotate(f" {level.upper()} {size:.0f} KiB", (size, 0.97),
                      xycoords=("data", "axes fraction"), va="top")
    for level, (least, most) in expected_latencies(chip).items():
        axes.axhspan(least, max(most, least + 0.5), color="#e8a33d", alpha=0.5,
                     linewidth=0, label=f"{level} by the chip file: {least:.0f}"
                     + (f" to {most:.0f}" if most > least else ""))
    axes.set_xscale("log", base=2)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("working set in KiB")
    axes.set_ylabel("cycles per load")
    axes.set_title(f"Dependent loads on {chip_name}")
    axes.legend(loc="lower right")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tools", default=ROOT / "build/bin", type=pathlib.Path,
                        help="folder of tpcc and tpsim (default: build/bin)")
    parser.add_argument("--chip", default="report-512x8-gddr6",
                        help="a chip with L1, crossbar, L2 and DRAM")
    parser.add_argument("--picture", type=pathlib.Path, help="draw it into this SVG")
    arguments = parser.parse_args()
    chip = read_chip(arguments.tools, arguments.chip)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        stream = measure_stream(arguments.tools, folder, arguments.chip)
        points = measure_chase(arguments.tools, folder, arguments.chip)
    peak = Dram(chip).peak()
    print(f"stream: {stream:.1f} bytes per cycle, {100 * stream / peak:.1f} % of the "
          f"DRAM file's peak less refresh, {peak:.1f}")
    for size, cycles in points:
        print(f"{size / 1024:8.0f} KiB {cycles:8.2f} cycles per load "
              f"({level_of(chip, size)})")
    errors = check_chase(chip, points)
    if not (1 - MOST_BELOW_PEAK) * peak <= stream <= peak:
        errors.append(f"the stream is not within {100 * MOST_BELOW_PEAK:.0f} % of "
                      "the peak")
    if arguments.picture:
        draw(chip, arguments.chip, points, arguments.picture)
    for error in errors:
        print(f"measure.py: {error}", file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
