#===- vectors.py - Tuples as vectors --------------------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the scene generators share to compute with three numbers."""

import math


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def along(a, direction, distance):
    """The point at a distance from a."""
    return tuple(x + distance * y for x, y in zip(a, direction))


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])
