# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A drawing as SVG text. Lengths are pixels, the origin is top left."""

from xml.sax.saxutils import escape, quoteattr


class Drawing:
    def __init__(self):
        self.parts = []
        self.width = 0
        self.height = 0

    def reach(self, x, y):
        """Makes the drawing at least so large."""
        self.width, self.height = max(self.width, x), max(self.height, y)

    def add(self, name, content="", **attributes):
        """An element; _ in names of attributes stands for -."""
        words = "".join(f" {key.replace('_', '-')}={quoteattr(number(value))}"
                        for key, value in attributes.items())
        self.parts.append(f"<{name}{words}>{escape(content)}</{name}>" if content
                          else f"<{name}{words}/>")

    def text(self, x, y, content, **attributes):
        """The baseline of the text is at y."""
        self.add("text", content, x=x, y=y, **attributes)

    def rectangle(self, x, y, width, height, **attributes):
        self.add("rect", x=x, y=y, width=width, height=height, **attributes)
        self.reach(x + width, y + height)

    def line(self, x1, y1, x2, y2, **attributes):
        self.add("line", x1=x1, y1=y1, x2=x2, y2=y2, **attributes)

    def arrow(self, path, color):
        """Along the path, with a head at its end."""
        self.add("path", d=path, fill="none", stroke=color, stroke_width=1.4,
                 marker_end=f"url(#head-{color[1:]})")

    def finish(self, colors, margin):
        """The whole file; colors are those of arrows."""
        heads = "".join(
            f'<marker id="head-{color[1:]}" viewBox="0 0 8 8" refX="7" refY="4" '
            'markerWidth="7" markerHeight="7" orient="auto">'
            f'<path d="M0 0.5 L8 4 L0 7.5 Z" fill="{color}"/></marker>\n'
            for color in colors)
        width, height = self.width + margin, self.height + margin
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" '
                f'height="{height:g}" viewBox="0 0 {width:g} {height:g}" '
                'font-family="DejaVu Sans, Verdana, sans-serif" '
                f'font-size="12">\n<defs>\n{heads}</defs>\n'
                f'<rect width="{width:g}" height="{height:g}" fill="white"/>\n'
                + "\n".join(self.parts) + "\n</svg>\n")


def number(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)
