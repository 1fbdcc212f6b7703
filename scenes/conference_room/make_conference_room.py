#!/usr/bin/env python3
#===- make_conference_room.py - Writes a conference-like room -------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a room like the well-known conference room: 12 office chairs, 4
tables, blinds, a tiled floor and a tiled ceiling with lamps; 319,924 triangles.

Usage: make_conference_room.py PACKAGE conference_room.glb

PACKAGE is the folder into which Debian's package sweethome3d-furniture was
unpacked. Chairs and tables are models by Andrew Kator and Jennifer
Legaz under CC-BY 3.0, scaled and placed; whoever passes the scene on must
credit them.
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer
from packages import Package, main_arguments

CREDITS = ("Office chair and folding table: Andrew Kator and Jennifer Legaz, "
           "CC-BY 3.0 (https://creativecommons.org/licenses/by/3.0/), scaled "
           "and placed by the TP project")
CATALOG = "usr/share/sweethome3d/furniture/KatorLegaz.sh3f"
CHAIR = "katorlegaz/office-chair/office-chair.obj"
TABLE = "katorlegaz/folding-table/folding-table.obj"
TRIANGLES = 319924
# Half the room's length and width, and its height, in metres.
HALF_LENGTH, HEIGHT, HALF_WIDTH = 6, 3, 4
TILE = 0.12
TILES_ALONG, TILES_ACROSS = 100, 66
LAMP_EVERY = 11


def stand(triangles, height):
    """Scaled to the height, on the floor, in the middle."""
    columns = list(zip(*(point for shape in triangles for point in shape)))
    low, high = [min(c) for c in columns], [max(c) for c in columns]
    scale = height / (high[1] - low[1])
    base = ((low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2)
    return [tuple(tuple((point[i] - base[i]) * scale for i in range(3))
                  for point in shape) for shape in triangles]


def place(triangles, x, z, angle):
    """Turned about the vertical axis and moved."""
    cos, sin = math.cos(angle), math.sin(angle)
    return [tuple((p[0] * cos + p[2] * sin + x, p[1],
                   -p[0] * sin + p[2] * cos + z) for p in shape)
            for shape in triangles]


def quad(a, b, c, d):
    return [(a, b, c), (a, c, d)]


def box_quads(x, y, z):
    """The walls, the floor and the ceiling."""
    corner = {(i, j, k): (i * x, j * y, k * z)
              for i in (-1, 1) for j in (0, 1) for k in (-1, 1)}
    faces = [[(-1, j, -1), (1, j, -1), (1, j, 1), (-1, j, 1)] for j in (0, 1)]
    faces += [[(-1, 0, k), (1, 0, k), (1, 1, k), (-1, 1, k)] for k in (-1, 1)]
    faces += [[(i, 0, -1), (i, 0, 1), (i, 1, 1), (i, 1, -1)] for i in (-1, 1)]
    return [t for face in faces for t in quad(*(corner[c] for c in face))]


def blinds():
    """Slats before both long walls."""
    triangles = []
    for wall in (-3.95, 3.95):
        for window in range(6):
            x = -5.5 + 1.9 * window
            for slat in range(80):
                y = 0.9 + 0.02 * slat
                triangles += quad(
                    (x, y, wall), (x + 1.5, y, wall),
                    (x + 1.5, y + 0.004, wall + 0.015),
                    (x, y + 0.004, wall + 0.015))
    return triangles


def tiles():
    """(all but the lamps, lamps) of floor and ceiling."""
    plain, lamps = [], []
    for i in range(TILES_ALONG):
        for j in range(TILES_ACROSS):
            x, z = -HALF_LENGTH + TILE * i, -HALF_WIDTH + TILE * j
            for y in (0.001, 2.9):
                is_lamp = y > 1 and i % LAMP_EVERY == j % LAMP_EVERY == 5
                (lamps if is_lamp else plain).extend(
                    quad((x, y, z), (x + TILE, y, z),
                         (x + TILE, y, z + TILE), (x, y, z + TILE)))
    return plain, lamps


def read_triangles(package, model):
    """The triangles of a model as three points each."""
    obj = package.read_zipped_obj(CATALOG, model)
    return [tuple(obj.vertices[corner] for corner in corners)
            for corners in obj.triangles()]


def furniture(package):
    """(chairs, tables)"""
    chair = stand(read_triangles(package, CHAIR), 1.1)
    table = stand(read_triangles(package, TABLE), 0.75)
    chairs = [t for i in range(6) for z, angle in ((-1.2, 0), (1.2, math.pi))
              for t in place(chair, -4 + 1.6 * i, z, angle)]
    tables = [t for i in range(4) for t in place(table, -3.6 + 2.4 * i, 0, 0)]
    return chairs, tables


def main():
    folder, target = main_arguments(__doc__)
    package = Package("sweethome3d-furniture", folder)
    chairs, tables = furniture(package)
    plain_tiles, lamps = tiles()
    writer = Writer(CREDITS)
    count = 0
    for name, triangles, color, emission in [
            ("chairs", chairs, (0.2, 0.22, 0.3), None),
            ("tables", tables, (0.5, 0.35, 0.2), None),
            ("shell", box_quads(HALF_LENGTH, HEIGHT, HALF_WIDTH),
             (0.7, 0.7, 0.65), None),
            ("blinds", blinds(), (0.6, 0.6, 0.5), None),
            ("tiles", plain_tiles, (0.6, 0.6, 0.6), None),
            ("lamps", lamps, (0.8, 0.8, 0.8), (50, 47, 42))]:
        points = [point for shape in triangles for point in shape]
        material = writer.add_material(name, color, emission)
        writer.add_root({"name": name, "mesh": writer.add("meshes", {
            "name": name,
            "primitives": [writer.primitive(points, material)]})})
        count += len(triangles)
    package.check_count(CATALOG, count, TRIANGLES)
    camera = writer.add("cameras", {
        "type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1}})
    # At one end of the room, looking along it.
    writer.add_root({"name": "camera", "camera": camera,
                     "translation": (5.6, 1.7, 0),
                     "rotation": (0, math.sqrt(0.5), 0, math.sqrt(0.5))})
    writer.write_binary(target)


if __name__ == "__main__":
    main()
