#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Builds BVHs under many sets of float flags, on the simulated chip and natively,
and checks each tree: complete, equal on both, as good as the IEEE tree, and the
right picture when rendered. Prints a table; exit status 1 if anything is wrong.

Two builders: kernels/bvh/BvhBuilder.cpp ("binned") and the textbook's two-pass
builder ("two-pass", kernels/examples/TwoPassBuilder.cpp), which loses triangles
wherever a compiler rounds an expression differently in two places.
"""

import argparse
import concurrent.futures
import dataclasses
import hashlib
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

REASSOCIATE = ["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"]
# By name: tpcc's flags, and clang's where they differ.
FLAG_SETS = {
    "strict": (["-ftp-fp=strict"], ["-ffp-contract=off"]),
    "reproducible": (
        ["-ftp-fp=reproducible"],
        [*REASSOCIATE, "-freciprocal-math", "-fapprox-func", "-ffp-contract=off"]),
    "fast": (["-ftp-fp=fast"], ["-ffast-math"]),
    "fast-math": (["-ffast-math"],),
    "with-infinities": (["-ffast-math", "-fno-finite-math-only"],),
    "model-fast": (["-ffp-model=fast"],),
    "model-aggressive": (["-ffp-model=aggressive"],),
    "unsafe": (["-funsafe-math-optimizations"],),
    "reciprocal": (["-freciprocal-math"],),
    "associative": (REASSOCIATE,),
    "approximate": (["-fapprox-func"],),
    "no-signed-zeros": (["-fno-signed-zeros"],),
    "finite": (["-ffinite-math-only"],),
    "contract": (["-ffp-contract=fast"],),
    "fused": (["-ftp-fp=fast", "-mfma"], ["-ffast-math", "-mfma"]),
}
BUILDERS = {
    "binned": "kernels/bvh/BvhBuilder.cpp",
    "two-pass": "kernels/examples/TwoPassBuilder.cpp",
}
# Scenes in the tree, and the arguments of the scripts that write the others.
CORNELL = ROOT / "scenes/cornell/cornell.gltf"
GENERATED = {
    "tiled-room": ["scenes/tiled_room/make_tiled_room.py"],
    "small-knot": ["scenes/knot/make_knot.py", "80", "24"],
    "knot": ["scenes/knot/make_knot.py"],
}
# What a picture may cost in time: it proves a tree, not a path tracer.
PICTURE = ["--size", "48x48", "--spp", "1", "--depth", "2"]
COST_TOLERANCE = 1e-3


@dataclasses.dataclass
class Outcome:
    """What one run of a builder left."""

    failure: str = ""
    bad_splits: int = 0
    lost: int = 0
    cost: float = 0
    tree: str = ""
    picture: str = ""

    def losses(self):
        if self.failure and not self.lost and not self.bad_splits:
            return "broken"
        return f"{self.bad_splits}/{self.lost}"


def run(command):
    """Runs a command that must succeed."""
    try:
        result = subprocess.run([str(word) for word in command], text=True,
                                capture_output=True, check=False)
    except OSError as error:
        sys.exit(f"error: {error}; build everything first (scripts/build.sh)")
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))}\n"
                 f"{result.stdout}{result.stderr}")
    return result


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else ""


class Compiler:
    """Makes programs of both builders for the chip or for the host."""

    # What does not change: the path tracer, so that the picture shows the tree.
    STRICT = ("kernels/bvhbuilder/BuildAndTrace.cpp",
              "kernels/bvhbuilder/SceneBvh.cpp")

    def __init__(self, command, link, flag_index, folder):
        self.command = [*command, "-O3", "-I", ROOT]
        self.link = link
        self.flag_index = flag_index
        folder.mkdir()
        self.strict_objects = [
            self.compile(source, ["-ffp-contract=off"], folder)
            for source in self.STRICT]

    def compile(self, source, flags, folder):
        target = folder / (pathlib.Path(source).stem + ".o")
        run([*self.command, *flags, "-c", "-o", target, ROOT / source])
        return target

    def build(self, flag_set, builder, folder):
        flags = FLAG_SETS[flag_set][self.flag_index]
        objects = [self.compile(source, flags, folder)
                   for source in (BUILDERS[builder], "kernels/bvh/WideBvh.cpp")]
        program = folder / "program"
        run([*self.link, "-o", program, *self.strict_objects, *objects])
        return program


def chip_compiler(arguments, work):
    tpcc = [arguments.bin / "tpcc", *pass_options(arguments)]
    # -w: builder and path tracer disagree about infinities on purpose.
    return Compiler(tpcc, [*tpcc, "-w", "-O3"], 0, work / "chip")


def native_compiler(arguments, work):
    plugin = arguments.bin.resolve().parent / "lib" / "TPFloatingPoint.so"
    command = [arguments.clang, "-std=c++20", "-fPIC", f"-fplugin={plugin}",
               f"-fpass-plugin={plugin}", *pass_options(arguments),
               "-I", ROOT / "runtime/include"]
    # -Bsymbolic: the runner has a builder of its own.
    return Compiler(command, [arguments.clang, "-shared", "-Wl,-Bsymbolic"], -1,
                    work / "native")


def pass_options(arguments):
    return ["-mllvm", f"-tp-fp-canonicalize={int(arguments.canonicalize)}"]


class Campaign:
    def __init__(self, arguments, work):
        self.bin = arguments.bin.resolve()
        self.work = work
        self.chip = chip_compiler(arguments, work)
        self.native = native_compiler(arguments, work)

    def observe(self, command, scene, folder):
        """Builds and renders one scene."""
        tree, picture = folder / "tree", folder / "picture.png"
        for old in (tree, picture):
            old.unlink(missing_ok=True)
        result = subprocess.run(
            [*map(str, command), "--scene", scene, *PICTURE, "--bvh", "kernel",
             "--bvh-output", tree, "-o", picture],
            text=True, capture_output=True, check=False)
        outcome = Outcome(tree=digest(tree), picture=digest(picture))
        if result.returncode != 0:
            last = result.stderr.strip().splitlines()[-1]
            outcome.failure = last.rpartition("error: ")[2].removeprefix(
                f"{command[1]}: ")
        if found := re.search(r"bad splits: (\d+)", result.stdout):
            outcome.bad_splits = int(found[1])
        if found := re.search(r"\((\d+) triangles lost", result.stderr):
            outcome.lost = int(found[1])
        if found := re.search(r"cost ([0-9.e+]+)$", result.stderr, re.MULTILINE):
            outcome.cost = float(found[1])
        return outcome

    def on_chip(self, program, scene, folder):
        return self.observe(
            [self.bin / "tpsim", program, "--quiet", "--chip", "4x32",
             "--host-threads", "1"], scene, folder)

    def natively(self, library, scene, folder):
        return self.observe(
            [self.bin / "tp-native", library, "--threads", "1"], scene, folder)

    def reference(self, scene, folder):
        """The IEEE builder, and the picture of the tree that the host builds."""
        outcome = self.observe(
            [self.bin / "bvhbuilder-native", "--threads", "1"], scene, folder)
        picture = folder / "host.png"
        run([self.bin / "pathtracer-native", "--scene", scene, *PICTURE,
             "--threads", "1", "-o", picture])
        if outcome.failure or digest(picture) != outcome.picture:
            sys.exit(f"error: {scene}: the reference is broken: "
                     f"{outcome.failure or 'not the picture of the host'}")
        return outcome

    def scene_path(self, name):
        """A scene by name or path; written first if there is a script for it."""
        if name == "cornell":
            return CORNELL
        if name not in GENERATED:
            return pathlib.Path(name)
        path = self.work / f"{name}.glb"
        if not path.exists():
            script, *rest = GENERATED[name]
            run([sys.executable, ROOT / script, path, *rest])
        return path


def problems(flag_set, builder, native, chip, reference):
    """What is wrong, in words."""
    found = [f"{where}: {outcome.failure}" for where, outcome in
             (("native", native), ("chip", chip)) if outcome.failure]
    found += [f"{where}: {outcome.bad_splits} bad splits" for where, outcome in
              (("native", native), ("chip", chip)) if outcome.bad_splits]
    if found:
        return found
    if native.tree != chip.tree:
        found.append("the trees of chip and host differ")
    if chip.picture != reference.picture:
        found.append("the picture is not that of the IEEE tree")
    if builder == "binned":
        if abs(chip.cost / reference.cost - 1) > COST_TOLERANCE:
            found.append(f"cost {chip.cost} instead of {reference.cost}")
        if flag_set == "strict" and chip.tree != reference.tree:
            found.append("the tree is not that of the host")
    return found


def check(campaign, flag_set, builder, scenes, references):
    """One line of the table for each scene, and the number of problems."""
    lines, count = [], 0
    with tempfile.TemporaryDirectory(dir=campaign.work) as name:
        on_chip, on_host = (pathlib.Path(name, part) for part in ("chip", "host"))
        on_chip.mkdir()
        on_host.mkdir()
        program = campaign.chip.build(flag_set, builder, on_chip)
        library = campaign.native.build(flag_set, builder, on_host)
        for scene, path in scenes.items():
            native = campaign.natively(library, path, on_host)
            chip = campaign.on_chip(program, path, on_chip)
            reference = references[scene]
            wrong = problems(flag_set, builder, native, chip, reference)
            count += len(wrong)
            lines.append(
                f"{pathlib.Path(scene).stem:12} {builder:8} {flag_set:16} "
                f"{native.losses():>8} {chip.losses():>8} "
                f"{chip.cost / reference.cost:9.6f}  "
                f"{'ok' if not wrong else '; '.join(wrong)}")
    return lines, count


def runnable_flag_sets():
    """All, but for the one whose native programs need an instruction that the
    host may lack."""
    has_fma = " fma " in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    return [name for name in FLAG_SETS if name != "fused" or has_fma]


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin",
                        help="folder of tpcc, tpsim and the native runners")
    parser.add_argument("--clang", default="clang++-22",
                        help="compiler for the native programs")
    parser.add_argument("--flags", nargs="+", choices=FLAG_SETS, metavar="SET",
                        default=runnable_flag_sets(),
                        help="flag sets (all that this machine can run): "
                             + ", ".join(FLAG_SETS))
    parser.add_argument("--builders", nargs="+", choices=BUILDERS,
                        default=list(BUILDERS), help="(both)")
    parser.add_argument("--scenes", nargs="+", metavar="SCENE",
                        default=["cornell", "tiled-room", "small-knot"],
                        help="cornell, tiled-room, small-knot, knot, or files "
                             "(cornell tiled-room small-knot)")
    parser.add_argument("--no-canonicalize", dest="canonicalize",
                        action="store_false",
                        help="switch the pass off: what stock LLVM does")
    parser.add_argument("--jobs", type=int, default=1, help="at once (1)")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as work:
        campaign = Campaign(arguments, pathlib.Path(work))
        scenes = {name: campaign.scene_path(name) for name in arguments.scenes}
        references = {name: campaign.reference(path, campaign.work)
                      for name, path in scenes.items()}
        print("scene        builder  flags              native     chip      "
              "cost  (bad splits/lost triangles; cost of IEEE = 1)", flush=True)
        total = 0
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for lines, count in pool.map(
                    lambda case: check(campaign, *case, scenes, references),
                    [(flag_set, builder) for flag_set in arguments.flags
                     for builder in arguments.builders]):
                print("\n".join(lines), flush=True)
                total += count
    print(f"{total} problems" if total else "every tree is right")
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
