#!/usr/bin/env python3
#===- make_bunny.py - Writes the Stanford bunny in a studio ---------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the Stanford bunny, 69,666 triangles, in a studio.

Usage: make_bunny.py PACKAGE bunny.glb

PACKAGE is the folder into which Debian's package glmark2-data was unpacked.
"""

import os
import sys
from array import array
from itertools import chain

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer, flatten
from packages import Package, main_arguments
from staging import add_studio, bounds

CREDITS = ("Bunny: Stanford University Computer Graphics Laboratory "
           "(https://graphics.stanford.edu/data/3Dscanrep/), as in glmark2, "
           "GPL-3+ (https://www.gnu.org/licenses/gpl-3.0.html), staged by the "
           "TP project")
MODEL = "usr/share/glmark2/models/bunny.obj"
TRIANGLES = 69666


def main():
    folder, target = main_arguments(__doc__)
    package = Package("glmark2-data", folder)
    model = package.read_obj(MODEL)
    positions = flatten("f", model.vertices)
    indices = array("I", chain.from_iterable(model.triangles()))
    package.check_count(MODEL, len(indices) // 3, TRIANGLES)
    writer = Writer(CREDITS)
    fur = writer.add_material("bunny", (0.75, 0.62, 0.48))
    writer.add_root({"name": "bunny", "mesh": writer.add("meshes", {
        "name": "bunny", "primitives": [writer.primitive(
            positions, fur, indices=indices, index_component="I")]})})
    add_studio(writer, *bounds(positions), view=(0.1, 0.35, 1), fill=1.25)
    writer.write_binary(target)


if __name__ == "__main__":
    main()
