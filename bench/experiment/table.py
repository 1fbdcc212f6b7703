# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The results as Markdown."""

from .configurations import BASELINE

# Of the thread-cycles; the reasons that are rare share one column.
CYCLE_COLUMNS = {
    "issued": ["issued"],
    "memory": ["memory"],
    "data": ["data"],
    "unit conflict": ["unit_conflict"],
    "icache": ["icache_conflict"],
    "barrier": ["barrier"],
    "finished": ["finished"],
    "other": ["branch", "sync", "sleep"],
}
NONE = "–"


def summary(results):
    """What the cache gains."""
    return "\n".join([
        *preface(results),
        "### Speed-up over the baseline", "", *speed_up_table(results),
        "### Bytes read from memory per ray", "", *traffic_table(results)])


def markdown(results, is_short=False):
    """Every part, each under its heading; Results.rows() says what is short."""
    shown = results.rows(is_short)
    return summary(results) + "\n" + "\n".join([
        "### Rays and cache", "", *ray_table(shown),
        "### Where the thread-cycles go", "", *cycle_table(shown)]) + "\n"


def preface(results):
    """What was run, in what time, and whether everything equal is equal."""
    content = results.content
    scenes = len(results.scenes)
    equal = sum(run["image_equals_baseline"] for run in results.runs)
    lines = [
        f"{len(results.runs)} runs on `{content['chip']}`, "
        f"{' '.join(content['picture'])}: {content['seconds'] / 60:.1f} minutes "
        "of one host core in all, with loading the scenes and building their "
        f"trees; {content['seconds'] / 60 / content['jobs']:.1f} minutes with "
        f"{content['jobs']} runs at a time. {equal} of the {len(results.runs)} "
        f"images of {scenes} scenes are the baseline's, byte for byte.", ""]
    return lines + proof(results)


def proof(results):
    """That the baseline's cycles do not depend on the local store."""
    pairs = [(run, results.baseline(run["scene"], run["latency"]))
             for run in results.runs if run["kernel"] == BASELINE]
    pairs = [(run, largest) for run, largest in pairs if run is not largest]
    if not pairs:
        return []
    same = sum(run["figures"]["cycles"] == largest["figures"]["cycles"]
               for run, largest in pairs)
    small, large = (run["local_store"] for run in pairs[0])
    return [f"The baseline keeps only its stack in the local store: with {small} "
            f"and with {large} KiB it takes the same number of cycles in {same} "
            f"of {len(pairs)} scenes.", ""]


def rows(header, cells):
    """A Markdown table; all columns but the first are numbers."""
    return ["| " + " | ".join(header) + " |",
            "|---" + "|--:" * (len(header) - 1) + "|",
            *("| " + " | ".join(line) + " |" for line in cells), ""]


def speed_up_table(results):
    """Scenes and stack-cached kernels down, local store and latency across."""
    columns = [(latency, size) for latency in results.latencies
               for size in results.local_stores]
    header = ["scene", "kernel", *(f"{size} KiB, {latency}"
                                   for latency, size in columns)]
    return rows(header, [
        [scene, kernel, *(speed_up(results.find(scene, kernel, size, latency))
                          for latency, size in columns)]
        for scene in results.scenes for kernel in results.kernels])


def speed_up(run):
    return NONE if run is None else f"{run['speed_up']:.2f}"


def traffic_table(results):
    """At the highest latency, on which what is read hardly depends."""
    latency, sizes = max(results.latencies), results.local_stores
    header = ["scene", "kernel", "baseline", *(f"{size} KiB" for size in sizes)]
    return rows(header, [
        [scene, kernel, traffic(results.baseline(scene, latency)),
         *(traffic(results.find(scene, kernel, size, latency))
           for size in sizes)]
        for scene in results.scenes for kernel in results.kernels])


def traffic(run):
    return NONE if run is None else f"{run['figures']['bytes_per_ray']:,.0f}"


def in_units(value):
    """1234567 as 1.23 M."""
    for factor, unit in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= 0.9995 * factor:
            return f"{value / factor:.3g} {unit}"
    return f"{value:.3g}"


def place(run):
    """The cells that tell which run a row is."""
    baseline = run["kernel"] == BASELINE
    return [run["scene"], str(run["latency"]), run["kernel"],
            "any" if baseline else f"{run['local_store']}"]


PLACE_HEADER = ["scene", "latency", "kernel", "local store, KiB"]


def ray_table(runs):
    header = [*PLACE_HEADER, "rays/s", "a thread's rays/s: slowest",
              "median", "fastest", "speed-up", "nodes per ray", "read",
              "triangles per ray", "read", "memory GB/s", "slots", "hit rate",
              "deletions per ray", "freed by each", "bypasses per ray",
              "image"]
    return rows(header, [place(run) + ray_cells(run) for run in runs])


def ray_cells(run):
    found = run["figures"]
    threads = found["thread_rays_per_second"]
    return [in_units(found["rays_per_second"]),
            *(in_units(threads[name])
              for name in ("minimum", "median", "maximum")),
            speed_up(run), f"{found['nodes_per_ray']:.1f}",
            f"{found['nodes_read_per_ray']:.2f}",
            f"{found['triangles_per_ray']:.1f}",
            f"{found['triangles_read_per_ray']:.2f}",
            f"{found['bytes_per_second'] / 1e9:,.0f}",
            *cache_cells(found["cache"]),
            "same" if run["image_equals_baseline"] else "**other**"]


def cache_cells(cache):
    if cache is None:
        return [NONE] * 5
    rate = cache["hit_rate"]
    return [str(cache["slots"]), NONE if rate is None else f"{rate:.1%}",
            f"{cache['deletions_per_ray']:.2g}",
            f"{cache['slots_freed']:.1f}" if cache["deletions"] else NONE,
            f"{cache['bypasses_per_ray']:.2g}"]


def cycle_table(runs):
    header = [*PLACE_HEADER, *CYCLE_COLUMNS, "worst unit conflict"]
    return rows(header,
                [place(run) + cycle_cells(run) for run in runs])


def cycle_cells(run):
    shares = run["figures"]["shares"]
    cells = [f"{sum(shares[name] for name in names):.1%}"
             for names in CYCLE_COLUMNS.values()]
    worst = run["figures"]["worst_unit_conflict"]
    return [*cells, NONE if worst is None
            else f"`{worst['opcode']}` {worst['share']:.2%}"]
