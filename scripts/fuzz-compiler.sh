#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Compares random programs on the simulated 1x1 chip with their native run:
#   scripts/fuzz-compiler.sh [N] [--cxx M] [--first SEED]
#                            [--levels "-O0 -O2"] [--modes "whole objects"]
#                            [--keep DIRECTORY] [--resume] [--reduce K]
#                            [--jobs J] [--tools DIRECTORY]
# N programs of csmith (default 100) and M of an own C++ generator (default a
# quarter as many) are compared, each at every level, with the machine verifier
# on; those that run for long even natively do not count. A failing program
# stays in the directory (default out/fuzz), reduced, with its command lines.
# Exit status 1 if any program failed.
set -euo pipefail
cd "$(dirname "$0")/.."
exec python3 scripts/fuzz_compiler "$@"
