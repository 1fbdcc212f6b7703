#===- staging.py - Floor, lamps and camera around a model -----------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A photographer's studio for a model that stands on the plane y = low: floor,
backdrop, two square lamps and a camera; eight triangles."""

import math

from vectors import along, cross, subtract, unit

STAGE_TRIANGLES = 8
FLOOR_COLOR = (0.55, 0.55, 0.52)
LAMP_COLOR = (0.8, 0.8, 0.8)
# In radii of the model: how far the lamps are and half how wide.
LAMP_DISTANCE, LAMP_SIZE = 3.2, 0.9
FLOOR_SIZE, BACKDROP_DISTANCE = 14, 3


def frame(backward):
    """The axes (right, up, backward) of who looks against a unit vector."""
    right = unit(cross((0, 1, 0), backward))
    return right, cross(backward, right), backward


def bounds(*position_arrays):
    """(lower, upper) corner of arrays of x, y, z, x, y, z..."""
    columns = [[numbers[axis::3] for numbers in position_arrays]
               for axis in range(3)]
    return (tuple(min(map(min, column)) for column in columns),
            tuple(max(map(max, column)) for column in columns))


def add_camera(writer, eye, target, vertical_degrees):
    right, up, backward = frame(unit(subtract(eye, target)))
    camera = writer.add("cameras", {
        "type": "perspective",
        "perspective": {"yfov": math.radians(vertical_degrees),
                        "znear": 0.01}})
    writer.add_root({"name": "camera", "camera": camera, "matrix": [
        *right, 0, *up, 0, *backward, 0, *eye, 1]})


def add_lamp(writer, center, target, half_side, radiance):
    """A square that faces the target."""
    right, up, _ = frame(unit(subtract(center, target)))
    corners = [along(along(center, right, x * half_side), up, y * half_side)
               for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    add_quad(writer, "lamp", corners, LAMP_COLOR, radiance)


def add_quad(writer, name, corners, color, emission=None):
    material = writer.add_material(name, color, emission)
    writer.add_root({"name": name, "mesh": writer.add("meshes", {
        "name": name, "primitives": [writer.quads([corners], material)]})})


def add_studio(writer, lower, upper, view, vertical_degrees=36, fill=1.0):
    """Stages a model with the given bounds. The camera is where view points to
    from the model's middle; a sphere around the model is fill times as high as
    the picture."""
    middle = tuple((a + b) / 2 for a, b in zip(lower, upper))
    radius = math.dist(lower, upper) / 2
    eye_distance = radius / (
        fill * math.sin(math.radians(vertical_degrees) / 2))
    backward = unit(view)
    add_camera(writer, along(middle, backward, eye_distance), middle,
               vertical_degrees)

    size, floor = FLOOR_SIZE * radius, lower[1]
    x, _, z = middle
    back = z - BACKDROP_DISTANCE * radius
    add_quad(writer, "floor",
             [(x - size, floor, back), (x - size, floor, z + size),
              (x + size, floor, z + size), (x + size, floor, back)],
             FLOOR_COLOR)
    add_quad(writer, "backdrop",
             [(x - size, floor, back), (x + size, floor, back),
              (x + size, floor + size, back), (x - size, floor + size, back)],
             FLOOR_COLOR)
    for side, height, radiance in ((-1.3, 1.2, 8), (1.2, 0.6, 3)):
        direction = unit((side, height, 1))
        add_lamp(writer, along(middle, direction, LAMP_DISTANCE * radius),
                 middle, LAMP_SIZE * radius,
                 (radiance, radiance, 0.92 * radiance))
