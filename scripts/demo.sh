#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# The main job: compiles the path tracer for the TP and renders two scenes on
# 4,096 simulated processors: the Cornell box, and a conference room of 320,000
# triangles whose model it downloads. Leaves the pictures, statistics and the
# reports of where the cycles went, to open in a browser, as
# out/cornell.{png,json,html} and out/conference_room.{png,json,html}.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh tpcc tp-runtime tpsim
mkdir -p out
build/bin/tpcc -O3 -g kernels/pathtracer/PathTracer.cpp -I . \
  -o out/pathtracer.elf

# render NAME SCENE
render() {
  echo
  build/bin/tpsim out/pathtracer.elf --chip report-512x8 --scene "$2" \
    --size 256x256 --spp 1 --depth 1 -o "out/$1.png" --stats "out/$1.json" \
    --profile --profile-html "out/$1.html"
  echo "Wrote out/$1.png, out/$1.json and out/$1.html"
}

render cornell scenes/cornell/cornell.gltf
scripts/scenes.sh conference_room
render conference_room out/scenes/conference_room.glb
