#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares pictures of the stack-cached path tracer with the baseline's, byte
for byte: every policy and slot format, caches from 3 slots to whole local
stores, natively and on the simulated chip. Then renders a frame of each with a
small cache whose every deletion is verified. Prints a table; exit status 1 if
a picture differs or anything fails. The column "verified" counts deletions.
"""

import argparse
import concurrent.futures
import dataclasses
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BASELINE = "kernels/pathtracer/PathTracer.cpp"
CACHED = "kernels/stackcache/StackCached.cpp"
VERIFIER = ("kernels/treecache/TreeCacheChecker.cpp",
            "kernels/treecache/TreeCacheVerifier.cpp")

POLICIES = ("HighestBranch", "LeastRecentlyUsed", "KeepTop")
FORMATS = ("FullSlots", "QuantizedSlots")
# In the tree; the others are written by scripts/scenes.sh.
CORNELL = ROOT / "scenes/cornell/cornell.gltf"
SCENES = ("cornell", "bunny", "maple", "conference_room", "engine", "hairball")


@dataclasses.dataclass(frozen=True)
class Variant:
    """One way to compile the stack-cached path tracer."""

    policy: str
    format: str
    checked: bool = False

    def defines(self):
        return [f"-DTP_CACHE_POLICY={self.policy}",
                f"-DTP_CACHE_FORMAT={self.format}",
                *(["-DTP_CACHE_CHECK"] if self.checked else [])]

    def sources(self):
        return [CACHED, *(VERIFIER if self.checked else ())]


@dataclasses.dataclass(frozen=True)
class Cache:
    """How large a cache is: a number of slots, or all that a local store has
    room for."""

    slots: int = 0
    local_store: str = ""

    def __str__(self):
        return f"slots={self.slots}" if self.slots else self.local_store


class Tools:
    """Compilers and runners of one build, for the chip or for the host."""

    def __init__(self, arguments, work):
        self.arguments = arguments
        self.bin = arguments.bin.resolve()
        self.work = work
        self.programs = {}

    def build(self, variant):
        """Compiles the variant, or the baseline if it is None."""
        target = self.work / f"{self.name}-{len(self.programs)}{self.suffix}"
        defines = variant.defines() if variant else []
        sources = variant.sources() if variant else [BASELINE]
        result = run([*self.compiler(), "-I", ROOT, *defines, "-o", target,
                      *(ROOT / source for source in sources)])
        if result.failure:
            sys.exit(f"error: cannot compile {variant or BASELINE}:\n"
                     f"{result.messages}")
        self.programs[variant] = target

    def render(self, variant, scene, cache, picture):
        """Runs a program that was built."""
        command = self.runner(self.programs[variant], cache)
        arguments = ["--scene", scene, "--size", self.size, "-o", picture]
        rest = ["--", f"slots={cache.slots}"] if cache and cache.slots else []
        return run([*command, *arguments, *rest])


class Chip(Tools):
    """The simulated chip."""

    name, suffix = "chip", ".elf"

    def __init__(self, arguments, work):
        super().__init__(arguments, work)
        self.size = arguments.chip_size

    def compiler(self):
        return [self.bin / "tpcc", "-O3"]

    def runner(self, program, cache):
        command = [self.bin / "tpsim", program, "--quiet", "--chip",
                   self.arguments.chip, "--host-threads", "1"]
        if cache and cache.local_store:
            command += ["--set", f"local_store.bytes={cache.local_store}"]
        return command


class Host(Tools):
    """The same sources natively."""

    name, suffix = "native", ".so"

    def __init__(self, arguments, work):
        super().__init__(arguments, work)
        self.size = arguments.native_size

    def compiler(self):
        return [self.arguments.clang, "-std=c++20", "-O3", "-fPIC", "-shared",
                "-Wl,-Bsymbolic", "-ffp-contract=off",
                "-I", ROOT / "runtime/include"]

    def runner(self, program, cache):
        command = [self.bin / "tp-native", program, "--threads", "1"]
        if cache and cache.local_store:
            command += ["--local-store", cache.local_store]
        return command


@dataclasses.dataclass
class Result:
    """What a command said, and why it failed, or an empty text."""

    messages: str
    failure: str


def run(command):
    try:
        result = subprocess.run([str(word) for word in command], text=True,
                                capture_output=True, check=False)
    except OSError as error:
        sys.exit(f"error: {error}; build everything first (scripts/build.sh)")
    if result.returncode == 0:
        return Result(result.stderr, "")
    lines = (result.stderr.strip() or "no message").splitlines()
    errors = [line for line in lines if "error" in line]
    return Result(result.stderr, f"exit status {result.returncode}: "
                                 f"{(errors or lines)[0]}")


@dataclasses.dataclass
class Line:
    """A line of the table: one variant on one scene."""

    scene: str
    place: str
    variant: str
    images: int = 0
    seconds: float = 0
    verified: str = "-"
    problems: list = dataclasses.field(default_factory=list)

    def __str__(self):
        equal = self.images - len(self.problems)
        return (f"{self.scene:16}{self.place:8}{self.variant:36}"
                f"{f'{equal}/{self.images}':>8}  {self.verified:>10}"
                f"{self.seconds:8.1f}")


HEADING = (f"{'scene':16}{'on':8}{'policy, format':36}{'equal':>8}  "
           f"{'verified':>10}{'seconds':>8}")


class Campaign:
    """All variants on one scene at one place."""

    def __init__(self, tools, scene, path, reference):
        self.tools = tools
        self.scene = scene
        self.path = path
        self.reference = reference

    def compare(self, line, variant, cache):
        """Renders, adds what is wrong to the line, and returns what was said."""
        with tempfile.TemporaryDirectory(dir=self.tools.work) as folder:
            picture = pathlib.Path(folder, "picture.png")
            result = self.tools.render(variant, self.path, cache, picture)
            failure = result.failure
            if not failure and picture.read_bytes() != self.reference:
                failure = "the picture is not the baseline's"
        line.images += 1
        if failure:
            kind = ", verified" if variant and variant.checked else ""
            line.problems.append(f"{self.scene}, {self.tools.name}, "
                                 f"{line.variant}, {cache}{kind}: {failure}")
        return result.messages

    def verify(self, line, variant, cache):
        """Renders with every deletion verified, and counts them."""
        messages = self.compare(line, variant, cache)
        count = re.search(r"(\d+) deletions verified", messages)
        line.verified = count[1] if count else "BROKEN"

    def baseline(self):
        line = Line(self.scene, self.tools.name, "baseline")
        start = time.monotonic()
        self.compare(line, None, None)
        line.seconds = time.monotonic() - start
        return line

    def variant(self, policy, slot_format, checked_slots):
        line = Line(self.scene, self.tools.name, f"{policy}, {slot_format}")
        start = time.monotonic()
        for cache in self.tools.arguments.caches:
            self.compare(line, Variant(policy, slot_format), cache)
        if checked_slots:
            self.verify(line, Variant(policy, slot_format, True),
                        Cache(slots=checked_slots))
        line.seconds = time.monotonic() - start
        return line


def reference_picture(arguments, path, size, work):
    """The picture that the native baseline makes."""
    picture = work / "reference.png"
    result = run([arguments.bin.resolve() / "pathtracer-native", "--scene",
                  path, "--size", size, "-o", picture])
    if result.failure:
        sys.exit(f"error: {path}: {result.failure}")
    return picture.read_bytes()


def scene_path(name):
    """A scene by name or by path."""
    if name == "cornell":
        return CORNELL
    if name in SCENES:
        return ROOT / "out/scenes" / f"{name}.glb"
    return pathlib.Path(name)


def lines_of_scene(arguments, places, name, work, pool):
    """The table's lines of one scene, as they are finished."""
    path = scene_path(name)
    tasks = []
    for tools in places:
        reference = reference_picture(arguments, path, tools.size, work)
        campaign = Campaign(tools, pathlib.Path(name).stem, path, reference)
        tasks.append(pool.submit(campaign.baseline))
        tasks += [pool.submit(campaign.variant, policy, slot_format,
                              arguments.checked_slots)
                  for policy, slot_format in itertools.product(
                      arguments.policies, arguments.formats)]
    for task in tasks:
        yield task.result()


def make_places(arguments, work):
    """The places with all their programs."""
    places = [{"native": Host, "chip": Chip}[place](arguments, work)
              for place in arguments.places]
    checks = (False, True) if arguments.checked_slots else (False,)
    for tools in places:
        tools.build(None)
        for choice in itertools.product(arguments.policies, arguments.formats,
                                        checks):
            tools.build(Variant(*choice))
    return places


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--bin", type=pathlib.Path, default=ROOT / "build/bin",
        help="folder of tpcc, tpsim and the native runners")
    add("--clang", default="clang++-22",
        help="compiler for the native programs")
    add("--scenes", nargs="+", metavar="SCENE", default=list(SCENES),
        help="files or " + ", ".join(SCENES) + " (all these)")
    add("--places", nargs="+", choices=("native", "chip"),
        default=["native", "chip"], help="(both)")
    add("--policies", nargs="+", metavar="CLASS", default=list(POLICIES),
        help="(" + ", ".join(POLICIES) + ")")
    add("--formats", nargs="+", metavar="CLASS", default=list(FORMATS),
        help="(" + ", ".join(FORMATS) + ")")
    add("--slots", nargs="*", type=int,
        default=[3, 4, 5, 8, 16, 32, 64, 128],
        help="sizes of caches (3 4 5 8 16 32 64 128)")
    add("--local-stores", nargs="*", metavar="BYTES",
        default=["2KiB", "4KiB", "8KiB", "16KiB", "32KiB"],
        help="local stores that a cache takes whole (2KiB to 32KiB)")
    add("--checked-slots", type=int, default=16,
        help="slots of the verified frame; 0: no such frame (16)")
    add("--native-size", default="256x256", help="of the picture (256x256)")
    add("--chip-size", default="64x64", help="of the picture (64x64)")
    add("--chip", default="4x32", help="chip to simulate (4x32)")
    add("--jobs", type=int, default=1, help="at once (1)")
    arguments = parser.parse_args()
    arguments.caches = [
        *(Cache(slots=slots) for slots in arguments.slots),
        *(Cache(local_store=size) for size in arguments.local_stores)]
    return arguments


def main():
    arguments = parse_arguments()
    problems = []
    images = 0
    with tempfile.TemporaryDirectory() as name, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = pathlib.Path(name)
        places = make_places(arguments, work)
        print(HEADING, flush=True)
        for scene in arguments.scenes:
            for line in lines_of_scene(arguments, places, scene, work, pool):
                print(line, flush=True)
                problems += line.problems
                images += line.images
    print("\n".join(problems) or
          f"all {images} pictures are the baseline's, and every rule is kept")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
