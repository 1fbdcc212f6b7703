# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Evaluates random floating-point functions in several contexts, at every
optimization level, on the TP and natively, and compares the bits."""

import argparse
import concurrent.futures
import os
import sys
import tempfile
import time

from comparison import compare
from functions import random_function
from program import CONTEXTS
from reduction import evaluate, keep, reduce
from targets import FLAG_SETS, LEVELS, TARGETS, Configuration, Failure, Tools

BATCH = 100


def words(allowed):
    """An argument of several words."""

    def parse(text):
        for word in text.split():
            if word not in allowed:
                raise argparse.ArgumentTypeError(
                    f"'{word}' is not one of {' '.join(allowed)}"
                )
        return text.split()

    return parse


def parse_arguments():
    parser = argparse.ArgumentParser(prog="fuzz-fp.sh", description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=100,
                        help="functions (default 100)")
    parser.add_argument("--first", type=int, default=1,
                        help="seed (default 1)")
    parser.add_argument("--levels", type=words(LEVELS), default=LEVELS)
    parser.add_argument("--flags", type=words(FLAG_SETS),
                        default=["fast-infinities", "fast", "reproducible"],
                        help="sets of flags: " + " ".join(FLAG_SETS))
    parser.add_argument("--targets", type=words(TARGETS),
                        default=["tp", "native"],
                        help="of: " + " ".join(TARGETS))
    parser.add_argument("--canonicalize", choices=("on", "off"), default="on",
                        help="off: only count what depends on the context")
    parser.add_argument("--keep", default="out/fuzz-fp",
                        help="directory for failing programs")
    parser.add_argument("--reduce", type=int, default=5,
                        help="simplify so many failing functions (default 5)")
    parser.add_argument("--attempts", type=int, default=60,
                        help="to simplify one (default 60)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--tools", default="build/bin",
                        help="directory of tpcc and tpsim")
    return parser.parse_args(joined_levels(sys.argv[1:]))


def joined_levels(arguments):
    """With "--levels -O2" as one word: alone, -O2 looks like an option."""
    if "--levels" in arguments[:-1]:
        i = arguments.index("--levels")
        arguments[i : i + 2] = [f"--levels={arguments[i + 1]}"]
    return arguments


class Campaign:
    """Counts outcomes and keeps what fails."""

    def __init__(self, options, tools):
        self.options = options
        self.tools = tools
        self.functions = 0
        self.evaluations = 0
        self.excepted = 0
        # Functions with a mismatch, in all and by flag set and target.
        self.dependent = set()
        self.dependent_by = {}
        self.broken = 0
        self.kept = 0
        self.start = time.monotonic()

    def add_batch(self, functions, results, ranges):
        for configuration, result in results.items():
            if isinstance(result, Failure):
                self.broken += 1
                print(f"FAILED: {configuration}: {result}")
        results = {
            c: r for c, r in results.items() if not isinstance(r, Failure)
        }
        for function in functions:
            outcome = compare(function, results, ranges)
            self.functions += 1
            self.evaluations += outcome.evaluations
            self.excepted += outcome.excepted
            for mismatch in outcome.mismatches:
                self.add(mismatch)
        self.report_progress()

    def add(self, mismatch):
        first, second = (
            e.configuration for e in (mismatch.first, mismatch.second)
        )
        targets = " against ".join(dict.fromkeys((first.target, second.target)))
        self.dependent_by.setdefault((first.flags, targets), set()).add(
            mismatch.function.number
        )
        is_known = mismatch.function.number in self.dependent
        self.dependent.add(mismatch.function.number)
        if is_known or self.options.canonicalize == "off":
            return
        if self.kept < self.options.reduce:
            mismatch = reduce(self.tools, mismatch, self.options.attempts)
        self.kept += 1
        directory = os.path.join(
            self.options.keep,
            f"seed-{self.options.first}-function-{mismatch.function.number}",
        )
        keep(self.tools, mismatch, directory)
        print(f"FAILED: kept in {directory}\n{mismatch}\n"
              f"{mismatch.function.body()}", flush=True)

    def report_progress(self):
        seconds = time.monotonic() - self.start
        print(
            f"{self.functions}/{self.options.count} functions, "
            f"{len(self.dependent)} context-dependent, {seconds:.0f} s",
            file=sys.stderr, flush=True,
        )

    def report(self):
        options = self.options
        print(
            f"{self.functions} functions x {len(CONTEXTS)} contexts x "
            f"{len(options.levels)} levels x {len(options.flags)} flag sets on "
            f"{' and '.join(options.targets)}, canonicalization "
            f"{options.canonicalize}: {self.evaluations} evaluations, "
            f"{self.excepted} not finite under finite-math-only"
        )
        for (flags, targets), numbers in sorted(self.dependent_by.items()):
            print(f"  {flags}, {targets}: {len(numbers)} context-dependent")
        print(f"{len(self.dependent)} context-dependent, {self.broken} broken")


def configurations(options):
    return [
        Configuration(target, flags, level)
        for flags in options.flags
        for target in options.targets
        for level in options.levels
    ]


def main():
    options = parse_arguments()
    tools = Tools(options.tools, options.canonicalize == "on")
    for name in ("tpcc", "tpsim"):
        if not os.access(tools.tool(name), os.X_OK):
            sys.exit(f"error: {tools.tool(name)} is missing; "
                     "run scripts/build.sh")
    campaign = Campaign(options, tools)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for first in range(0, options.count, BATCH):
            numbers = range(first, min(first + BATCH, options.count))
            functions = [random_function(options.first, n) for n in numbers]
            with tempfile.TemporaryDirectory() as directory:
                campaign.add_batch(
                    functions,
                    *evaluate(tools, functions, configurations(options),
                              directory, pool.map),
                )
    campaign.report()
    failed = campaign.broken or campaign.dependent
    sys.exit(1 if failed and options.canonicalize == "on" else 0)


if __name__ == "__main__":
    main()
