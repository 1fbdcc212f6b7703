#===- gltf_writer.py - Writing small glTF files ---------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the scene generators share: collecting glTF objects and one buffer, and
writing them as text with the buffer inside, or as binary GLB."""

import base64
import json
import struct
import sys
from array import array
from itertools import chain

POINTS, LINES, TRIANGLES, STRIP, FAN = 0, 1, 4, 5, 6
COMPONENT_TYPES = {"B": 5121, "H": 5123, "I": 5125, "f": 5126}
WIDTHS = {"SCALAR": 1, "VEC3": 3}


class Writer:
    def __init__(self, copyright):
        self.binary = bytearray()
        self.document = {
            "asset": {
                "version": "2.0",
                "generator": "scenes/gltf_writer.py",
                "copyright": copyright,
            },
            "scene": 0,
            "scenes": [{"nodes": []}],
        }

    def add(self, kind, element):
        """Appends to one of the document's arrays; returns the index."""
        array = self.document.setdefault(kind, [])
        array.append(element)
        return len(array) - 1

    def add_root(self, node):
        self.document["scenes"][0]["nodes"].append(self.add("nodes", node))

    def add_material(self, name, base_color, emission=None):
        """Emission above 1 is split into a factor and a strength."""
        material = {
            "name": name,
            "doubleSided": True,
            "pbrMetallicRoughness": {
                "baseColorFactor": [*base_color, 1],
                "metallicFactor": 0,
            },
        }
        if emission:
            strength = max(emission)
            material["emissiveFactor"] = [e / strength for e in emission]
            material["extensions"] = {
                "KHR_materials_emissive_strength":
                    {"emissiveStrength": strength}
            }
            self.document["extensionsUsed"] = [
                "KHR_materials_emissive_strength"]
        return self.add("materials", material)

    def add_accessor(self, component, kind, rows):
        """Rows of numbers, or an array of all their numbers, tightly packed;
        component is a letter of struct and array."""
        numbers = flatten(component, rows)
        width = WIDTHS[kind]
        accessor = {
            "bufferView": self.add_view(numbers),
            "componentType": COMPONENT_TYPES[component],
            "count": len(numbers) // width,
            "type": kind,
        }
        if kind == "VEC3":
            columns = [numbers[axis::width] for axis in range(width)]
            accessor["min"] = [min(column) for column in columns]
            accessor["max"] = [max(column) for column in columns]
        return self.add("accessors", accessor)

    def add_view(self, numbers):
        self.binary += b"\0" * (-len(self.binary) % 4)
        if sys.byteorder == "big":
            numbers = array(numbers.typecode, numbers)
            numbers.byteswap()
        data = numbers.tobytes()
        view = self.add("bufferViews", {
            "buffer": 0,
            "byteOffset": len(self.binary),
            "byteLength": len(data),
        })
        self.binary += data
        return view

    def primitive(self, positions, material, mode=TRIANGLES, indices=None,
                  index_component="H"):
        result = {
            "attributes": {
                "POSITION": self.add_accessor("f", "VEC3", positions)},
            "material": material,
            "mode": mode,
        }
        if indices is not None:
            result["indices"] = self.add_accessor(
                index_component, "SCALAR", array(index_component, indices))
        return result

    def quads(self, quads, material):
        """A primitive of two triangles for each quad of four corners."""
        positions = [corner for quad in quads for corner in quad]
        indices = [4 * quad + corner for quad in range(len(quads))
                   for corner in (0, 1, 2, 0, 2, 3)]
        return self.primitive(positions, material, indices=indices)

    def write_text(self, path):
        data = base64.b64encode(bytes(self.binary)).decode()
        self.document["buffers"] = [{
            "byteLength": len(self.binary),
            "uri": "data:application/octet-stream;base64," + data,
        }]
        text = json.dumps(self.document, indent=1) + "\n"
        write_file(path, text.encode())

    def write_binary(self, path):
        self.document["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.document).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + b"\0" * (-len(self.binary) % 4)
        length = 12 + 8 + len(text) + 8 + len(binary)
        write_file(
            path,
            struct.pack("<4sII", b"glTF", 2, length),
            struct.pack("<I4s", len(text), b"JSON"), text,
            struct.pack("<I4s", len(binary), b"BIN\0"), binary)


def write_file(path, *parts):
    try:
        with open(path, "wb") as file:
            for part in parts:
                file.write(part)
    except OSError as error:
        sys.exit(f"error: cannot write {path}: {error.strerror}")


def flatten(component, rows):
    """All numbers of the rows, if they are not in an array yet."""
    if isinstance(rows, array):
        return rows
    return array(component, chain.from_iterable(rows))
