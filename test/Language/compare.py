#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs a program on the 1x1 chip at every optimization level and compares what
it says with its native run. The program's debug information is verified."""

import argparse
import difflib
import pathlib
import shlex
import subprocess
import sys

LEVELS = ("-O0", "-O1", "-O2", "-O3", "-Os")
NATIVE_COMPILERS = {
    ".c": {"clang": "clang-22", "gcc": "gcc"},
    ".cpp": {"clang": "clang++-22", "gcc": "g++"},
}
# Both sides compute every operation as it is written.
COMMON_OPTIONS = ["-w", "-ffp-contract=off"]
NATIVE_OPTIONS = ["-O1", "-fno-strict-aliasing", "-lm"]


class Failure(Exception):
    """A program that does not compile, or that says something else."""


def run(command, seconds=120):
    try:
        return subprocess.run(
            command, capture_output=True, timeout=seconds, check=False
        )
    except OSError as error:
        raise Failure(f"{command[0]}: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        raise Failure(f"{shlex.join(command)}\nran for {seconds} s") from None


def compile_program(command):
    result = run(command)
    if result.returncode != 0:
        raise Failure(
            f"{shlex.join(command)}\nexit status {result.returncode}\n"
            + result.stderr.decode(errors="replace")
        )


def output_of(command):
    """What a program prints, and the status that it ends with."""
    result = run(command)
    text = result.stdout.decode(errors="replace")
    return f"{text}exit status {result.returncode}\n", result.stderr.decode(
        errors="replace"
    )


def check_equal(expected, command):
    actual, errors = output_of(command)
    if actual == expected:
        return
    lines = difflib.unified_diff(
        expected.splitlines(), actual.splitlines(), "native", "tp", lineterm=""
    )
    raise Failure(shlex.join(command) + "\n" + "\n".join(lines) + "\n" + errors)


def check_debug_information(program):
    text, errors = output_of(["llvm-dwarfdump", "--verify", str(program)])
    if not text.endswith("No errors.\nexit status 0\n"):
        raise Failure(f"{program}: {text}{errors}")


def native_output(source, directory, family, options):
    program = directory / family
    compiler = NATIVE_COMPILERS[source.suffix][family]
    compile_program(
        [compiler, *COMMON_OPTIONS, *options, str(source), "-o", str(program)]
        + NATIVE_OPTIONS
    )
    text, errors = output_of([str(program)])
    if not text.endswith("exit status 0\n"):
        raise Failure(f"{program}: {text}{errors}")
    return text


def compare(arguments):
    arguments.directory.mkdir(parents=True, exist_ok=True)
    texts = [
        native_output(
            arguments.source, arguments.directory, family, arguments.options
        )
        for family in arguments.native.split(",")
    ]
    if any(text != texts[0] for text in texts):
        raise Failure(f"{arguments.source}: the native compilers disagree")
    for level in arguments.levels.split():
        program = arguments.directory / f"tp{level}.elf"
        compile_program(
            ["tpcc", level, "-g", *COMMON_OPTIONS, *arguments.options]
            + ["-mllvm", "-verify-machineinstrs"]
            + [str(arguments.source), "-o", str(program)]
        )
        check_debug_information(program)
        check_equal(texts[0], ["tpsim", "--chip=1x1", "--quiet", str(program)])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("directory", type=pathlib.Path, help="for the programs")
    parser.add_argument(
        "--native", default="clang,gcc", help="compilers of the host"
    )
    parser.add_argument("--levels", default=" ".join(LEVELS))
    arguments, arguments.options = parser.parse_known_args()
    try:
        compare(arguments)
    except Failure as failure:
        sys.exit(f"error: {failure}")


if __name__ == "__main__":
    main()
