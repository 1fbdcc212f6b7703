# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The tree that the slots hold, root on top."""

from .style import FADED, LINE, draw_unloaded, role, stub_color

LEVEL = 46
RADIUS = 11
# Between neighbours without loaded children.
WIDEST_PITCH = 24


class TreeLayout:
    """Where slots and children that are not loaded lie: each child that has
    none takes one column, a parent is over the middle of its children."""

    def __init__(self, slots, root):
        self.slots = slots
        self.columns = 0
        self.depth = 0
        # {slot: (column, level)}; {(slot, child): (column, level)}.
        self.nodes = {}
        self.stubs = {}
        self.place(root, 0)

    def place(self, index, level):
        self.depth = max(self.depth, level)
        columns = []
        for child, pointer in enumerate(self.slots[index].pointers):
            if pointer is None:
                continue
            if pointer.slot is not None:
                columns.append(self.place(pointer.slot, level + 1))
            else:
                self.stubs[index, child] = (self.take_column(), level + 1)
                columns.append(self.stubs[index, child][0])
        column = ((columns[0] + columns[-1]) / 2 if columns
                  else self.take_column())
        self.nodes[index] = (column, level)
        return column

    def take_column(self):
        self.columns += 1
        return self.columns - 1


def draw_tree(drawing, trace, slots, root, left, top, width):
    """Returns the height."""
    layout = TreeLayout(slots, root)
    pitch = min(WIDEST_PITCH, (width - 2 * RADIUS) / max(1, layout.columns - 1))
    indent = (width - pitch * (layout.columns - 1)) / 2

    def at(place):
        column, level = place
        return left + indent + column * pitch, top + RADIUS + level * LEVEL

    for index, place in layout.nodes.items():
        for child, pointer in enumerate(slots[index].pointers):
            if pointer is not None and pointer.slot is not None:
                draw_edge(drawing, at(place), at(layout.nodes[pointer.slot]),
                          role(trace, pointer.slot)[0], 2.5)
            elif pointer is not None:
                draw_edge(drawing, at(place), at(layout.stubs[index, child]),
                          stub_color(trace, index, child), 0.8)
    for (index, child), place in layout.stubs.items():
        draw_unloaded(drawing, *at(place), slots[index].pointers[child].is_leaf,
                      stub_color(trace, index, child))
    for index, place in layout.nodes.items():
        draw_node(drawing, trace, slots[index], *at(place))
    height = (layout.depth + 1) * LEVEL
    drawing.reach(left + width, top + height)
    return height


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
