# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds the simplest function that still shows a mismatch."""

import os
import tempfile

from comparison import compare, is_excepted, parse_ranges, parse_results
from functions import simpler_functions
from program import program, range_check
from targets import FINITE_ONLY, Failure


def evaluate(tools, functions, configurations, directory, run=map):
    """Results by configuration, and ranges, of one program; a Failure stands
    for the results of a configuration that does not compile or run."""
    if any(c.flags in FINITE_ONLY for c in configurations):
        check = write(directory, "check.cpp", range_check(functions))
        ranges = parse_ranges(tools.run_check(check))
    else:
        ranges = {}
    sources = {}
    for flags in {configuration.flags for configuration in configurations}:
        excepted = {
            key for key, met in ranges.items() if is_excepted(flags, met)
        }
        sources[flags] = write(
            directory, f"{flags}.cpp", program(functions, excepted)
        )

    def one(configuration):
        source = sources[configuration.flags]
        try:
            return parse_results(tools.run(configuration, source))
        except Failure as failure:
            return failure

    return dict(zip(configurations, run(one, configurations))), ranges


def write(directory, name, text):
    path = os.path.join(directory, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def mismatch_of(tools, function, configurations):
    """The first mismatch of a function alone, or nothing."""
    with tempfile.TemporaryDirectory() as directory:
        try:
            results, ranges = evaluate(
                tools, [function], configurations, directory
            )
        except Failure:
            return None
    if any(isinstance(result, Failure) for result in results.values()):
        return None
    mismatches = compare(function, results, ranges).mismatches
    return mismatches[0] if mismatches else None


def reduce(tools, mismatch, limit):
    """The mismatch of the simplest function found in so many attempts."""
    configurations = list(
        dict.fromkeys(
            (mismatch.first.configuration, mismatch.second.configuration)
        )
    )
    best = mismatch_of(tools, mismatch.function, configurations)
    if not best:
        return mismatch
    attempts = 0
    progress = True
    while progress:
        progress = False
        for function in simpler_functions(best.function):
            if attempts == limit:
                return best
            attempts += 1
            found = mismatch_of(tools, function, configurations)
            if found:
                best, progress = found, True
                break
    return best


def keep(tools, mismatch, directory):
    """Writes the program of a mismatch and how to run it."""
    os.makedirs(directory, exist_ok=True)
    other_inputs = {
        (mismatch.function.number, k)
        for k in range(len(mismatch.function.inputs))
        if k not in (mismatch.first.number, mismatch.second.number)
    }
    source = write(
        directory, "program.cpp", program([mismatch.function], other_inputs)
    )
    lines = [str(mismatch), ""]
    for evaluation in (mismatch.first, mismatch.second):
        configuration = evaluation.configuration
        name = str(configuration).replace(" ", "_") + ".out"
        output = os.path.join(directory, name)
        lines.append(
            " ".join(tools.compile_command(configuration, source, output))
        )
        lines.append(" ".join(tools.run_command(configuration, output)))
    write(directory, "mismatch.txt", "\n".join(lines) + "\n")
