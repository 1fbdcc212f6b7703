#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""How long the debugger takes to say who wrote into a node of a large tree, in
the middle of a frame on 4,096 threads, and what memory its checkpoints need.
With --limits it fails if that takes too long or gives a wrong answer."""

import argparse
import pathlib
import re
import sys
import tempfile
import time

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = "bench/StrayNode.cpp"
NODE = ("((tp::WideBvhNode*)(__tp_launch.Scene + "
        "((tp::SceneHeader*)__tp_launch.Scene)->NodesOffset))[1000]")
# Of a question's whole process, from loading the scene on.
LIMIT = 20.0


class Debuggee:
    """The path tracer with the fault, on a chip and a scene."""

    def __init__(self, arguments, folder):
        self.tools = arguments.bin.resolve()
        self.program = folder / "program.elf"
        self.options = ["--chip", arguments.chip, "--scene", arguments.scene,
                        "--size", arguments.size, "--host-threads", "2"]
        run([self.tools / "tpcc", "-O3", "-g", "-I", ".", SOURCE, "-o",
             self.program], cwd=ROOT)

    def frame(self):
        """Cycles and seconds of the frame without a debugger."""
        result = run([self.tools / "tpsim", self.program, *self.options],
                     cwd=ROOT)
        words = result.stdout + result.stderr
        cycles = re.search(r"^cycles +([0-9,]+)", words, re.M).group(1)
        seconds = re.search(r"^simulated in ([0-9.]+) s", words, re.M).group(1)
        return int(cycles.replace(",", "")), float(seconds)

    def ask(self, *commands):
        """The debugger's words, and the seconds of its whole process."""
        line = [self.tools / "tpdbg", self.program, *self.options, "--batch"]
        for command in commands:
            line += ["-ex", command]
        start = time.monotonic()
        words = run(line, cwd=ROOT).stdout
        return words, time.monotonic() - start


def guilty_place():
    lines = (ROOT / SOURCE).read_text(encoding="utf-8").splitlines()
    line = 1 + next(i for i, line in enumerate(lines) if "// guilty" in line)
    return f"{pathlib.Path(SOURCE).name}:{line}"


def is_late(debuggee, name, *commands):
    """Whether commands that must find the guilty line take too long."""
    words, seconds = debuggee.ask(*commands, "info checkpoints")
    if guilty_place() not in words:
        sys.exit(f"error: not the guilty line:\n{words}")
    checkpoints = re.search(r"(\d+) checkpoints?, (\d+) bytes", words)
    print(f"{name:40}{seconds:7.2f} s, at most {LIMIT:g}; "
          f"{checkpoints.group(1)} checkpoints, "
          f"{int(checkpoints.group(2)) / 2**20:.0f} MiB")
    return seconds > LIMIT


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", type=pathlib.Path,
                        default=ROOT / "build" / "bin")
    parser.add_argument("--chip", default="report-512x8")
    parser.add_argument("--scene", default="out/scenes/conference_room.glb")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--limits", action="store_true")
    arguments = parser.parse_args()
    if not (ROOT / arguments.scene).exists():
        sys.exit(f"error: {arguments.scene} is not there; scripts/scenes.sh "
                 "conference_room makes it")
    with tempfile.TemporaryDirectory() as folder:
        debuggee = Debuggee(arguments, pathlib.Path(folder))
        cycles, seconds = debuggee.frame()
        print(f"frame: {cycles:,} cycles, simulated in {seconds:.2f} s")
        middle = f"goto {cycles // 2}"
        question = f"who-wrote {NODE}.Reserved[0]"
        late = [
            is_late(debuggee, "who wrote into the node (middle)", middle,
                    question),
            is_late(debuggee, "who wrote into the node (end)", "run",
                    question),
            is_late(debuggee, "reverse-continue to the write", middle,
                    f"watch {NODE}.Reserved[0]", "reverse-continue")]
    if arguments.limits and any(late):
        sys.exit("error: too late")


if __name__ == "__main__":
    main()
