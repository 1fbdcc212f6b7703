#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""How many instructions tpcc makes of a function, beside stock clang for
riscv32 and mips32r2: 20 classical loops, the kernels as they are optimized
(`kernels`), and every function of the kernels for itself, with -fno-inline
(`functions`).

Counts are static, from the disassembly of unlinked objects. mips's delay slots
count, filled or not; riscv32's far calls count as the one jump that they are
when linked. Only functions that all three compilers emit are compared, and an
inline function of several files only once. The mean is geometric, of TP's count
over the other's; `best` compares each function with the shorter of the two
others."""

import argparse
import pathlib
import sys
import tempfile

import table
import targets
import units
from counts import count_instructions

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from command import run


def count_unit(unit, compilers, options, contraction, folder):
    """By function, the counts in the order of the compilers."""
    per_compiler = []
    for compiler in compilers:
        compiled = folder / "unit.o"
        run(compiler.compile(unit, options, contraction, compiled))
        per_compiler.append(
            count_instructions(
                run(compiler.disassemble(compiled)).stdout))
    common = [name for name in per_compiler[0]
              if all(counts.get(name) for counts in per_compiler)]
    return {name: [counts[name] for counts in per_compiler]
            for name in common}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", type=pathlib.Path,
                        default=targets.ROOT / "build/bin",
                        help="folder of tpcc and tp-objdump")
    parser.add_argument("--clang", default="clang-22")
    parser.add_argument("--objdump", default="llvm-objdump-22")
    parser.add_argument("--levels", nargs="+", default=["O2", "O3", "Os"],
                        help="without the dash")
    parser.add_argument("--contraction", nargs="+", default=["off", "stock"],
                        choices=targets.CONTRACTIONS)
    parser.add_argument("--groups", nargs="+", default=units.GROUPS,
                        choices=units.GROUPS)
    parser.add_argument("--units", nargs="+", metavar="NAME",
                        help="only these source files, without suffix")
    parser.add_argument("--options", nargs="+", default=[], metavar="OPTION",
                        help="further options of all compilers, without the "
                        "dash")
    parser.add_argument("--summary", action="store_true",
                        help="only the means")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    compilers = [targets.tp(arguments.bin),
                 *targets.stock(arguments.clang, arguments.objdump)]
    further = ["-" + option for option in arguments.options]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        chosen = [unit for unit in units.all_units(folder)
                  if not arguments.units
                  or unit.source.stem in arguments.units]
        chosen = [unit for unit in chosen if unit.group in arguments.groups]
        if not chosen:
            sys.exit("error: --units names no source file of bench/codegen or "
                     "the kernels, or --groups nothing of them")
        for unit in chosen:
            run(unit.preprocess(arguments.bin / "tpcc"))
        means = []
        for contraction in arguments.contraction:
            for level in arguments.levels:
                rows = {}
                for unit in chosen:
                    counts = count_unit(unit, compilers,
                                        ["-" + level, *further], contraction,
                                        folder)
                    for function, values in counts.items():
                        rows.setdefault(
                            (unit.group, function),
                            table.Row(unit.group, unit.source.stem, function,
                                      values))
                rows = list(rows.values())
                if not arguments.summary:
                    table.print_rows(level, contraction, compilers, rows)
                means.append((level, contraction, rows))
    table.print_means(compilers, means)


if __name__ == "__main__":
    main()
