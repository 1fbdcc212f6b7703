# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The command line of tp-bisect."""

import argparse
import os
import shlex
from dataclasses import dataclass
from pathlib import Path

from tp_bisect.errors import UserError

_DESCRIPTION = """\
Finds out why a program is good with some compiler flags and bad with others:
the guilty flag, function, instruction and optimizer step, and what mends it.
Works with tpcc and, through the plug-in TPFloatingPoint.so, with clang 22.
"""

_EPILOG = """\
placeholders: {flags} the flags; {out} the program to build; {dir} a folder of
this build; {memory} in the test, what makes tpsim write --compare-memory.
Parallel builds need {out} or {dir} in the build command; without, --jobs is 1.

The test is good if it exits with 0, bad otherwise (125: neither), or, with
--compare-..., if it does as the good build does.

exit status: 0 the culprit is found; 1 an error; 2 good and bad do not differ;
130 stopped by Ctrl-C (the same command goes on from there).

example:
  tp-bisect --good -O2 --bad '-O2 -ffast-math' \\
    --build 'tpcc {flags} prog.cpp -o {out}' --test 'tpsim --chip 1x1 {out}'
"""


@dataclass
class Request:
    """What the user asked for."""

    good: list
    bad: list
    build: str
    test: str
    flags_variable: str
    compiler: str
    compare_output: bool
    compare_image: list
    compare_memory: str
    tolerance: int
    build_timeout: float
    test_timeout: float
    repeat: int
    jobs: int
    work_folder: Path
    report: str
    json: str
    quiet: bool


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise UserError(f"{message} (see --help)")


def _parser():
    parser = _Parser(
        prog="tp-bisect",
        description=_DESCRIPTION,
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--good", required=True, metavar="FLAGS", help="flags that are good")
    add("--bad", required=True, metavar="FLAGS", help="flags that are bad")
    add("--build", required=True, metavar="COMMAND", help="builds the program")
    add("--test", required=True, metavar="COMMAND", help="tests the program")
    add("--flags-variable", default="", metavar="NAME",
        help="give the flags in this environment variable, such as CXXFLAGS")
    add("--compiler", default="", metavar="PROGRAM",
        help="the compiler that the build runs, where its command does not say")
    add("--compare-output", action="store_true",
        help="good is: prints what the good build prints")
    add("--compare-image", action="append", default=[], metavar="PATTERN",
        help="good is: writes the same files, by names in {dir}; PNG, PPM and "
        "PGM are compared by samples")
    add("--compare-memory", default="", metavar="SYMBOL",
        help="good is: leaves the same bytes at a symbol in tpsim's memory")
    add("--tolerance", type=int, default=0, metavar="N",
        help="greatest difference of an image's sample (default: 0)")
    add("--build-timeout", type=float, default=600, metavar="S",
        help="seconds until a build counts as failed (default: 600)")
    add("--test-timeout", type=float, default=60, metavar="S",
        help="seconds until a test counts as bad (default: 60)")
    add("--repeat", type=int, default=2, metavar="N",
        help="tests of the good and the bad build, to notice chance "
        "(default: 2)")
    add("--jobs", type=int, default=0, metavar="N",
        help="builds at a time (default: as many as cores)")
    add("--work-folder", default="tp-bisect.out", metavar="DIR",
        help="where builds and the state live (default: tp-bisect.out)")
    add("--report", default="", metavar="FILE", help="write the report, too")
    add("--json", default="", metavar="FILE", help="write the findings as JSON")
    add("--quiet", action="store_true", help="no progress")
    return parser


def _words(option, text):
    try:
        return shlex.split(text)
    except ValueError as error:
        raise UserError(f"{option} '{text}': {error}") from error


def _join_values(arguments):
    """`--good -O2` as `--good=-O2`: argparse takes -O2 for an option."""
    joined = []
    arguments = iter(arguments)
    for word in arguments:
        if word in ("--good", "--bad"):
            value = next(arguments, None)
            word = word if value is None else f"{word}={value}"
        joined.append(word)
    return joined


def parse(arguments):
    """The request; UserError for what makes no sense."""
    options = vars(_parser().parse_args(_join_values(arguments)))
    options["good"] = _words("--good", options["good"])
    options["bad"] = _words("--bad", options["bad"])
    options["work_folder"] = Path(options["work_folder"])
    options["jobs"] = _jobs(options)
    request = Request(**options)
    _check(request)
    return request


def _jobs(options):
    if options["jobs"] < 0:
        raise UserError("--jobs: expected a number of at least 1")
    is_apart = "{out}" in options["build"] or "{dir}" in options["build"]
    if not is_apart:
        return 1
    return options["jobs"] or os.cpu_count() or 1


def _check(request):
    if "{flags}" not in request.build and not request.flags_variable:
        raise UserError(
            "--build does not say where the flags go: put {flags} into the "
            "command, or name an environment variable with --flags-variable"
        )
    if "{out}" in request.test and "{out}" not in request.build:
        raise UserError("--test names {out}, which --build does not make")
    if request.compare_memory and "{memory}" not in request.test:
        raise UserError(
            "--compare-memory needs {memory} among tpsim's options in --test, "
            "as in 'tpsim {memory} {out}'"
        )
    if "{memory}" in request.test and not request.compare_memory:
        raise UserError("--test names {memory}; say which with --compare-memory")
    for name, least in (("repeat", 1), ("tolerance", 0)):
        if getattr(request, name) < least:
            raise UserError(f"--{name}: expected a number of at least {least}")
