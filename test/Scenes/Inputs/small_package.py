# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the files of a Debian package as a scene generator expects them, but
with a tiny model, and runs the generator with the tiny model's counts:

    small_package.py NAME FOLDER              only writes the files
    small_package.py NAME FOLDER SCENE.glb    and makes the scene of them
"""

import gzip
import importlib
import io
import json
import os
import struct
import sys
import zipfile

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "../../../scenes")

# Two squares, one of them divided, and a line that is no triangle.
OBJ = """# comment
v 0 0 0
v 1 0 0
v 1 1 0.5
v 0 1 0.5
v 2 0 0
v 2 1 0.5
usemtl {first}
f 1/1/1 2/2/2 3/3/3 4/4/4
usemtl {second}
f -5 -2 -1
f 2//2 6//6 3//3
f 1 2
"""
OBJ_TRIANGLES = 4


def obj(first="a", second="b"):
    return OBJ.format(first=first, second=second).encode()


def zipped(members):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return stream.getvalue()


def bunny(generator):
    generator.TRIANGLES = OBJ_TRIANGLES
    return {generator.MODEL: obj()}


def maple(generator):
    generator.TRIANGLES = OBJ_TRIANGLES
    return {generator.CATALOG: zipped({
        generator.MODEL: obj("Trunk", "Twig")})}


def conference_room(generator):
    furniture = (12 + 4) * OBJ_TRIANGLES
    generator.TRIANGLES = 28332 + furniture
    return {generator.CATALOG: zipped({
        generator.CHAIR: obj(), generator.TABLE: obj()})}


def hairball(generator):
    """A straight hair and one that turns."""
    generator.STRANDS, generator.TRIANGLES = 2, 2 * 15 * 3 * 2
    segments = [strand * 16 + segment for strand in range(2)
                for segment in range(15)]
    points = [(0, 0.1 * i, 0, 0.01) for i in range(16)]
    points += [(1 + 0.1 * i, 0.02 * i * i, 0.1 * (i % 2), 0.01)
               for i in range(16)]
    data = struct.pack(f"<{len(segments)}I", *segments)
    data += b"".join(struct.pack("<4f", *point) for point in points)
    return {generator.CURVES: gzip.compress(data)}


def engine(generator):
    """A mesh of two triangles, one of them with two equal corners, in two
    nodes."""
    generator.UNIQUE_TRIANGLES, generator.INSTANCED_TRIANGLES = 2, 4
    generator.KEPT_TRIANGLES = 2
    binary = struct.pack("<9f6H", 0, 0, 0, 100, 0, 0, 0, 100, 0,
                         0, 1, 2, 0, 0, 1)
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"camera": 0}, {"children": [2, 3]}, {"mesh": 0},
                  {"mesh": 0, "translation": [0, 0, 50]}],
        "cameras": [{"type": "perspective",
                     "perspective": {"yfov": 1, "znear": 1}}],
        "materials": [{"name": "steel"}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1,
            "material": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3,
             "type": "VEC3", "min": [0, 0, 0], "max": [100, 100, 0]},
            {"bufferView": 1, "componentType": 5123, "count": 6,
             "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36, "byteStride": 12},
            {"buffer": 0, "byteOffset": 36, "byteLength": 12}],
        "buffers": [{"byteLength": 48}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return {generator.MODEL: struct.pack(
        "<4sII I4s", b"glTF", 2, 12 + 8 + len(text) + 8 + len(binary),
        len(text), b"JSON") + text + struct.pack(
            "<I4s", len(binary), b"BIN\0") + binary}


def main():
    name, folder, *target = sys.argv[1:]
    sys.path.insert(0, os.path.join(SCENES, name))
    generator = importlib.import_module("make_" + name)
    for path, data in globals()[name](generator).items():
        path = os.path.join(folder, path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as file:
            file.write(data)
    if target:
        sys.argv = [generator.__file__, folder, *target]
        generator.main()


main()
