# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Checks the prisms of make_hairball.py: the corners around a point are on its
circle, evenly, and the triangles of a hair join neighbouring rings of it."""

import math
import os
import random
import sys
from array import array

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "../../../scenes/hairball"))
from make_hairball import SEGMENTS, SIDES, prism_corners, prism_indices

STRANDS = 20


def random_hairs():
    numbers = random.Random(1)
    points = array("f")
    for _ in range(STRANDS):
        position = [0.0, 0.0, 0.0]
        for _ in range(SEGMENTS + 1):
            position = [x + numbers.uniform(-0.3, 1) for x in position]
            points.extend([*position, numbers.uniform(0.01, 0.05)])
    return points


def main():
    points = random_hairs()
    corners = prism_corners(points, STRANDS)
    triples = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    rings = [triples[i:i + SIDES] for i in range(0, len(triples), SIDES)]
    assert len(rings) == STRANDS * (SEGMENTS + 1), len(rings)
    for number, ring in enumerate(rings):
        *center, radius = points[4 * number:4 * number + 4]
        for side, corner in enumerate(ring):
            assert abs(math.dist(center, corner) - radius) < 1e-5, number
            edge = math.dist(corner, ring[(side + 1) % SIDES])
            assert abs(edge - radius * math.sqrt(3)) < 1e-5, number

    indices = prism_indices(STRANDS)
    per_strand = SEGMENTS * SIDES * 6
    assert len(indices) == STRANDS * per_strand
    for strand in range(STRANDS):
        used = set(indices[strand * per_strand:(strand + 1) * per_strand])
        first = strand * SIDES * (SEGMENTS + 1)
        assert used == set(range(first, first + SIDES * (SEGMENTS + 1)))
    for triangle in range(0, len(indices), 3):
        used_rings = {i // SIDES for i in indices[triangle:triangle + 3]}
        assert len(used_rings) == 2 and max(used_rings) - min(used_rings) == 1
    print(f"{len(indices) // 3} triangles checked")


main()
