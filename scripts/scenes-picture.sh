#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Renders all scenes natively and writes docs/images/scenes.png, a picture of
# them; some five minutes:
#   scripts/scenes-picture.sh
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install-packages.sh python3-pil
scripts/build.sh pathtracer-native
scripts/scenes.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pictures=()
for scene in scenes/cornell/cornell.gltf \
  out/scenes/{bunny,maple,conference_room,engine,hairball}.glb; do
  picture=$work/$(basename "${scene%.*}").png
  build/bin/pathtracer-native --scene "$scene" --size 512x512 --spp 64 \
    --depth 2 -o "$picture"
  pictures+=("$picture")
done
# Debian's Python, which has Debian's package.
/usr/bin/python3 scenes/join_pictures.py docs/images/scenes.png 240 \
  "${pictures[@]}"
