# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The kinds of programs, and one program's comparison."""

import dataclasses
import os
import subprocess

import csmith
import cxx.program
from targets import (
    NATIVE_COMPILERS, SANITIZED, Unusable, native_compilers,
)


def write_csmith(seed, directory):
    path = os.path.join(directory, "program.c")
    try:
        text = csmith.program(seed, directory)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        raise Unusable(f"csmith: {error}") from error
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def write_cxx(seed, directory):
    path = os.path.join(directory, "program.cpp")
    with open(path, "w", encoding="utf-8") as file:
        file.write(cxx.program.program(seed))
    return path


KINDS = {"csmith": write_csmith, "cxx": write_cxx}


@dataclasses.dataclass
class Outcome:
    """Of one program: passed, failed or unusable."""

    kind: str
    seed: int
    result: str
    note: str = ""
    failures: tuple = ()


def native_output(tools, source, compilers, directory):
    """What the native compilers agree on."""
    outputs = {
        compiler: tools.expected(
            source, compiler, directory,
            SANITIZED if compiler == NATIVE_COMPILERS["cpp"][0] else ())
        for compiler in compilers
    }
    if len(set(outputs.values())) != 1:
        raise Unusable("the native compilers disagree")
    return next(iter(outputs.values()))


def modes_of(seed, levels, modes):
    """Which mode each level has: all get their turn over the seeds."""
    return {level: modes[(seed + i) % len(modes)]
            for i, level in enumerate(levels)}


def compare(tools, kind, seed, levels, modes, directory):
    """The outcome of a program, which is written into the directory."""
    try:
        source = KINDS[kind](seed, directory)
        compilers = native_compilers(source)
        # csmith's programs are known to be defined: one compiler is enough
        # for the half of them.
        if kind == "csmith" and seed % 2:
            compilers = compilers[:1]
        expected = native_output(tools, source, compilers, directory)
    except Unusable as reason:
        return Outcome(kind, seed, "unusable", str(reason))
    failures = []
    for level, mode in modes_of(seed, levels, modes).items():
        failure = tools.check(source, level, mode, expected, directory)
        if failure:
            failures.append(failure)
    # A program that is too long for one level is too long.
    if failures and all(f.kind == "endless" for f in failures):
        if len(failures) == len(levels):
            return Outcome(kind, seed, "unusable", "long")
    result = "failed" if failures else "passed"
    return Outcome(kind, seed, result, "; ".join(map(str, failures)),
                   tuple(failures))


def keep(tools, outcome, source, directory):
    """Writes down how to repeat the failures."""
    os.makedirs(directory, exist_ok=True)
    kept = os.path.join(directory, os.path.basename(source))
    with open(source, encoding="utf-8") as file:
        text = file.read()
    with open(kept, "w", encoding="utf-8") as file:
        file.write(text)
    with open(os.path.join(directory, "failures"), "w",
              encoding="utf-8") as file:
        for failure in outcome.failures:
            command = tools.tp_command(kept, failure.level, failure.mode,
                                       "program.elf")
            file.write(f"{failure}\n{' '.join(command)}\n{failure.text}\n\n")
    return kept
