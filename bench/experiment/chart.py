# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The results as pictures, by matplotlib: each as SVG and as PNG."""

from .errors import BenchError
from .table import in_units

# M. Okabe and K. Ito's colours, which the colour-blind can tell apart.
BASELINE_COLOR = "#E69F00"
CACHED_COLOR = "#0072B2"
LINE_STYLES = [("#0072B2", "o"), ("#D55E00", "s"), ("#009E73", "^"),
               ("#CC79A7", "D"), ("#56B4E9", "v"), ("#000000", "o")]
CYCLE_STYLES = {
    "issued": ("#009E73", ["issued"]),
    "memory": ("#D55E00", ["memory"]),
    "data": ("#56B4E9", ["data"]),
    "conflicts": ("#CC79A7", ["unit_conflict", "icache_conflict"]),
    "barrier": ("#F0E442", ["barrier"]),
    "other": ("#999999", ["branch", "sync", "sleep", "finished"]),
}
GREY = "#555555"
# Room for the names of the scenes, beside the panels.
LEGEND_INCHES = 1.75
# Of the bars of one scene, in distances between scenes.
BAR_PITCH = 0.4
BAR_WIDTH = 0.34


def load_pyplot():
    """matplotlib, set up for equal files from equal data."""
    try:
        import matplotlib
    except ImportError as error:
        raise BenchError("the charts need matplotlib: apt-get install "
                         "python3-matplotlib, and run /usr/bin/python3") \
            from error
    matplotlib.use("Agg")
    matplotlib.rcParams.update({
        "svg.hashsalt": "tp", "font.size": 10, "axes.spines.top": False,
        "axes.spines.right": False, "axes.edgecolor": GREY,
        "axes.titlesize": 11, "axes.titleweight": "bold",
        "axes.titlelocation": "left", "xtick.color": GREY,
        "ytick.color": GREY, "axes.axisbelow": True,
        "legend.frameon": False, "figure.dpi": 100})
    import matplotlib.pyplot
    return matplotlib.pyplot


def save(figure, folder, name):
    """Writes NAME.svg and NAME.png; the path of the SVG."""
    path = folder / f"{name}.svg"
    figure.savefig(path, metadata={"Date": None})
    figure.savefig(path.with_suffix(".png"), dpi=160)
    return path


def draw_all(results, folder):
    """Every chart; {path of the SVG: what it shows}."""
    pyplot = load_pyplot()
    charts = {}
    drawn = [("speed", draw_speed, "Rays per second of the slowest and the "
                                   "fastest thread and of the chip"),
             ("speed-up", draw_speed_up, "Speed-up over local store"),
             ("cycles", draw_cycles, "Where the thread-cycles go"),
             ("depth", draw_depths, "Hits and loads by depth in the tree")]
    if len(results.kernels) > 1:
        drawn.append(("kernels", draw_kernels, "Policies and formats"))
    for name, draw, title in drawn:
        figure = draw(pyplot, results)
        charts[save(figure, folder, name)] = title
        pyplot.close(figure)
    return charts


def cached_name(results):
    """Of the kernel that the charts show: the first cached one, with the
    largest local store."""
    return f"{results.kernels[0]}, {max(results.local_stores)} KiB"


def bars(results, latency):
    """[(position, color, run)]: for each scene the baseline, and right of it
    the cached kernel."""
    found = []
    for index, scene in enumerate(results.scenes):
        cached = results.find(scene, results.kernels[0],
                              max(results.local_stores), latency)
        found.append((index - BAR_PITCH / 2, BASELINE_COLOR,
                      results.baseline(scene, latency)))
        found.append((index + BAR_PITCH / 2, CACHED_COLOR, cached))
    return found


def panels(pyplot, results, width, height, **options):
    """One panel for each latency, side by side."""
    count = len(results.latencies)
    figure, grid = pyplot.subplots(
        1, count, figsize=(max(1.5, count) * width, height), squeeze=False,
        layout="constrained", **options)
    for axes, latency in zip(grid[0], results.latencies):
        axes.set_title(f"memory latency {latency} cycles")
    return figure, grid[0]


def label_scenes(axes, results):
    axes.set_xticks(range(len(results.scenes)),
                    [scene.replace("_", "\n") for scene in results.scenes])
    axes.tick_params(axis="x", length=0, labelcolor="black")


def draw_speed(pyplot, results):
    """The report's chart: a bar from the slowest to the fastest thread, as
    though all threads were like that one, on a logarithmic axis."""
    figure, grid = panels(pyplot, results, 6.2, 4.6, sharey=True)
    for axes, latency in zip(grid, results.latencies):
        for position, color, run in bars(results, latency):
            draw_range(axes, position, run, color)
        label_rates(pyplot, axes)
        label_scenes(axes, results)
        axes.grid(axis="y", which="major", color="#cccccc")
        axes.grid(axis="y", which="minor", color="#eeeeee")
    lowest, highest = speed_limits(results)
    grid[0].set_ylim(lowest / 1.3, highest * 1.8)
    grid[0].set_ylabel("rays/s")
    speed_legend(pyplot, figure, results)
    return figure


def label_rates(pyplot, axes):
    """A logarithmic axis with 1, 2 and 5 of each decade in words."""
    ticker = pyplot.matplotlib.ticker
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter(
        ticker.FuncFormatter(lambda value, _: in_units(value)))
    axes.yaxis.set_minor_formatter(ticker.NullFormatter())


def chip_speed(run, thread):
    """Rays/s of a chip whose threads are all like the "minimum" one, ..."""
    found = run["figures"]
    return found["thread_rays_per_second"][thread] * found["threads"]


def speed_limits(results):
    """Of all bars."""
    runs = [run for latency in results.latencies
            for _, _, run in bars(results, latency)]
    return (min(chip_speed(run, "minimum") for run in runs),
            max(chip_speed(run, "maximum") for run in runs))


def draw_range(axes, position, run, color):
    slowest, fastest = chip_speed(run, "minimum"), chip_speed(run, "maximum")
    axes.bar(position, fastest - slowest, bottom=slowest, width=BAR_WIDTH,
             color=color)
    mean = run["figures"]["rays_per_second"]
    half = 0.55 * BAR_WIDTH
    axes.plot([position - half, position + half], [mean, mean], color="black",
              linewidth=2, solid_capstyle="butt")
    axes.annotate(in_units(mean).replace(" ", ""), (position, fastest),
                  xytext=(0, 3), textcoords="offset points", ha="center",
                  fontsize=8, color="black")


def speed_legend(pyplot, figure, results):
    """Above the panels."""
    handles = [pyplot.Rectangle((0, 0), 1, 1, color=color)
               for color in (BASELINE_COLOR, CACHED_COLOR)]
    names = ["baseline", cached_name(results)]
    legend_above(figure, handles, names)
    figure.supxlabel("bar: from the slowest to the fastest thread, its rate x "
                     "number of threads; line and number: the whole chip",
                     fontsize=10)


def legend_above(figure, handles, labels):
    """Over the panels, which leave it room."""
    inches = 0.75 + 0.08 * max(map(len, labels))
    columns = min(len(handles), int(figure.get_figwidth() / inches))
    lines = -(-len(handles) // columns)
    room = (0.15 + 0.25 * lines) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - room))
    figure.legend(handles, labels, loc="upper left", ncol=columns)


def draw_speed_up(pyplot, results):
    """Over the size of the local store, a line for each scene."""
    figure, grid = panels(pyplot, results, 5.6, 4.2, sharey=True)
    for axes, latency in zip(grid, results.latencies):
        for index, scene in enumerate(results.scenes):
            draw_line(axes, results, scene, results.kernels[0], latency,
                      index, scene.replace("_", " "))
        label_sizes(axes, results)
    grid[0].set_ylabel("speed-up over the baseline")
    grid[0].set_ylim(0, 1.08 * max(run["speed_up"] for run in results.runs))
    width = figure.get_figwidth()
    figure.get_layout_engine().set(rect=(0, 0, 1 - LEGEND_INCHES / width, 1))
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="center right")
    figure.supxlabel(f"local store of each thread, KiB ({results.kernels[0]})",
                     fontsize=10)
    return figure


def draw_kernels(pyplot, results):
    """The policies and formats: a panel for each scene, a line for each."""
    latency = max(results.latencies)
    figure, grid = scene_panels(pyplot, results, 2.6)
    for axes, scene in zip(grid.flat, results.scenes):
        for index, kernel in enumerate(results.kernels):
            draw_line(axes, results, scene, kernel, latency, index, kernel)
        label_sizes(axes, results)
        axes.set_ylim(0, 1.08 * axes.get_ylim()[1])
    for axes in grid[:, 0]:
        axes.set_ylabel("speed-up")
    legend_above(figure, *grid[0][0].get_legend_handles_labels())
    figure.supxlabel("local store of each thread, KiB (memory latency "
                     f"{latency} cycles)", fontsize=10)
    return figure


def draw_line(axes, results, scene, kernel, latency, style, label):
    """Speed-ups over the sizes of the local store."""
    color, marker = LINE_STYLES[style % len(LINE_STYLES)]
    runs = [results.find(scene, kernel, size, latency)
            for size in results.local_stores]
    axes.plot(results.local_stores, [run["speed_up"] for run in runs],
              color=color, marker=marker, markersize=6, linewidth=1.8,
              markeredgecolor="white", label=label)


def label_sizes(axes, results):
    """Of the local store, each twice the one before; and where the baseline
    is."""
    sizes = results.local_stores
    axes.axhline(1, color="black", linewidth=1, linestyle=(0, (4, 3)))
    axes.set_xscale("log", base=2)
    axes.set_xticks(sizes, [str(size) for size in sizes])
    axes.minorticks_off()
    axes.grid(axis="y", color="#dddddd")


def draw_cycles(pyplot, results):
    """Where the time of the frame goes, beside the baseline's."""
    figure, grid = panels(pyplot, results, 6.2, 4.6, sharey=True)
    for axes, latency in zip(grid, results.latencies):
        for position, _, run in bars(results, latency):
            draw_stack(axes, position, run,
                       results.baseline(run["scene"], latency))
        label_scenes(axes, results)
        axes.yaxis.set_major_formatter(
            pyplot.matplotlib.ticker.PercentFormatter(1, decimals=0))
        axes.grid(axis="y", color="#dddddd")
    grid[0].set_ylabel("thread-cycles of the frame (baseline: 100%)")
    handles = [pyplot.Rectangle((0, 0), 1, 1, color=color)
               for color, _ in CYCLE_STYLES.values()]
    legend_above(figure, handles, list(CYCLE_STYLES))
    figure.supxlabel(f"left: baseline, right: {cached_name(results)}",
                     fontsize=10)
    return figure


def draw_stack(axes, position, run, baseline):
    """A bar as high as the run is long, cut by the reasons' shares."""
    height = run["figures"]["cycles"] / baseline["figures"]["cycles"]
    bottom = 0
    for color, names in CYCLE_STYLES.values():
        part = height * sum(run["figures"]["shares"][name] for name in names)
        axes.bar(position, part, bottom=bottom, width=BAR_WIDTH, color=color,
                 edgecolor="white", linewidth=0.5)
        bottom += part


def scene_panels(pyplot, results, height):
    """A panel for each scene, three in a line."""
    columns = min(3, len(results.scenes))
    lines = -(-len(results.scenes) // columns)
    figure, grid = pyplot.subplots(
        lines, columns, squeeze=False, sharex=True, layout="constrained",
        figsize=(max(8, 4 * columns + 0.4), height * lines + 0.8))
    for axes in grid.flat[len(results.scenes):]:
        axes.set_visible(False)
    for axes, scene in zip(grid.flat, results.scenes):
        axes.set_title(scene.replace("_", " "))
    return figure, grid


def draw_depths(pyplot, results):
    """For each scene, how deep in the tree rays find what they visit loaded, at
    the highest latency."""
    figure, grid = scene_panels(pyplot, results, 2.3)
    for axes, scene in zip(grid.flat, results.scenes):
        draw_depth(axes, results.find(
            scene, results.kernels[0], max(results.local_stores),
            max(results.latencies)))
    for axes in grid[:, 0]:
        axes.set_ylabel("visits per ray")
    legend_above(figure, *grid[0][0].get_legend_handles_labels())
    figure.supxlabel("depth in the tree, the root's is 0 "
                     f"({cached_name(results)})", fontsize=10)
    return figure


def draw_depth(axes, run):
    """Hits, and on them loads."""
    cache, rays = run["figures"]["cache"], run["figures"]["rays"]
    hits, loads = ([count / rays for count in cache[name]]
                   for name in ("hits_by_depth", "loads_by_depth"))
    depths = range(max(len(hits), len(loads)))
    hits += [0] * (len(depths) - len(hits))
    loads += [0] * (len(depths) - len(loads))
    axes.bar(depths, hits, width=0.8, color=CACHED_COLOR, label="found in a slot")
    axes.bar(depths, loads, bottom=hits, width=0.8, color=BASELINE_COLOR,
             label="loaded from memory")
    axes.grid(axis="y", color="#dddddd")
    axes.xaxis.get_major_locator().set_params(integer=True)
