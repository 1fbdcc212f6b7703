# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What tpsim --trace-cache writes (docs/tpsim.md, "A deletion in the cache")."""

import dataclasses
import json

from experiment.errors import BenchError

FORMAT_VERSION = 1


@dataclasses.dataclass
class Pointer:
    """To a child: its slot, or None if only memory has it."""

    slot: int | None
    is_leaf: bool = False


@dataclasses.dataclass
class Slot:
    index: int
    loaded: bool = False
    kind: str = ""
    # What it holds, in words.
    source: str = ""
    # None where there is no child.
    pointers: list[Pointer | None] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Trace:
    thread: int
    deletion: int
    ray: int
    # Slots from the root to the node whose child is to be loaded.
    path: list[int]
    freed: list[int]
    before: list[Slot]
    after: list[Slot]
    # The slot of the root.
    root: int

    def was_deleted(self, index, child):
        """Whether a slot's pointer named the deleted branch."""
        pointers = self.before[index].pointers
        pointer = pointers[child] if child < len(pointers) else None
        return pointer is not None and pointer.slot in self.freed[:1]


def describe_source(kind, reference, slot_triangles):
    """A leaf's reference is that of leafReference() in
    kernels/common/SceneLayout.h."""
    word = int(reference, 16)
    if kind != "leaf":
        return f"node {word:#x}"
    first = (word & 0x7FFFFFFF) >> 4
    count = min(word & 15, slot_triangles)
    return (f"triangle {first}" if count == 1
            else f"triangles {first}–{first + count - 1}")


def read_pointer(entry):
    if entry["to"] == "nothing":
        return None
    if entry["to"] == "slot":
        return Pointer(entry["slot"])
    return Pointer(None, entry["type"] == "leaf")


def read_slot(index, entry, slot_triangles):
    if not entry["loaded"]:
        return Slot(index)
    return Slot(index, True, entry["type"],
                describe_source(entry["type"], entry["source"], slot_triangles),
                [read_pointer(pointer) for pointer in entry["pointers"]])


def make_trace(content):
    if content["format_version"] != FORMAT_VERSION:
        raise ValueError(f"format {content['format_version']}, not "
                         f"{FORMAT_VERSION}")
    before, after = ([read_slot(index, entry, content["slot_triangles"])
                      for index, entry in enumerate(content[when])]
                     for when in ("before", "after"))
    root, = (index for index, entry in enumerate(content["before"])
             if entry["loaded"] and entry["parent"] is None)
    return Trace(content["thread"], content["deletion"], content["ray"],
                 content["path"], content["freed"], before, after, root)


def read_trace(path):
    try:
        return make_trace(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BenchError(f"{path}: not a trace of tpsim --trace-cache "
                         f"({type(error).__name__}: {error})") from error
