# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares random programs on the simulated 1x1 chip with their native run,
at every optimization level."""

import argparse
import os
import subprocess
import sys
import tempfile

from campaign import Campaign
from programs import KINDS
from reduction import is_interesting, is_interesting_ir
from targets import LEVELS, MODES, Failure, Tools


def words(allowed):
    """An argument of several words."""

    def parse(text):
        for word in text.split():
            if word not in allowed:
                raise argparse.ArgumentTypeError(
                    f"'{word}' is not one of {' '.join(allowed)}")
        return text.split()

    return parse


def natural(text):
    value = int(text)
    if value < 0:
        raise ValueError
    return value


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="fuzz-compiler.sh",
                                     description=__doc__)
    parser.add_argument("csmith", type=natural, nargs="?", default=100,
                        help="programs of csmith (default 100)")
    parser.add_argument("--cxx", type=natural,
                        help="programs of the C++ generator (default: a "
                             "quarter as many)")
    parser.add_argument("--first", type=natural, default=1,
                        help="seed (default 1)")
    parser.add_argument("--levels", type=words(LEVELS), default=LEVELS)
    parser.add_argument("--modes", type=words(MODES), default=list(MODES),
                        help="how the program is linked, in turn: "
                             + " ".join(MODES))
    parser.add_argument("--keep", default="out/fuzz",
                        help="directory for the log and failing programs")
    parser.add_argument("--resume", action="store_true",
                        help="go on after the programs in the log")
    parser.add_argument("--reduce", type=natural, default=5,
                        help="make so many failing programs small (default 5)")
    parser.add_argument("--reduction-seconds", type=natural, default=900,
                        help="for each (default 900)")
    parser.add_argument("--print", choices=KINDS,
                        help="print the program of --first and end")
    parser.add_argument("--jobs", type=natural, default=os.cpu_count())
    parser.add_argument("--tools", default="build/bin",
                        help="directory of tpcc and tpsim")
    # How a reduction asks whether a program still fails.
    for name in ("--interesting", "--level", "--mode", "--failure",
                 "--signature", "--parts"):
        parser.add_argument(name, default="", help=argparse.SUPPRESS)
    return parser.parse_args(joined_levels(arguments))


def joined_levels(arguments):
    """With "--levels -O2" as one word: alone, -O2 looks like an option."""
    if "--levels" in arguments[:-1]:
        i = arguments.index("--levels")
        arguments = (arguments[:i] + [f"--levels={arguments[i + 1]}"]
                     + arguments[i + 2:])
    return arguments


def check_interesting(options):
    tools = Tools(options.tools, options.parts)
    wanted = Failure(options.failure, options.level, options.mode,
                     options.signature)
    source = options.interesting
    if source.endswith((".c", ".cpp")):
        with tempfile.TemporaryDirectory() as directory:
            return is_interesting(tools, source, wanted, directory)
    return is_interesting_ir(tools, source, wanted)


def print_program(options):
    with tempfile.TemporaryDirectory() as directory:
        source = KINDS[options.print](options.first, directory)
        with open(source, encoding="utf-8") as file:
            sys.stdout.write(file.read())


def main(arguments):
    options = parse_arguments(arguments)
    if options.print:
        print_program(options)
        return True
    for name in ("tpcc", "tpsim"):
        if not os.access(os.path.join(options.tools, name), os.X_OK):
            raise FileNotFoundError(f"{options.tools}/{name} is missing; run "
                                    "scripts/build.sh")
    if options.interesting:
        return check_interesting(options)
    if options.cxx is None:
        options.cxx = (options.csmith + 3) // 4
    tools = Tools(options.tools, os.path.join(options.keep, "parts"),
                  options.modes)
    campaign = Campaign(tools, options)
    campaign.run("csmith", options.csmith)
    campaign.run("cxx", options.cxx)
    return campaign.report(KINDS)


if __name__ == "__main__":
    try:
        sys.exit(0 if main(sys.argv[1:]) else 1)
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(1)
