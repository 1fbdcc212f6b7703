# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints the counts and their means."""

import dataclasses
import subprocess

from counts import geometric_mean

WIDEST_NAME = 60


@dataclasses.dataclass(frozen=True)
class Row:
    """A function: its counts, TP's first."""

    group: str
    unit: str
    function: str
    counts: list

    def ratio(self, other):
        return self.counts[0] / self.counts[other]

    def ratio_to_best(self):
        return self.counts[0] / min(self.counts[1:])


def demangle(names):
    text = subprocess.run(["c++filt"], input="\n".join(names), text=True,
                          capture_output=True, check=False).stdout
    found = text.splitlines()
    return found if len(found) == len(names) else names


def print_rows(level, contraction, compilers, all_rows):
    print(f"\n-{level}, contraction {contraction}")
    print("".join(f"{compiler.name:>9}" for compiler in compilers),
          "   best  function")
    ordered = sorted(all_rows, key=lambda row: (row.group, row.ratio_to_best()))
    names = demangle([row.function for row in ordered])
    for row, name in zip(ordered, names):
        counts = "".join(f"{count:9}" for count in row.counts)
        print(f"{counts} {row.ratio_to_best():7.3f}  {row.unit}: "
              f"{name[:WIDEST_NAME]}")


def print_means(compilers, measured):
    print("\nGeometric means of TP's instructions over the other's")
    print("level contraction  group     functions",
          "".join(f"{compiler.name:>9}" for compiler in compilers[1:]),
          "    best   sums")
    for level, contraction, all_rows in measured:
        groups = dict.fromkeys(row.group for row in all_rows)
        for group in [*groups, "all"]:
            chosen = [row for row in all_rows if group in (row.group, "all")]
            means = [geometric_mean(row.ratio(other) for row in chosen)
                     for other in range(1, len(compilers))]
            best = geometric_mean(row.ratio_to_best() for row in chosen)
            sums = "/".join(str(sum(row.counts[index] for row in chosen))
                            for index in range(len(compilers)))
            print(f"-{level:4} {contraction:11}  {group:9} {len(chosen):9} ",
                  "".join(f"{mean:9.3f}" for mean in means),
                  f"{best:7.3f}   {sums}")
