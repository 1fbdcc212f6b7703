#!/usr/bin/env python3
#===- make_cornell.py - Writes cornell.gltf -------------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the Cornell box from the data measured at the Cornell University
Program of Computer Graphics (https://www.graphics.cornell.edu/online/box/).

Usage: make_cornell.py cornell.gltf
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer

# The measured reflectance spectra as linear RGB, as the field's renderers use
# them; the lamp's reflectance is the measured 0.78.
WHITE = (0.725, 0.71, 0.68)
GREEN = (0.14, 0.45, 0.091)
RED = (0.63, 0.065, 0.05)
LAMP = (0.78, 0.78, 0.78)
LAMP_EMISSION = (17, 12, 4)

# Millimetres. Corners in the order of the measured data: counter-clockwise seen
# from where the surface can be seen.
LIGHT = [(343, 548.8, 227), (343, 548.8, 332),
         (213, 548.8, 332), (213, 548.8, 227)]
CEILING = [(556, 548.8, 0), (556, 548.8, 559.2),
           (0, 548.8, 559.2), (0, 548.8, 0)]
FLOOR = [(552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2)]
BACK_WALL = [(549.6, 0, 559.2), (0, 0, 559.2),
             (0, 548.8, 559.2), (556, 548.8, 559.2)]
RIGHT_WALL = [(0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2)]
LEFT_WALL = [(552.8, 0, 0), (549.6, 0, 559.2),
             (556, 548.8, 559.2), (556, 548.8, 0)]
SHORT_BLOCK = [
    [(130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114)],
    [(290, 0, 114), (290, 165, 114), (240, 165, 272), (240, 0, 272)],
    [(130, 0, 65), (130, 165, 65), (290, 165, 114), (290, 0, 114)],
    [(82, 0, 225), (82, 165, 225), (130, 165, 65), (130, 0, 65)],
    [(240, 0, 272), (240, 165, 272), (82, 165, 225), (82, 0, 225)],
]
TALL_BLOCK = [
    [(423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406)],
    [(423, 0, 247), (423, 330, 247), (472, 330, 406), (472, 0, 406)],
    [(472, 0, 406), (472, 330, 406), (314, 330, 456), (314, 0, 456)],
    [(314, 0, 456), (314, 330, 456), (265, 330, 296), (265, 0, 296)],
    [(265, 0, 296), (265, 330, 296), (423, 330, 247), (423, 0, 247)],
]

# The lamp fills a hole in the ceiling: one quad from each of the ceiling's
# edges to the hole's. (The measured data has holes under the blocks too; nobody
# can see them, and our floor goes on there.)
CEILING_AROUND_LIGHT = [
    [CEILING[i], CEILING[(i + 1) % 4], LIGHT[(i + 1) % 4], LIGHT[i]]
    for i in range(4)]

CAMERA_POSITION = (278, 273, -800)
FOCAL_LENGTH = 0.035
FILM_SIZE = 0.025


def main():
    writer = Writer("Measured data: Cornell University Program of Computer "
                    "Graphics")
    white = writer.add_material("white", WHITE)
    green = writer.add_material("green", GREEN)
    red = writer.add_material("red", RED)
    lamp = writer.add_material("lamp", LAMP, LAMP_EMISSION)
    for name, quads, material in [
            ("floor", [FLOOR], white),
            ("ceiling", CEILING_AROUND_LIGHT, white),
            ("back wall", [BACK_WALL], white),
            ("right wall", [RIGHT_WALL], green),
            ("left wall", [LEFT_WALL], red),
            ("short block", SHORT_BLOCK, white),
            ("tall block", TALL_BLOCK, white),
            ("light", [LIGHT], lamp)]:
        mesh = writer.add("meshes", {
            "name": name, "primitives": [writer.quads(quads, material)]})
        writer.add_root({"name": name, "mesh": mesh})
    camera = writer.add("cameras", {
        "type": "perspective",
        "perspective": {
            "aspectRatio": 1,
            "yfov": 2 * math.atan(FILM_SIZE / 2 / FOCAL_LENGTH),
            "znear": 1,
        },
    })
    # glTF's cameras look along -Z; the box lies along +Z: half a turn about Y.
    writer.add_root({
        "name": "camera",
        "camera": camera,
        "translation": CAMERA_POSITION,
        "rotation": [0, 1, 0, 0],
    })
    writer.write_text(sys.argv[1])


main()
