#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Builds the BVH of every scene, in full size, under every set of float flags,
# on the simulated chip and natively; then again with the pass switched off,
# where the textbook's builder must lose triangles. Some 15 minutes:
#   scripts/builder-campaign.sh [option of builder_campaign.py...]
# Fetches the conference-like room (scripts/scenes.sh). Exit status 1
# if a tree was wrong with the pass, or none without it.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/scenes.sh conference_room
scenes=(cornell tiled-room knot out/scenes/conference_room.glb)
python3 scripts/builder_campaign.py --jobs "$(nproc)" \
  --scenes "${scenes[@]}" "$@"

echo
echo "With the pass switched off (stock LLVM):"
if python3 scripts/builder_campaign.py --jobs "$(nproc)" "$@" \
  --no-canonicalize --flags fast-math with-infinities reciprocal \
  --scenes tiled-room out/scenes/conference_room.glb; then
  echo "error: the pass makes no difference" >&2
  exit 1
fi
