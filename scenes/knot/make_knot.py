#!/usr/bin/env python3
#===- make_knot.py - Writes a smooth mesh of any size ---------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes a trefoil knot with a rippled surface above a floor, lit by a lamp: a
mesh of even triangles, as scanned models are. By default it has as many as the
Stanford bunny, give or take some (69,632; the bunny 69,451).

Usage: make_knot.py knot.glb [SEGMENTS SIDES]

The knot has 2 * SEGMENTS * SIDES triangles.
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer
from vectors import cross, subtract, unit

SEGMENTS, SIDES = 544, 64
TUBE_RADIUS, RIPPLE, RIPPLES_ALONG, RIPPLES_AROUND = 0.6, 0.06, 60, 7
FLOOR, LAMP = -2, 6


def center(t):
    """The trefoil, from 0 to 2 pi."""
    return (math.sin(t) + 2 * math.sin(2 * t),
            math.cos(t) - 2 * math.cos(2 * t),
            -math.sin(3 * t))


def ring(t, sides):
    """The points around the tube at t."""
    step = 1e-4
    here = center(t)
    tangent = unit(subtract(center(t + step), center(t - step)))
    across = unit(cross(tangent, (0, 0, 1)))
    up = cross(across, tangent)
    points = []
    for side in range(sides):
        angle = 2 * math.pi * side / sides
        radius = TUBE_RADIUS + RIPPLE * (
            math.sin(RIPPLES_ALONG * t) * math.cos(RIPPLES_AROUND * angle))
        points.append(tuple(
            c + radius * (math.cos(angle) * a + math.sin(angle) * u)
            for c, a, u in zip(here, across, up)))
    return points


def knot(segments, sides):
    """(positions, indices)"""
    positions, indices = [], []
    for segment in range(segments):
        positions += ring(2 * math.pi * segment / segments, sides)
        for side in range(sides):
            here, there = segment * sides, (segment + 1) % segments * sides
            other = (side + 1) % sides
            a, b = here + side, here + other
            c, d = there + other, there + side
            indices += [a, b, c, a, c, d]
    return positions, indices


def square(size, height):
    return [(-size, -size, height), (size, -size, height),
            (size, size, height), (-size, size, height)]


def main():
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    segments, sides = map(int, sys.argv[2:] or (SEGMENTS, SIDES))
    writer = Writer("Public domain")
    positions, indices = knot(segments, sides)
    white = writer.add_material("knot", (0.8, 0.7, 0.5))
    floor = writer.add_material("floor", (0.5, 0.5, 0.5))
    lamp = writer.add_material("lamp", (0.8, 0.8, 0.8), (8, 8, 8))
    for name, primitive in [
            ("knot", writer.primitive(positions, white, indices=indices,
                                      index_component="I")),
            ("floor", writer.quads([square(12, FLOOR)], floor)),
            ("lamp", writer.quads([square(2, LAMP)], lamp))]:
        mesh = writer.add("meshes", {"name": name, "primitives": [primitive]})
        writer.add_root({"name": name, "mesh": mesh})
    camera = writer.add("cameras", {
        "type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}})
    # Above and to the side, looking at the middle.
    tilt = math.radians(50) / 2
    writer.add_root({"name": "camera", "camera": camera,
                     "translation": (0, -7.7, 6.4),
                     "rotation": (math.sin(tilt), 0, 0, math.cos(tilt))})
    writer.write_binary(sys.argv[1])


main()
