#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares how long tpcc and stock clang for riscv32 compile the path tracer.

The same source, headers, level and floating-point rules, in turn, each the
shortest of several runs, in seconds of processor time:

  compile   -O3 -c, one object without whole-program optimization
  program   -O3, an executable with whole-program optimization. tpcc's contains
            its runtime, that of clang and lld nothing but the path tracer.

The TP's builtins are functions for riscv32."""

import argparse
import os
import pathlib
import re
import sys
import tempfile

from command import run

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "kernels/pathtracer/PathTracer.cpp"
BUILTINS = ROOT / "llvm-backend/TPBuiltins.def"
# Declares them as functions.
DECLARATIONS = ROOT / "llvm-backend/clang/clangd/builtin_declarations.py"
RISCV = ["--target=riscv32-unknown-elf", "-march=rv32imf_zba_zbb",
         "-mabi=ilp32f", "-std=gnu++20", "-fno-exceptions",
         "-fno-rtti", "-ffp-contract=off", "-fno-math-errno",
         "-fno-strict-float-cast-overflow", "-ftls-model=local-exec",
         "-nostdlibinc", "-D__tp__", "-D__TP__", "-D__TP_TRIG__"]


def seconds(command):
    """Processor time of the command and its children."""
    before = os.times()
    run(command)
    after = os.times()
    return (after.children_user - before.children_user +
            after.children_system - before.children_system)


def sysroot_headers(tpcc):
    """-isystem for each folder that tpcc searches, clang's own excepted."""
    plan = run([tpcc, "-###", "-c", SOURCE, "-o", os.devnull]).stderr
    folders = re.findall(r'"-internal-isystem" "([^"]+)"', plan)
    return [word for folder in folders if "/lib/clang/" not in folder
            for word in ("-isystem", folder)]


class Comparison:
    def __init__(self, tpcc, clang, lld, folder):
        builtins = folder / "builtins.h"
        run([sys.executable, DECLARATIONS, BUILTINS, builtins])
        self.tpcc = [tpcc, "-O3", "-I", ROOT, SOURCE]
        self.clang = [clang, "-O3", "-I", ROOT, SOURCE, *RISCV, "-nostdinc++",
                      "-include", builtins, *sysroot_headers(tpcc)]
        self.lld = lld
        self.object = folder / "object.o"
        self.program = folder / "program.elf"

    def compile(self):
        """(tpcc, clang) for an object."""
        return (seconds([*self.tpcc, "-fno-lto", "-c", "-o", self.object]),
                seconds([*self.clang, "-c", "-o", self.object]))

    def link(self):
        """(tpcc, clang) for a program."""
        ours = seconds([*self.tpcc, "-o", self.program])
        stock = seconds([*self.clang, "-flto", "-c", "-o", self.object])
        stock += seconds([self.lld, "--lto-O3", "-e", "main",
                          "--unresolved-symbols=ignore-all", self.object, "-o",
                          self.program])
        return ours, stock


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/bin")
    parser.add_argument("--clang", default="clang++-22")
    parser.add_argument("--lld", default="ld.lld-22")
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--limit", type=float,
                        help="fail if tpcc takes more than this times as long")
    arguments = parser.parse_args()

    worst = 0
    print(f"{'':10}{'tpcc':>8}{'clang':>8}{'ratio':>8}")
    with tempfile.TemporaryDirectory() as folder:
        comparison = Comparison(arguments.bin / "tpcc", arguments.clang,
                                arguments.lld, pathlib.Path(folder))
        for name, measure in (("compile", comparison.compile),
                              ("program", comparison.link)):
            ours, stock = (min(times) for times in zip(
                *(measure() for _ in range(arguments.runs))))
            worst = max(worst, ours / stock)
            print(f"{name:10}{ours:8.3f}{stock:8.3f}{ours / stock:8.2f}")
    if arguments.limit and worst > arguments.limit:
        sys.exit(f"error: tpcc takes {worst:.2f} times as long as clang, more "
                 f"than {arguments.limit}")


if __name__ == "__main__":
    main()
