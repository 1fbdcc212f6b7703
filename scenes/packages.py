#===- packages.py - Models from Debian packages ---------------------------===#
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the scene generators share that read models out of Debian packages:
errors, and the check that a package still holds the model we know."""

import os
import sys
import zipfile
import zlib

from obj_reader import ObjError, read_obj


def fail(message):
    sys.exit(f"error: {message}")


class Package:
    """A Debian package, unpacked into a folder."""

    def __init__(self, name, folder):
        self.name = name
        self.folder = folder

    def path(self, file):
        """Where a file of the package is."""
        path = os.path.join(self.folder, file)
        if not os.path.isfile(path):
            fail(f"{path}: no such file; {self.folder} should be Debian's "
                 f"package {self.name}, unpacked (see scripts/scenes.sh)")
        return path

    def reject(self, file, reason):
        fail(f"{os.path.join(self.folder, file)}: {reason}; Debian's package "
             f"{self.name} is damaged, or its model has changed")

    def read_obj(self, file):
        """A Wavefront OBJ file of the package."""
        with open(self.path(file), encoding="latin1") as stream:
            return self._parse_obj(file, stream.read())

    def read_zipped_obj(self, archive, member):
        """A Wavefront OBJ file in a zip archive of the package."""
        try:
            with zipfile.ZipFile(self.path(archive)) as models:
                text = models.read(member).decode("latin1")
        except (OSError, EOFError, KeyError, zipfile.BadZipFile,
                zlib.error) as error:
            self.reject(archive, error)
        return self._parse_obj(f"{archive}: {member}", text)

    def _parse_obj(self, name, text):
        try:
            return read_obj(text)
        except ObjError as error:
            self.reject(name, error)

    def check_count(self, file, triangles, expected):
        if triangles != expected:
            self.reject(file, f"{triangles} triangles instead of {expected}")


def main_arguments(usage):
    """(folder of the package, scene to write) from the command line."""
    if len(sys.argv) != 3:
        sys.exit(usage)
    return sys.argv[1:]
