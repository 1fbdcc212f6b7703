#!/usr/bin/env python3
#===- make_tiled_room.py - Writes a room of tiles -------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a room with a tiled floor, a tiled ceiling and a lamp, in which the
centres of many triangles lie exactly on boundaries between the bins of a BVH
builder: the scene on which builders break that round one expression in two ways.

Usage: make_tiled_room.py tiled_room.glb
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer

# One tile more than a power of two: their centres divide the room into 16 equal
# parts, as do those of its halves.
TILES = 33
# A few bits, so that the centres are exact, but a number whose reciprocal
# rounds down: k * TILE * (1 / TILE) is a little less than k.
TILE = 49 / 256
FLOOR, CEILING, LAMP = 0, 3, 2.75
# The scene's largest coordinate is a power of two, so that what the renderer
# adds to the boxes is as exact.
CAMERA = (0, 1.5, 8)


def tile(row, column, height):
    x = (column - TILES / 2) * TILE
    z = (row - TILES / 2) * TILE
    return [(x, height, z), (x + TILE, height, z),
            (x + TILE, height, z + TILE), (x, height, z + TILE)]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    writer = Writer("Public domain")
    side = TILES * TILE / 2
    for name, quads, color, emission in [
            ("floor", [tile(r, c, FLOOR) for r in range(TILES)
                       for c in range(TILES)], (0.7, 0.6, 0.5), None),
            ("ceiling", [tile(r, c, CEILING) for r in range(TILES)
                         for c in range(TILES)], (0.7, 0.7, 0.7), None),
            ("back wall", [[(-side, FLOOR, -side), (side, FLOOR, -side),
                            (side, CEILING, -side), (-side, CEILING, -side)]],
             (0.3, 0.5, 0.7), None),
            ("lamp", [[(-1, LAMP, -1), (1, LAMP, -1), (1, LAMP, 1),
                       (-1, LAMP, 1)]], (0.8, 0.8, 0.8), (3, 3, 2.5))]:
        material = writer.add_material(name, color, emission)
        writer.add_root({"name": name, "mesh": writer.add("meshes", {
            "name": name, "primitives": [writer.quads(quads, material)]})})
    camera = writer.add("cameras", {
        "type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}})
    writer.add_root({"name": "camera", "camera": camera,
                     "translation": CAMERA})
    writer.write_binary(sys.argv[1])


main()
