# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The tree that the slots hold, root on top."""

import dataclasses

from .style import FADED, LINE, draw_unloaded, role, stub_color

LEVEL = 46
RADIUS = 11
STUB_RADIUS = 4.5
# Between neighbours of one level.
SPACE = 5


@dataclasses.dataclass
class Shape:
    """A subtree, laid out around its top at x = 0."""

    # {slot, or (slot, child) for a child that is not loaded: (x, level)}
    places: dict
    # (left, right) end of each level.
    extents: list

    def moved(self, distance):
        return Shape({key: (x + distance, level)
                      for key, (x, level) in self.places.items()},
                     [(left + distance, right + distance)
                      for left, right in self.extents])

    def distance_to(self, other):
        """How far right of this the other has to be."""
        return max(mine[1] + SPACE - its[0]
                   for mine, its in zip(self.extents, other.extents))


def lay_out(slots, index):
    """The shape of the subtree of a slot: its children's side by side, as close
    as their levels permit, the top over the middle of them."""
    children = [lay_out(slots, pointer.slot) if pointer.slot is not None
                else Shape({(index, child): (0, 0)},
                           [(-STUB_RADIUS, STUB_RADIUS)])
                for child, pointer in enumerate(slots[index].pointers)
                if pointer is not None]
    if not children:
        return Shape({index: (0, 0)}, [(-RADIUS, RADIUS)])
    row, last = children[0], 0
    for shape in children[1:]:
        last = row.distance_to(shape)
        row = beside(row, shape.moved(last))
    row = row.moved(-last / 2)
    return Shape({index: (0, 0), **{key: (x, level + 1)
                                    for key, (x, level) in row.places.items()}},
                 [(-RADIUS, RADIUS), *row.extents])


def beside(left, right):
    """Both as one shape."""
    shared = [(a[0], b[1]) for a, b in zip(left.extents, right.extents)]
    deeper = max(left.extents, right.extents, key=len)[len(shared):]
    return Shape({**left.places, **right.places}, shared + deeper)


def draw_tree(drawing, trace, slots, root, left, top, width):
    """Returns the height."""
    shape = lay_out(slots, root)
    start = min(extent[0] for extent in shape.extents)
    end = max(extent[1] for extent in shape.extents)
    scale = min(1.3, width / (end - start))
    middle = left + width / 2 - scale * (start + end) / 2

    def at(key):
        x, level = shape.places[key]
        return middle + scale * x, top + RADIUS + level * LEVEL

    for key in shape.places:
        if isinstance(key, int):
            draw_edges(drawing, trace, slots[key], at)
    for key in shape.places:
        if isinstance(key, int):
            draw_node(drawing, trace, slots[key], *at(key))
        else:
            slot, child = key
            draw_unloaded(drawing, *at(key), slots[slot].pointers[child].is_leaf,
                          stub_color(trace, slot, child))
    height = len(shape.extents) * LEVEL
    drawing.reach(left + width, top + height)
    return height


def draw_edges(drawing, trace, slot, at):
    """To the children of a slot; at() says where things are."""
    for child, pointer in enumerate(slot.pointers):
        if pointer is not None and pointer.slot is not None:
            draw_edge(drawing, at(slot.index), at(pointer.slot),
                      role(trace, pointer.slot)[0], 2.5)
        elif pointer is not None:
            draw_edge(drawing, at(slot.index), at((slot.index, child)),
                      stub_color(trace, slot.index, child), 0.8)


def draw_edge(drawing, start, end, color, width):
    drawing.line(*start, *end, stroke=color if color != LINE else FADED,
                 stroke_width=width)


def draw_node(drawing, trace, slot, x, y):
    """A circle for an inner node, a square for a leaf; the current one has a
    thick rim."""
    color, tint = role(trace, slot.index)
    rim = 3.5 if [slot.index] == trace.path[-1:] else 1.4
    if slot.kind == "leaf":
        side = 2 * RADIUS - 2
        drawing.rectangle(x - side / 2, y - side / 2, side, side, fill=tint,
                          stroke=color, stroke_width=rim)
    else:
        drawing.add("circle", cx=x, cy=y, r=RADIUS, fill=tint, stroke=color,
                    stroke_width=rim)
    drawing.text(x, y + 4, str(slot.index), text_anchor="middle", font_size=11)
