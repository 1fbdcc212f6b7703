# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Before and after side by side: the slots, and below them the tree."""

from .style import (ARROW_COLORS, FADED, FREED, FREED_TINT, PATH, PATH_TINT,
                    draw_unloaded)
from .svg import Drawing
from .table import ARROWS, TABLE_WIDTH, draw_table
from .tree import draw_tree

MARGIN = 16
PANEL = TABLE_WIDTH + ARROWS
GAP = 24


def draw_picture(trace):
    """The text of an SVG file."""
    drawing = Drawing()
    slots = "slot" if len(trace.freed) == 1 else "slots"
    titles = (f"Before the deletion: all {len(trace.before)} slots are in use",
              f"After it: {len(trace.freed)} {slots} free")
    bottom = 0
    for number, (title, state) in enumerate(zip(titles,
                                                (trace.before, trace.after))):
        left = MARGIN + number * (PANEL + GAP)
        drawing.text(left, 28, title, font_size=14, font_weight="bold")
        top = 42 + draw_table(drawing, trace, state, left, 42) + 20
        bottom = max(bottom, top + draw_tree(drawing, trace, state, trace.root,
                                             left, top, PANEL - GAP))
    draw_legend(drawing, MARGIN, bottom + 4)
    return drawing.finish(ARROW_COLORS, MARGIN)


def draw_legend(drawing, x, y):
    entries = [(PATH, PATH_TINT, "current path (thick: where the ray is)", 270),
               (FREED, FREED_TINT, "branch that is deleted", 180)]
    for color, tint, text, width in entries:
        drawing.rectangle(x, y, 14, 14, fill=tint, stroke=color)
        drawing.text(x + 22, y + 12, text)
        x += width
    for is_leaf, text, width in ((False, "node only in memory", 170),
                                 (True, "leaf only in memory", 160)):
        draw_unloaded(drawing, x + 6, y + 8, is_leaf)
        drawing.text(x + 18, y + 12, text)
        x += width
    drawing.text(x, y + 12, "·", fill=FADED)
    drawing.text(x + 14, y + 12, "no child")
    drawing.reach(x + 80, y + 16)
