# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The series of intervals that tpsim --interval-output writes as CSV."""

import csv
from dataclasses import dataclass

from experiment.errors import BenchError


@dataclass
class Interval:
    begin: int
    end: int
    values: dict

    def share(self, column):
        """Of the thread-cycles, 0 to 1."""
        return max(self.values.get(column, 0), 0) / self.thread_cycles()

    def thread_cycles(self):
        return sum(max(value, 0) for name, value in self.values.items()
                   if name == "instructions" or name.startswith("lost_"))


def read_series(path):
    """The intervals of a file, at least one."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    try:
        series = [interval(dict(row)) for row in rows]
    except (KeyError, TypeError, ValueError) as error:
        raise BenchError(f"{path}: not a series of tpsim --interval-output "
                         f"({type(error).__name__}: {error})") from error
    if not series:
        raise BenchError(f"{path}: no interval")
    return series


def interval(row):
    begin, end = int(row.pop("begin_cycle")), int(row.pop("end_cycle"))
    values = {name: float(value) for name, value in row.items()}
    values["instructions"]  # a KeyError if it is no such file
    return Interval(begin, end, values)
