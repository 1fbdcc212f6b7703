#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# The main job: compiles the path tracer for the TP and renders the Cornell box
# on 4,096 simulated processors. Leaves out/cornell.png and out/cornell.json.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh tpcc tp-runtime tpsim
mkdir -p out
build/bin/tpcc -O3 -g kernels/pathtracer/PathTracer.cpp -I . \
  -o out/pathtracer.elf
build/bin/tpsim out/pathtracer.elf --chip report-512x8 \
  --scene scenes/cornell/cornell.gltf --size 256x256 --spp 1 --depth 1 \
  -o out/cornell.png --stats out/cornell.json
echo "Wrote out/cornell.png and out/cornell.json"
