#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Checks that the C++ sources are formatted and clean under clang-tidy:
# scripts/lint.sh [REGEX]   (only the files whose path matches; needs a build)
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -gt 1 ]; then
  echo "usage: scripts/lint.sh [REGEX]" >&2
  exit 1
fi
if [ ! -f build/compile_commands.json ]; then
  echo "error: build/compile_commands.json is missing;" \
    "run scripts/build.sh first" >&2
  exit 1
fi
scripts/install-packages.sh clang-format-22 clang-tidy-22

files=$(git ls-files '*.cpp' '*.h' | grep -E -- "${1:-}") || {
  echo "error: no source file matches '$1'" >&2
  exit 1
}
status=0
xargs clang-format-22 --dry-run --Werror <<<"$files" || status=1
run-clang-tidy-22 -quiet -hide-progress -p build -warnings-as-errors='*' \
  ${1:+"$1"} || status=1
exit $status
