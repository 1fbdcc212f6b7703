# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints what a well-formed SVG says: texts, or matplotlib's comments for texts
that it draws as outlines."""

import sys
import xml.dom.minidom


def texts(node):
    for child in node.childNodes:
        if child.nodeType == child.COMMENT_NODE:
            yield child.data.strip()
        elif child.nodeType == child.TEXT_NODE and child.data.strip():
            yield child.data.strip()
        yield from texts(child)


print("\n".join(texts(xml.dom.minidom.parse(sys.argv[1]).documentElement)))
