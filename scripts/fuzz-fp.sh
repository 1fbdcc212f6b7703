#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Compares random floating-point functions over contexts, levels and targets:
#   scripts/fuzz-fp.sh [N] [--first SEED] [--levels "-O0 -O2"]
#                      [--flags "fast reproducible"] [--targets "tp native"]
#                      [--canonicalize on|off] [--keep DIRECTORY]
#                      [--tools DIRECTORY]
# A failing function stays in the directory (default out/fuzz-fp), simplified,
# as a program with the commands of both evaluations. Exit status 1 if any
# failed; with --canonicalize off they are only counted.
set -euo pipefail
cd "$(dirname "$0")/.."
exec python3 scripts/fuzz_fp "$@"
