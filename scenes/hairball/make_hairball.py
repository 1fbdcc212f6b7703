#!/usr/bin/env python3
#===- make_hairball.py - Writes a ball of hair ----------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a ball of 30,367 hairs as three-sided prisms, 2,733,030 triangles, in
the class of the well-known hairball (2,880,000).

Usage: make_hairball.py PACKAGE hairball.glb

PACKAGE is the folder into which Debian's package embree-tools was unpacked.
"""

import gzip
import math
import os
import sys
import zlib
from array import array

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer
from packages import Package, main_arguments
from staging import add_studio, bounds

CREDITS = ("Hair: furBall_A of Embree, Copyright 2009-2018 Intel Corporation, "
           "Apache-2.0 (https://www.apache.org/licenses/LICENSE-2.0), made "
           "into prisms and staged by the TP project")
CURVES = "usr/share/doc/embree3/models/furBall_A.bin.gz"
STRANDS, SEGMENTS, SIDES = 30367, 15, 3
TRIANGLES = STRANDS * SEGMENTS * SIDES * 2


def read_curves(package, strands):
    """The points of all hairs as x, y, z, radius, x, y, z, radius..."""
    try:
        with gzip.open(package.path(CURVES)) as file:
            data = file.read()
    except (OSError, EOFError, zlib.error) as error:
        package.reject(CURVES, error)
    segments, points = array("I"), array("f")
    segment_bytes = 4 * strands * SEGMENTS
    if len(data) != segment_bytes + 16 * strands * (SEGMENTS + 1):
        package.reject(CURVES, f"{len(data)} bytes are not {strands} hairs")
    segments.frombytes(data[:segment_bytes])
    points.frombytes(data[segment_bytes:])
    if sys.byteorder == "big":
        segments.byteswap()
        points.byteswap()
    expected = array("I", (strand * (SEGMENTS + 1) + segment
                           for strand in range(strands)
                           for segment in range(SEGMENTS)))
    if segments != expected:
        package.reject(CURVES, f"the hairs do not have {SEGMENTS} segments")
    return points


def perpendicular(x, y, z):
    """Any vector at right angles to the given one."""
    return (0.0, z, -y) if abs(x) < abs(y) else (-z, 0.0, x)


def prism_corners(points, strands):
    """The corners of all prisms: SIDES around each point of a hair, in a frame
    that turns with the hair but not about it."""
    corners = array("f")
    directions = [(math.cos(a), math.sin(a)) for a in
                  (2 * math.pi * side / SIDES for side in range(SIDES))]
    per_strand = SEGMENTS + 1
    for strand in range(strands):
        first = 4 * per_strand * strand
        normal = None
        for number in range(per_strand):
            here = first + 4 * number
            before = here - 4 if number != 0 else here
            after = here + 4 if number != SEGMENTS else here
            tx = points[after] - points[before]
            ty = points[after + 1] - points[before + 1]
            tz = points[after + 2] - points[before + 2]
            length = math.sqrt(tx * tx + ty * ty + tz * tz)
            tx, ty, tz = tx / length, ty / length, tz / length
            nx, ny, nz = normal or perpendicular(tx, ty, tz)
            lean = nx * tx + ny * ty + nz * tz
            nx, ny, nz = nx - lean * tx, ny - lean * ty, nz - lean * tz
            length = math.sqrt(nx * nx + ny * ny + nz * nz)
            normal = nx, ny, nz = nx / length, ny / length, nz / length
            bx, by, bz = ty * nz - tz * ny, tz * nx - tx * nz, tx * ny - ty * nx
            x, y, z, radius = points[here:here + 4]
            for cos, sin in directions:
                n, b = radius * cos, radius * sin
                corners.extend((x + n * nx + b * bx, y + n * ny + b * by,
                                z + n * nz + b * bz))
    return corners


def prism_indices(strands):
    """Two triangles for each side of each segment."""
    pattern = []
    for segment in range(SEGMENTS):
        for side in range(SIDES):
            a, b = SIDES * segment + side, SIDES * segment + (side + 1) % SIDES
            pattern += [a, b, b + SIDES, a, b + SIDES, a + SIDES]
    indices = array("I")
    corners_per_strand = SIDES * (SEGMENTS + 1)
    for first in range(0, strands * corners_per_strand, corners_per_strand):
        indices.extend([first + corner for corner in pattern])
    return indices


def main():
    folder, target = main_arguments(__doc__)
    package = Package("embree-tools", folder)
    points = read_curves(package, STRANDS)
    try:
        corners = prism_corners(points, STRANDS)
    except ZeroDivisionError:
        package.reject(CURVES, "two neighbours on a hair are equal")
    indices = prism_indices(STRANDS)
    package.check_count(CURVES, len(indices) // 3, TRIANGLES)
    writer = Writer(CREDITS)
    hair = writer.add_material("hair", (0.64, 0.456, 0.256))
    writer.add_root({"name": "hair", "mesh": writer.add("meshes", {
        "name": "hair", "primitives": [writer.primitive(
            corners, hair, indices=indices, index_component="I")]})})
    add_studio(writer, *bounds(corners), view=(0.2, 0.25, 1), fill=1.6)
    writer.write_binary(target)


if __name__ == "__main__":
    main()
