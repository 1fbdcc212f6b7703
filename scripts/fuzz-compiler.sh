#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Compares csmith programs on the simulated 1x1 chip with their native run:
#   scripts/fuzz-compiler.sh [N] [--first SEED] [--levels "-O0 -O2"]
#                            [--keep DIRECTORY] [--tools DIRECTORY]
# N programs (default 100) are compared, each at every level; those that run
# for long even natively do not count. A failing program stays in the directory
# (default out/fuzz) with its command line and both outputs. Exit status 1 if
# any program failed.
set -euo pipefail
cd "$(dirname "$0")/.."

count=100 first=1 levels="-O0 -O2" keep=out/fuzz tools=build/bin
while [ $# -gt 0 ]; do
  case "$1" in
  --first | --levels | --keep | --tools)
    [ $# -ge 2 ] || { echo "error: $1 needs a value" >&2; exit 1; }
    case "$1" in
    --first) first=$2 ;;
    --levels) levels=$2 ;;
    --keep) keep=$2 ;;
    --tools) tools=$2 ;;
    esac
    shift 2 ;;
  *[!0-9]* | "")
    sed -n '4,11s/^# \{0,1\}//p' "$0" >&2
    echo "error: unknown argument: $1" >&2
    exit 1 ;;
  *) count=$1; shift ;;
  esac
done
for tool in "$tools/tpcc" "$tools/tpsim"; do
  [ -x "$tool" ] || { echo "error: $tool is missing; run scripts/build.sh" >&2; exit 1; }
done
mkdir -p "$keep"

# compare SEED: exit status 0 equal, 1 different, 2 not usable.
compare() {
  local seed=$1 work status=0
  work=$(mktemp -d)
  trap 'rm -rf "$work"' RETURN
  # Packed structs, unions and pointers into them would make the checksum
  # depend on the layout.
  # (csmith leaves a file platform.info where it runs.)
  (cd "$work" && csmith --seed "$seed" --no-packed-struct --no-unions \
    --no-volatile-pointers --max-funcs 6 --max-block-depth 4 >program.c)
  # A constant's suffix L means 32 bits on the TP and 64 natively; the values
  # fit 32 bits, and without the suffix both sides agree on the type.
  sed -i -E 's/\b(0[xX][0-9A-Fa-f]+|[0-9]+)(U?)L\b/\1\2/g' "$work/program.c"
  clang-22 -w -O1 -I /usr/include/csmith "$work/program.c" \
    -o "$work/native" || return 2
  timeout 1 "$work/native" >"$work/expected" 2>&1 || return 2
  for level in $levels; do
    local compile="$tools/tpcc -w $level -I /usr/include/csmith program.c"
    if ! "$tools/tpcc" -w $level -I /usr/include/csmith "$work/program.c" \
        -o "$work/program.elf" >"$work/log" 2>&1; then
      status=1
    elif ! timeout 300 "$tools/tpsim" "$work/program.elf" --chip 1x1 --quiet \
        >"$work/actual" 2>"$work/log"; then
      status=1
    elif ! cmp -s "$work/expected" "$work/actual"; then
      status=1
    fi
    if [ $status -ne 0 ]; then
      local kept="$keep/seed-$seed$level"
      mkdir -p "$kept"
      cp "$work"/program.c "$work/expected" "$kept/"
      cp "$work/actual" "$work/log" "$kept/" 2>/dev/null || true
      echo "$compile" >"$kept/command"
      echo "FAILED: seed $seed at $level, kept in $kept"
      return 1
    fi
  done
  return 0
}
export -f compare
export levels keep tools

# Seeds in turn, as many workers as processors, until N were compared.
passed=0 failed=0 seed=$first
workers=$(nproc)
while [ $((passed + failed)) -lt "$count" ]; do
  left=$((count - passed - failed))
  batch=$((left < workers * 8 ? left : workers * 8))
  while read -r outcome; do
    case "$outcome" in
    "status 0") passed=$((passed + 1)) ;;
    "status 1") failed=$((failed + 1)) ;;
    "status 2") ;;
    *) echo "$outcome" ;;
    esac
  done < <(seq "$seed" $((seed + batch - 1)) |
    xargs -P "$workers" -I{} bash -c \
      'compare {} && status=0 || status=$?; echo "status $status"')
  seed=$((seed + batch))
  echo "$((passed + failed))/$count compared, $failed failed" >&2
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
