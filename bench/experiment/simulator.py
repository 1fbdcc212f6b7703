# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles the kernels and runs them on the simulated chip. Each finished run
stays on disk under a key of everything that its result depends on."""

import dataclasses
import hashlib
import json
import subprocess
import time

from .errors import BenchError

RUN_VERSION = 1


@dataclasses.dataclass
class Run:
    """What a run left."""

    statistics: dict
    # Host seconds, with loading the scene and building its tree.
    seconds: float
    image_digest: str
    key: str
    was_kept: bool = True


def digest(path):
    """SHA-256 of a file's bytes, in hexadecimal."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def execute(command):
    """Runs a command that must succeed; what it printed."""
    words = [str(word) for word in command]
    try:
        result = subprocess.run(words, text=True, capture_output=True,
                                check=False)
    except OSError as error:
        raise BenchError(f"{error}; build everything first "
                         "(scripts/build.sh)") from error
    if result.returncode != 0:
        raise BenchError(f"{' '.join(words)}\nended with status "
                         f"{result.returncode}:\n{result.stderr}")
    return result.stdout


class Simulator:
    """Runs configurations of one chip and picture; `folder` keeps the results."""

    def __init__(self, root, binaries, folder, chip, picture):
        self.root = root
        self.binaries = binaries
        self.folder = folder
        self.chip = chip
        self.picture = picture
        self.tpsim = binaries / "tpsim"
        self.tpsim_digest = None
        self.programs = {}
        self.scenes = {}
        (folder / "runs").mkdir(parents=True, exist_ok=True)

    def compile(self, kernel):
        """Makes the kernel's program, which run() expects."""
        name = kernel.name.replace(", ", "-")
        program = self.folder / f"{name}.elf"
        execute([self.binaries / "tpcc", "-O3", "-I", self.root,
                 *kernel.defines, self.root / kernel.source, "-o", program])
        self.programs[kernel] = program, digest(program)

    def add_scene(self, name, path):
        """Makes a scene's file known by its name."""
        if not path.is_file():
            raise BenchError(f"{path}: no such scene; scripts/scenes.sh makes "
                             "those that are not in the tree")
        self.scenes[name] = path, digest(path)

    def scene_bytes(self, name):
        return self.scenes[name][0].stat().st_size

    def chip_arguments(self, configuration):
        settings = [word for setting in configuration.settings
                    for word in ("--set", setting)]
        return ["--chip", self.chip, *settings]

    def key(self, configuration):
        """The same for two runs only if they leave the same statistics."""
        self.check_simulator()
        chip = execute([self.tpsim, *self.chip_arguments(configuration),
                        "--print-chip"])
        parts = [str(RUN_VERSION), self.tpsim_digest, chip,
                 self.programs[configuration.kernel][1],
                 self.scenes[configuration.scene][1], *self.picture]
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:24]

    def check_simulator(self):
        """One simulator makes all runs."""
        found = digest(self.tpsim)
        if self.tpsim_digest not in (None, found):
            raise BenchError(f"{self.tpsim} was rebuilt meanwhile; start again")
        self.tpsim_digest = found

    def kept(self, key):
        """The run of an earlier call; None if there is none."""
        path = self.folder / "runs" / f"{key}.json"
        if not path.is_file():
            return None
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
            return Run(found["statistics"], found["seconds"],
                       found["image_digest"], key)
        except (ValueError, KeyError) as error:
            raise BenchError(f"{path}: not a run's result ({error}); "
                             "delete it") from error

    def run(self, configuration):
        """A run's result, from disk or from the simulator."""
        key = self.key(configuration)
        if found := self.kept(key):
            return found
        runs = self.folder / "runs"
        statistics, image = runs / f"{key}.stats", runs / f"{key}.png"
        start = time.monotonic()
        execute([self.tpsim, self.programs[configuration.kernel][0], "--quiet",
                 "--host-threads", "1", *self.chip_arguments(configuration),
                 "--scene", self.scenes[configuration.scene][0], *self.picture,
                 "-o", image, "--stats", statistics])
        seconds = time.monotonic() - start
        run = Run(json.loads(statistics.read_text(encoding="utf-8")),
                  round(seconds, 3), digest(image), key, was_kept=False)
        self.keep(run, configuration)
        statistics.unlink()
        return run

    def keep(self, run, configuration):
        """Writes the run's file at once or not at all."""
        path = self.folder / "runs" / f"{run.key}.json"
        unfinished = path.with_suffix(".part")
        unfinished.write_text(json.dumps(
            {"configuration": str(configuration), "seconds": run.seconds,
             "image_digest": run.image_digest, "statistics": run.statistics},
            indent=1) + "\n", encoding="utf-8")
        unfinished.replace(path)
