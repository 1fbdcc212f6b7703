#!/usr/bin/env python3
#===- make_maple.py - Writes a maple tree in a studio ---------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a Japanese maple with all its leaves, 198,396 triangles, in a studio.

Usage: make_maple.py PACKAGE maple.glb

PACKAGE is the folder into which Debian's package sweethome3d-furniture was
unpacked.
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

CREDITS = ("Japanese maple: Emmanuel Puybaret / eTeks and Scopia Visual "
           "Interfaces Systems, CC-BY 3.0 "
           "(https://creativecommons.org/licenses/by/3.0/), coloured and "
           "staged by the TP project")
CATALOG = "usr/share/sweethome3d/furniture/Scopia.sh3f"
MODEL = "scopia/japaneseMaple/japaneseMaple.obj"
TRIANGLES = 198396
COLORS = {"Trunk": (0.35, 0.25, 0.18), "Twig": (0.6, 0.16, 0.08)}


def main():
    folder, target = main_arguments(__doc__)
    package = Package("sweethome3d-furniture", folder)
    model = package.read_zipped_obj(CATALOG, MODEL)
    package.check_count(CATALOG, len(model.triangles()), TRIANGLES)
    triangles = {name: array("I") for name in COLORS}
    for material, part in model.parts:
        if material not in triangles:
            package.reject(CATALOG, f"{MODEL}: unknown material '{material}'")
        triangles[material].extend(chain.from_iterable(part))
    writer = Writer(CREDITS)
    positions = flatten("f", model.vertices)
    shared = writer.add_accessor("f", "VEC3", positions)
    writer.add_root({"name": "maple", "mesh": writer.add("meshes", {
        "name": "maple", "primitives": [{
            "attributes": {"POSITION": shared},
            "indices": writer.add_accessor("I", "SCALAR", triangles[name]),
            "material": writer.add_material(name, color),
        } for name, color in COLORS.items()]})})
    add_studio(writer, *bounds(positions), view=(0.3, 0.12, 1), fill=1.55)
    writer.write_binary(target)


if __name__ == "__main__":
    main()
