# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the bits of an expression over contexts, levels and targets."""

import dataclasses

from program import CONTEXTS
from targets import FINITE_ONLY

EXTREME, NOT_FINITE = 1, 2


def parse_results(output):
    """Bits in each context by (function, input)."""
    results = {}
    for line in output.splitlines():
        function, number, *bits = line.split()
        if len(bits) != len(CONTEXTS):
            raise ValueError(f"not a line of results: {line}")
        results[int(function, 16), int(number, 16)] = bits
    return results


def parse_ranges(output):
    """What an evaluation meets, by (function, input)."""
    ranges = {}
    for line in output.splitlines():
        function, number, met = (int(word, 16) for word in line.split())
        ranges[function, number] = met
    return ranges


def is_excepted(flags, met):
    """Whether an evaluation under a flag set is undefined, because of what it
    meets."""
    return flags in FINITE_ONLY and met & NOT_FINITE != 0


@dataclasses.dataclass(frozen=True)
class Evaluation:
    """One result and how it came about."""

    configuration: object
    context: str
    number: int
    bits: str

    def __str__(self):
        return (
            f"{self.bits}  {self.context}, {self.configuration}, "
            f"input {self.number}"
        )


@dataclasses.dataclass
class Mismatch:
    """Two evaluations of a function that should be equal."""

    function: object
    first: Evaluation
    second: Evaluation

    @property
    def across_targets(self):
        return (
            self.first.configuration.target != self.second.configuration.target
        )

    def __str__(self):
        return f"{self.first}\n{self.second}"


@dataclasses.dataclass
class Outcome:
    """Of one function."""

    mismatches: list
    evaluations: int = 0
    # Evaluations that finite-math-only leaves undefined.
    excepted: int = 0


def scopes(function, configuration):
    """What an evaluation is compared within: its target, and all targets."""
    if function.calls_library():
        return (configuration.target,)
    return (configuration.target, "")


def compare(function, results, ranges):
    """The outcome of a function, with the first mismatch of each flag set and
    target or pair of targets; results is by configuration."""
    outcome = Outcome([])
    found = set()
    for number in range(len(function.inputs)):
        references = {}
        met = ranges.get((function.number, number), 0)
        for configuration, result in results.items():
            if is_excepted(configuration.flags, met):
                outcome.excepted += len(CONTEXTS)
                continue
            bits = result[function.number, number]
            outcome.evaluations += len(bits)
            contracts = configuration.contracts(function)
            for context, value in zip(CONTEXTS, bits):
                here = Evaluation(configuration, context, number, value)
                for scope in scopes(function, configuration):
                    key = (configuration.flags, contracts, scope)
                    reference = references.setdefault(key, here)
                    if reference.bits == value or key in found:
                        continue
                    mismatch = Mismatch(function, reference, here)
                    if mismatch.across_targets or scope:
                        found.add(key)
                        outcome.mismatches.append(mismatch)
    return outcome
