# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A series of intervals as a picture: where the thread-cycles went, and below
the traffic and the hit rates of the levels of memory that the chip has."""

from deletion.svg import Drawing

WIDTH, LEFT, TOP = 640, 48, 28
LEGEND = LEFT + WIDTH + 14
GRAY, FRAME = "#888888", "#444444"

# From the bottom up; a reason that is never above VISIBLE is left out.
VISIBLE = 0.002
REASONS = (
    ("instructions", "issued", "#2f8f4e"),
    ("lost_data", "data", "#f2c14e"),
    ("lost_memory", "memory", "#b5179e"),
    ("lost_l1", "L1", "#9ecae1"),
    ("lost_l2", "L2", "#4292c6"),
    ("lost_dram", "DRAM", "#08519c"),
    ("lost_store_buffer", "store buffer", "#6a51a3"),
    ("lost_unit_conflict", "unit conflict", "#e8751a"),
    ("lost_icache_conflict", "icache conflict", "#c0392b"),
    ("lost_icache_miss", "icache miss", "#7b241c"),
    ("lost_branch", "branch", "#a6761d"),
    ("lost_barrier", "barrier", "#bdbdbd"),
    ("lost_sync", "sync", "#969696"),
    ("lost_sleep", "sleep", "#d9d9d9"),
    ("lost_finished", "finished", "#f0f0f0"),
)
TRAFFIC = (
    ("l1_read_bytes_per_cycle", "L1 reads", "#4292c6"),
    ("crossbar_answer_bytes_per_cycle", "crossbar answers", "#2f8f4e"),
    ("dram_read_bytes_per_cycle", "DRAM reads", "#08519c"),
    ("dram_written_bytes_per_cycle", "DRAM writes", "#e8751a"),
)
RATES = (
    ("l1_hit_rate", "L1 hits", "#9ecae1"),
    ("l2_hit_rate", "L2 hits", "#4292c6"),
    ("dram_row_hit_rate", "DRAM row hits", "#08519c"),
    ("dram_share_of_peak", "DRAM peak", "#e8751a"),
)


class Panel:
    """A chart over the cycles of a series, whose y axis goes from 0 to top."""

    def __init__(self, drawing, series, y, height, top):
        self.drawing, self.series = drawing, series
        self.y, self.height, self.top = y, height, top
        self.begin, self.end = series[0].begin, series[-1].end
        self.names = 0

    def x_of(self, cycle):
        return LEFT + WIDTH * (cycle - self.begin) / (self.end - self.begin)

    def y_of(self, value):
        return self.y + self.height * (1 - value / self.top)

    def steps(self, values):
        """Points of a curve that is constant in each interval."""
        return [(x, self.y_of(value))
                for interval, value in zip(self.series, values)
                for x in (self.x_of(interval.begin), self.x_of(interval.end))]

    def area(self, lower, upper, color):
        points = self.steps(upper) + self.steps(lower)[::-1]
        self.drawing.add("polygon", points=joined(points), fill=color)

    def curve(self, values, color):
        self.drawing.add("polyline", points=joined(self.steps(values)),
                         fill="none", stroke=color, stroke_width=1.6)

    def name(self, text, color):
        y = self.y + 12 + 17 * self.names
        self.drawing.rectangle(LEGEND, y - 9, 10, 10, fill=color, stroke=GRAY,
                               stroke_width=0.5)
        self.drawing.text(LEGEND + 16, y, text)
        self.drawing.reach(LEGEND + 110, y)
        self.names += 1

    def frame(self, title, unit):
        self.drawing.text(LEFT, self.y - 9, title, font_weight="bold")
        self.drawing.rectangle(LEFT, self.y, WIDTH, self.height, fill="none",
                               stroke=FRAME)
        for share in (0, 0.5, 1):
            value = self.top * share
            y = self.y_of(value)
            self.drawing.line(LEFT - 4, y, LEFT, y, stroke=FRAME)
            self.drawing.text(LEFT - 7, y + 4, f"{value:g}{unit}",
                              text_anchor="end", font_size=11)

    def cycles(self):
        """The x axis, below this panel."""
        for cycle in ticks(self.begin, self.end):
            x, y = self.x_of(cycle), self.y + self.height
            self.drawing.line(x, y, x, y + 4, stroke=FRAME)
            self.drawing.text(x, y + 17, f"{cycle:,}", text_anchor="middle",
                              font_size=11)
        self.drawing.text(LEGEND, self.y + self.height + 17, "cycle",
                          font_size=11)
        self.drawing.reach(0, self.y + self.height + 20)


def joined(points):
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)


def round_up(value, parts=(1, 2, 4, 5, 8, 10)):
    """The least round number that is not below a positive one."""
    power = 1.0
    while power * 10 <= value:
        power *= 10
    while power > value:
        power /= 10
    return next(power * part for part in parts if power * part >= value)


def ticks(begin, end):
    step = int(max(round_up((end - begin) / 6, (1, 2, 5, 10)), 1))
    return range(-(-begin // step) * step, end + 1, step)


def draw_losses(drawing, series, y):
    panel = Panel(drawing, series, y, 220, 100)
    lower = [0.0] * len(series)
    names = []
    for column, name, color in REASONS:
        shares = [100 * interval.share(column) for interval in series]
        upper = [low + share for low, share in zip(lower, shares)]
        if max(shares) > 100 * VISIBLE:
            panel.area(lower, upper, color)
            names.append((name, color))
        lower = upper
    for name, color in reversed(names):
        panel.name(name, color)
    panel.frame("thread-cycles", " %")
    return panel


def draw_curves(drawing, series, y, curves, title, unit, scale, top=None):
    """None if the series has none of the curves."""
    curves = [curve for curve in curves if curve[0] in series[0].values]
    if not curves:
        return None
    values = [[scale * interval.values[column] for interval in series]
              for column, _, _ in curves]
    largest = max(max(line) for line in values)
    panel = Panel(drawing, series, y, 110, top or round_up(max(largest, 1e-3)))
    for (_, name, color), line in zip(curves, values):
        panel.curve(line, color)
        panel.name(name, color)
    panel.frame(title, unit)
    return panel


def draw_picture(series):
    """The SVG file as text."""
    drawing = Drawing()
    panel = draw_losses(drawing, series, TOP)
    for curves, title, unit, scale, top in (
            (TRAFFIC, "traffic, bytes per cycle", "", 1, None),
            (RATES, "hit rates and share of DRAM's peak", " %", 100, 100)):
        below = panel.y + panel.height + 34
        panel = draw_curves(drawing, series, below, curves, title, unit, scale,
                            top) or panel
    panel.cycles()
    return drawing.finish((), 12)
