# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What is compiled: the loops of this folder and the kernels. All compilers get
the same text: it is preprocessed once, by tpcc with its headers."""

import dataclasses
import pathlib

from targets import HERE, ROOT

GROUPS = ("loops", "kernels", "functions")
KERNELS = ("pathtracer/PathTracer.cpp", "stackcache/StackCached.cpp",
           "bvhbuilder/BuildAndTrace.cpp", "bvhbuilder/BuildBvh.cpp",
           "bvhbuilder/SceneBvh.cpp", "bvh/BvhBuilder.cpp", "bvh/WideBvh.cpp",
           "bvh/QuantizedBvh.cpp", "examples/Histogram.cpp",
           "examples/TwoPassBuilder.cpp", "treecache/TreeCacheChecker.cpp",
           "treecache/TreeCacheVerifier.cpp")


@dataclasses.dataclass(frozen=True)
class Unit:
    """One source file."""

    group: str
    source: pathlib.Path
    preprocessed: pathlib.Path
    options: list

    @property
    def language(self):
        return "c" if self.source.suffix == ".c" else "c++"

    def preprocess(self, compiler):
        """The command that makes the text for all compilers."""
        language = [] if self.source.suffix == ".c" else ["-std=gnu++20"]
        return [compiler, *language, "-I", ROOT, "-E", "-P", self.source, "-o",
                self.preprocessed]


def all_units(folder):
    """The loops; the kernels; and the kernels' functions one by one, each
    called where its source calls it, so that all compilers make the same."""
    found = []
    kernels = [ROOT / "kernels" / name for name in KERNELS]
    for group, (sources, options) in zip(GROUPS, (
            (sorted((HERE / "loops").glob("*.c")), ["-fno-builtin"]),
            (kernels, ["-std=gnu++20"]),
            (kernels, ["-std=gnu++20", "-fno-inline"]))):
        for source in sources:
            suffix = ".i" if source.suffix == ".c" else ".ii"
            text = folder / (source.stem + suffix)
            found.append(Unit(group, source, text, options))
    return found
