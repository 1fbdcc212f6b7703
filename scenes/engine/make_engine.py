#!/usr/bin/env python3
#===- make_engine.py - Writes a hall of engines ---------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes nine two-cylinder engines in a studio: 75,730 triangles that nodes,
transforms within transforms, place as 9 x 121,496 = 1,093,464.

Usage: make_engine.py PACKAGE engine.glb

PACKAGE is the folder into which Debian's package assimp-testmodels was
unpacked.
"""

import json
import math
import os
import struct
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                ".."))
from gltf_writer import Writer
from packages import Package, main_arguments
from staging import add_studio

CREDITS = ("2CylinderEngine of the Khronos glTF sample models, from "
           "assimp-testmodels, BSD-3-clause, Copyright 2006-2022 ASSIMP "
           "Development Team, copied and staged by the TP project")
MODEL = ("usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/"
         "2CylinderEngine.glb")
UNIQUE_TRIANGLES, INSTANCED_TRIANGLES = 75730, 121496
ROWS, COLUMNS = 3, 3
# In the model's unit, millimetres.
SPACING = (1000, 1000)


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
