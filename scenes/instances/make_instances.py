#!/usr/bin/env python3
#===- make_instances.py - Writes instances.glb ----------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a small scene that uses what the Cornell box does not: binary glTF,
one mesh in several nodes, nested transforms in both notations, a mirrored
node, strips, fans, bare vertices and every width of index.

Usage: make_instances.py instances.glb
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import FAN, STRIP, Writer

PYRAMID = [(-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1), (0, 2, 0)]
PYRAMID_INDICES = [1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4]


def turn_about(axis, degrees):
    half = math.radians(degrees) / 2
    return [a * math.sin(half) for a in axis] + [math.cos(half)]


def main():
    writer = Writer("Apache-2.0 WITH LLVM-exception")
    grey = writer.add_material("grey", (0.6, 0.6, 0.6))
    blue = writer.add_material("blue", (0.1, 0.2, 0.7))
    lamp = writer.add_material("lamp", (0.5, 0.5, 0.5), (10, 10, 8))

    floor = writer.add("meshes", {"name": "floor", "primitives": [
        writer.primitive([(-8, 0, -8), (-8, 0, 8), (8, 0, 8), (8, 0, -8)],
                         grey, mode=FAN)]})
    light = writer.add("meshes", {"name": "light", "primitives": [
        writer.primitive([(-1, 0, -1), (1, 0, -1), (-1, 0, 1), (1, 0, 1)],
                         lamp, mode=STRIP, indices=[0, 1, 2, 3],
                         index_component="B")]})
    pyramid = writer.add("meshes", {"name": "pyramid", "primitives": [
        writer.primitive(PYRAMID, blue, indices=PYRAMID_INDICES,
                         index_component="I")]})
    flag = writer.add("meshes", {"name": "flag", "primitives": [
        writer.primitive([(0, 0, 0), (1, 0.5, 0), (0, 1, 0)], grey)]})

    writer.add_root({"name": "floor", "mesh": floor})
    writer.add_root({"name": "light", "mesh": light,
                     "translation": [0, 7, 0]})
    tip = writer.add("nodes", {"name": "tip", "mesh": flag,
                               "translation": [0, 2, 0]})
    for name, node in [
            ("plain", {"translation": [-3, 0, 0], "children": [tip]}),
            ("turned", {"translation": [0, 0, -1], "scale": [1, 1.5, 1],
                        "rotation": turn_about((0, 1, 0), 30)}),
            ("mirrored", {"matrix": [-0.5, 0, 0, 0, 0, 0.5, 0, 0,
                                     0, 0, 0.5, 0, 3, 0, 0, 1]})]:
        writer.add_root({"name": name, "mesh": pyramid, **node})

    camera = writer.add("cameras", {
        "type": "perspective",
        "perspective": {"yfov": math.radians(50), "znear": 0.1}})
    lens = writer.add("nodes", {"name": "lens", "camera": camera,
                                "translation": [0, 0, 12]})
    writer.add_root({"name": "boom", "children": [lens],
                     "translation": [0, 1, 0],
                     "rotation": turn_about((1, 0, 0), -20)})
    writer.write_binary(sys.argv[1])


main()
