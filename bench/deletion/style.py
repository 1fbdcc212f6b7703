# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What table and tree share; colours that the colour-blind can tell apart."""

PATH = "#0072B2"
PATH_TINT = "#D3E8F4"
FREED = "#D55E00"
FREED_TINT = "#FBE0CC"
LINE = "#444444"
FADED = "#9A9A9A"
FAINT = "#DDDDDD"
ARROW_COLORS = (PATH, FREED, LINE)


def role(trace, index):
    """The colour and tint of a slot: on the current path, of the branch that is
    deleted, or neither."""
    if index in trace.path:
        return PATH, PATH_TINT
    if index in trace.freed:
        return FREED, FREED_TINT
    return LINE, "white"


def stub_color(trace, index, child):
    """Of a child that is only in memory."""
    return FREED if trace.was_deleted(index, child) else FADED


def draw_unloaded(drawing, x, y, is_leaf, color=FADED):
    """The mark of a child that is only in memory."""
    if is_leaf:
        drawing.add("path", d=f"M{x:g} {y - 4:g} l4.5 8 h-9 Z", fill="white",
                    stroke=color)
    else:
        drawing.add("circle", cx=x, cy=y, r=4, fill="white", stroke=color)
