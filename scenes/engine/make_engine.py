#!/usr/bin/env python3
#===- make_engine.py - Writes a hall of engines ---------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes nine two-cylinder engines in a studio: 75,730 triangles of which
nodes, transforms within transforms, make 9 x 121,496 = 1,093,464; 9 x 110,336 =
993,024 of them have an area.

Usage: make_engine.py PACKAGE engine.glb

PACKAGE is the folder into which Debian's package assimp-testmodels was
unpacked.
"""

import json
import math
import os
import struct
import sys
from array import array

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import COMPONENT_TYPES, Writer
from packages import Package, main_arguments
from staging import add_studio

CREDITS = ("2CylinderEngine of the Khronos glTF sample models, from "
           "assimp-testmodels, BSD-3-clause, Copyright 2006-2022 ASSIMP "
           "Development Team, copied and staged by the TP project")
MODEL = ("usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/"
         "2CylinderEngine.glb")
UNIQUE_TRIANGLES, INSTANCED_TRIANGLES = 75730, 121496
# Of an engine, without those whose corners are not three.
KEPT_TRIANGLES = 110336
ROWS, COLUMNS = 3, 3
# In the model's unit, millimetres. The corners of a box around all engines.
SPACING_ALONG, SPACING_ACROSS = 640, 540
LOWER, UPPER = (-1010, -188.3, -820), (1010, 116, 820)


def read_binary_gltf(package):
    """(document, binary)"""
    with open(package.path(MODEL), "rb") as file:
        data = file.read()
    try:
        magic, version, length, text_bytes, kind = struct.unpack_from(
            "<4sII I4s", data)
        if (magic, version, length, kind) != (b"glTF", 2, len(data), b"JSON"):
            raise ValueError("not a binary glTF file")
        document = json.loads(data[20:20 + text_bytes])
        size, kind = struct.unpack_from("<I4s", data, 20 + text_bytes)
        start = 20 + text_bytes + 8
        if kind != b"BIN\0" or start + size > len(data):
            raise ValueError("no buffer")
    except (struct.error, ValueError) as error:
        package.reject(MODEL, error)
    return document, data[start:start + size]


class Meshes:
    """The meshes of the model, copied to a writer without normals and without
    triangles of two or more equal corners."""

    def __init__(self, document, binary, writer):
        self.document = document
        self.binary = binary
        self.writer = writer
        # Of each mesh, before and after the equal corners went.
        self.triangles = []
        self.kept_triangles = []
        for material in document["materials"]:
            writer.add("materials", material)
        for mesh in document["meshes"]:
            self.copy(mesh)

    def numbers(self, accessor, component, width):
        """All numbers of an accessor that is tightly packed."""
        source = self.document["accessors"][accessor]
        if source["componentType"] != COMPONENT_TYPES[component]:
            raise ValueError(f"accessor {accessor} has another type")
        view = self.document["bufferViews"][source["bufferView"]]
        start = view.get("byteOffset", 0) + source.get("byteOffset", 0)
        numbers = array(component)
        if view.get("byteStride", width * numbers.itemsize) != (
                width * numbers.itemsize):
            raise ValueError(f"accessor {accessor} has gaps")
        size = width * numbers.itemsize * source["count"]
        numbers.frombytes(self.binary[start:start + size])
        if sys.byteorder == "big":
            numbers.byteswap()
        return numbers

    def copy(self, mesh):
        primitives, before, after = [], 0, 0
        for primitive in mesh["primitives"]:
            positions = self.numbers(
                primitive["attributes"]["POSITION"], "f", 3)
            indices = self.numbers(primitive["indices"], "H", 1)
            kept = without_equal_corners(positions, indices)
            before += len(indices) // 3
            after += len(kept) // 3
            primitives.append(self.writer.primitive(
                positions, primitive["material"], indices=kept))
        self.writer.add("meshes", {**mesh, "primitives": primitives})
        self.triangles.append(before)
        self.kept_triangles.append(after)


def without_equal_corners(positions, indices):
    kept = array(indices.typecode)
    for first in range(0, len(indices), 3):
        corners = indices[first:first + 3]
        if len({tuple(positions[3 * c:3 * c + 3]) for c in corners}) == 3:
            kept.extend(corners)
    return kept


def copy_tree(document, index, writer):
    """Copies a node and those below it; returns (node, numbers of meshes)."""
    node = dict(document["nodes"][index])
    meshes = [node["mesh"]] if "mesh" in node else []
    children = []
    for child in node.pop("children", []):
        copy, below = copy_tree(document, child, writer)
        children.append(copy)
        meshes += below
    if children:
        node["children"] = children
    return writer.add("nodes", node), meshes


def find_engine(document):
    """The root node that is not the camera."""
    [engine] = [index for index in document["scenes"][0]["nodes"]
                if "camera" not in document["nodes"][index]]
    return engine


def place(writer, engine, row, column):
    """A quarter turn further for each engine; every other one is mirrored."""
    number = row * COLUMNS + column
    half_turn = math.pi * (1 + 5 * number) / 24
    writer.add_root({
        "name": f"engine {number}",
        "children": [engine],
        "translation": [(column - (COLUMNS - 1) / 2) * SPACING_ALONG, 0,
                        (row - (ROWS - 1) / 2) * SPACING_ACROSS],
        "rotation": [0, math.sin(half_turn), 0, math.cos(half_turn)],
        "scale": [-1 if number % 2 else 1, 1, 1],
    })


def main():
    folder, target = main_arguments(__doc__)
    package = Package("assimp-testmodels", folder)
    document, binary = read_binary_gltf(package)
    writer = Writer(CREDITS)
    try:
        meshes = Meshes(document, binary, writer)
        package.check_count(MODEL, sum(meshes.triangles), UNIQUE_TRIANGLES)
        root = find_engine(document)
        for row in range(ROWS):
            for column in range(COLUMNS):
                engine, placed = copy_tree(document, root, writer)
                package.check_count(
                    MODEL, sum(meshes.triangles[m] for m in placed),
                    INSTANCED_TRIANGLES)
                package.check_count(
                    MODEL, sum(meshes.kept_triangles[m] for m in placed),
                    KEPT_TRIANGLES)
                place(writer, engine, row, column)
    except (KeyError, IndexError, RecursionError, TypeError,
            ValueError) as error:
        package.reject(MODEL, f"not the expected glTF ({error!r})")
    add_studio(writer, LOWER, UPPER, view=(0.3, 0.65, 1), fill=1.8)
    writer.write_binary(target)


if __name__ == "__main__":
    main()
