#===- obj_reader.py - Triangles of Wavefront OBJ files --------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reads the positions and faces of OBJ files, which is all the scene generators
need."""


class ObjError(ValueError):
    """Names the line."""


class ObjModel:
    """vertices: (x, y, z) each. parts: (name of the material, its triangles as
    three numbers of vertices each), one for each usemtl line, in order."""

    def __init__(self):
        self.vertices = []
        self.parts = []

    def triangles(self):
        return [t for _, triangles in self.parts for t in triangles]

    def add_face(self, corners):
        """A polygon becomes a fan; one of two corners, which models have,
        nothing."""
        numbers = []
        for corner in corners:
            number = int(corner.split("/", 1)[0])
            index = number - 1 if number > 0 else len(self.vertices) + number
            if number == 0 or not 0 <= index < len(self.vertices):
                raise ValueError(f"there is no vertex {number}")
            numbers.append(index)
        if not self.parts:
            self.parts.append(("", []))
        self.parts[-1][1].extend((numbers[0], numbers[i], numbers[i + 1])
                                 for i in range(1, len(numbers) - 1))


def read_obj(text):
    model = ObjModel()
    for line_number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        try:
            if words[:1] == ["v"]:
                x, y, z = map(float, words[1:4])
                model.vertices.append((x, y, z))
            elif words[:1] == ["f"]:
                model.add_face(words[1:])
            elif words[:1] == ["usemtl"]:
                model.parts.append((" ".join(words[1:]), []))
        except ValueError as error:
            raise ObjError(f"line {line_number}: {error}") from None
    return model
