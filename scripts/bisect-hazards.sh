#!/bin/sh
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# usage: bisect-hazards.sh [H1 H2 H3 H4]
#
# Lets tp-bisect find each hazard that is planted in a renderer of 600 lines
# (test/FastMath/Bisect/Inputs/planted.cpp), natively with stock clang 22 and on
# the TP with the canonicalizer off, checks the flag and the line that it names,
# and prints how long each search took. That counts on idle cores: a search
# builds the program some fifty times.
set -u

root=$(cd "$(dirname "$0")/.." && pwd)
bin=$root/build/bin
source=$root/test/FastMath/Bisect/Inputs/planted.cpp
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# search <platform> <hazard> <good> <bad> <flag> <text of the guilty line>
search() {
  platform=$1 hazard=$2 good=$3 bad=$4 flag=$5 text=$6
  if [ "$platform" = native ]; then
    build="clang++-22 -w -DPLANT_$hazard {flags} $source -o {out}"
    test='{out}'
  else
    build="$bin/tpcc -w -DPLANT_$hazard -mllvm -tp-fp-canonicalize=0 {flags} $source -o {out}"
    test="$bin/tpsim --chip 1x1 --quiet {out}"
  fi
  report=$work/$platform-$hazard.txt
  start=$(date +%s)
  "$bin/tp-bisect" --quiet --good "$good" --bad "$bad" --build "$build" \
    --test "$test" --work-folder "$work/$platform-$hazard" >"$report" 2>&1
  status=$?
  seconds=$(($(date +%s) - start))
  line=$(grep -n -F "$text" "$source" | head -n 1 | cut -d: -f1)
  verdict=found
  if [ $status -ne 0 ] || ! grep -q -e "^guilty flag: $flag " "$report" ||
      ! grep -q "planted.cpp:$line:" "$report"; then
    verdict='NOT FOUND'
    failures=$((failures + 1))
    cat "$report"
  fi
  printf '%-6s %s  %-19s line %s  %s, %d s %s\n' "$platform" "$hazard" "$flag" \
    "$line" "$verdict" "$seconds" "$(tail -n 1 "$report")"
}

for hazard in ${*:-H1 H2 H3 H4}; do
  for platform in native tp; do
    case $hazard in
    H1) search $platform H1 -O2 '-O2 -ffast-math' -freciprocal-math \
          'int bin = int(BinCount * ((center - lo) / (hi - lo)));' ;;
    H2) search $platform H2 -O2 '-O2 -ffast-math' -freciprocal-math \
          'return int(LevelCount * (value / brightest));' ;;
    H3) search $platform H3 '-O2 -mfma -ffp-contract=off' \
          '-O2 -mfma -ffp-contract=on' -ffp-contract=on \
          'return a.x * b.y - a.y * b.x > 0;' ;;
    H4) search $platform H4 -O2 '-O2 -ffast-math' -fassociative-math \
          'return (t + step) - t;' ;;
    *) echo "$0: no hazard '$hazard'; there are H1 to H4" >&2; exit 1 ;;
    esac
  done
done
[ $failures -eq 0 ]
