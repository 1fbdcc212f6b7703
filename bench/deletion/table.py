# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The slots of the cache as a table with arrows."""

from .style import FADED, FAINT, draw_unloaded, role, stub_color

ROW = 22
# Title and width.
COLUMNS = [("INDEX", 52), ("LOADED", 62), ("TYPE", 70), ("FROM MEMORY", 150)]
POINTER = 30
POINTERS = 4
TABLE_WIDTH = sum(width for _, width in COLUMNS) + POINTERS * POINTER
# Beside the table, for arrows.
ARROWS = 74


def draw_table(drawing, trace, slots, left, top):
    """Returns the height."""
    x = left
    for title, width in [*COLUMNS, ("POINTERS", POINTERS * POINTER)]:
        drawing.text(x + 6, top + 15, title, font_size=10, font_weight="bold")
        x += width
    body = top + ROW
    for slot in slots:
        draw_row(drawing, trace, slot, left, body + slot.index * ROW)
    for row in range(len(slots) + 1):
        drawing.line(left, body + row * ROW, left + TABLE_WIDTH,
                     body + row * ROW, stroke=FAINT)
    draw_arrows(drawing, trace, slots, left + TABLE_WIDTH, body)
    drawing.reach(left + TABLE_WIDTH + ARROWS, body + len(slots) * ROW)
    return (len(slots) + 1) * ROW


def draw_row(drawing, trace, slot, left, top):
    """An empty slot's row is grey."""
    _, tint = role(trace, slot.index) if slot.loaded else (None, "#F2F2F2")
    drawing.rectangle(left, top, TABLE_WIDTH, ROW, fill=tint)
    color = "black" if slot.loaded else FADED
    cells = [str(slot.index), "1" if slot.loaded else "–",
             slot.kind if slot.loaded else "<empty>", slot.source]
    x = left
    for text, (_, width) in zip(cells, COLUMNS):
        if text:
            drawing.text(x + 6, top + 15, text, fill=color)
        x += width
    for child, pointer in enumerate(slot.pointers):
        draw_pointer(drawing, pointer, x + (child + 0.5) * POINTER, top,
                     stub_color(trace, slot.index, child))


def draw_pointer(drawing, pointer, x, top, color):
    """The number of the slot, or a mark."""
    if pointer is None:
        drawing.text(x, top + 15, "·", text_anchor="middle", fill=FADED)
    elif pointer.slot is None:
        draw_unloaded(drawing, x, top + ROW / 2, pointer.is_leaf, color)
    else:
        drawing.text(x, top + 15, str(pointer.slot), text_anchor="middle",
                     font_weight="bold")


def draw_arrows(drawing, trace, slots, x, top):
    """From each slot to those that its pointers name; long ones swing out."""
    for slot in slots:
        for child, pointer in enumerate(slot.pointers):
            if pointer is None or pointer.slot is None:
                continue
            start = top + slot.index * ROW + 5 + 4 * child
            end = top + (pointer.slot + 0.5) * ROW
            rows = abs(pointer.slot - slot.index)
            swing = min(ARROWS * 1.25, 16 + 7 * rows)
            drawing.arrow(f"M{x:g} {start:g} C{x + swing:g} {start:g} "
                          f"{x + swing:g} {end:g} {x + 1:g} {end:g}",
                          role(trace, pointer.slot)[0])
