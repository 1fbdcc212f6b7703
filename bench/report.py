#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reruns the report's experiment: every scene, traced by the baseline and by the
stack-cached kernel, with local stores from 2 to 32 KiB and two memory latencies.

Leaves results.json, table.md and the charts as SVG and PNG in the folder. A run
that is there already is not repeated, so an interrupted experiment goes on.
bench/report.sh installs, builds and makes the scenes before. Exit status 1 if a
picture differs from the baseline's, or anything fails."""

import argparse
import os
import pathlib
import shutil
import sys

from experiment.chart import draw_all, load_pyplot
from experiment.configurations import (FORMATS, POLICIES, Kernel,
                                       all_configurations)
from experiment.errors import BenchError
from experiment.progress import run_all
from experiment.results import (make_results, problems, read_results,
                                write_results)
from experiment.simulator import Simulator
from experiment.table import markdown, summary

ROOT = pathlib.Path(__file__).resolve().parent.parent

SCENES = ("cornell", "bunny", "maple", "engine", "conference_room", "hairball")
IN_THE_TREE = {"cornell": ROOT / "scenes/cornell/cornell.gltf"}

RESULTS = "results"


def section_marks(name):
    """The lines of a manual between which a section's text stands."""
    return [f"<!-- bench/report.py --section {name}: {end} -->"
            for end in ("begin", "end")]


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--scenes", nargs="+", choices=SCENES, default=list(SCENES),
        metavar="SCENE", help=f"of {', '.join(SCENES)} (all)")
    add("--sizes", nargs="+", type=int, default=[2, 4, 8, 16, 32],
        metavar="KIB", help="of the local store, KiB (2 4 8 16 32)")
    add("--latencies", nargs="+", type=int, default=[100, 300],
        metavar="CYCLES", help="of the memory (100 300)")
    add("--policies", nargs="+", choices=POLICIES, default=[POLICIES[0]],
        metavar="POLICY", help=f"of {', '.join(POLICIES)} ({POLICIES[0]})")
    add("--formats", nargs="+", choices=FORMATS, default=[FORMATS[0]],
        metavar="FORMAT", help=f"of {', '.join(FORMATS)} ({FORMATS[0]})")
    add("--chip", default="report-512x8", help="(report-512x8)")
    add("--size", default="256x256", help="of the picture (256x256)")
    add("--spp", type=int, default=1, help="samples per pixel (1)")
    add("--jobs", type=int, default=os.cpu_count(),
        help="runs at a time (as many as the host has cores)")
    add("--bin", type=pathlib.Path, default=ROOT / "build/bin",
        help="folder of tpcc and tpsim")
    add("--scene-folder", type=pathlib.Path, default=ROOT / "out/scenes",
        help="where scripts/scenes.sh wrote the scenes (out/scenes)")
    add("--folder", type=pathlib.Path, default=ROOT / "out/report",
        help="for all results (out/report)")
    add("--from", dest="source", type=pathlib.Path, metavar="RESULTS.json",
        help="run nothing: table and charts of an earlier experiment")
    add("--markdown", type=pathlib.Path, metavar="FILE.md",
        help="also put the table into this file, between the lines "
             f"'{section_marks(RESULTS)[0]}' and "
             f"'{section_marks(RESULTS)[1]}', and the charts into the folder "
             "images beside it")
    add("--section", default=RESULTS, metavar="NAME",
        help="another section of the file, which gets only what the cache "
             f"gains, without charts ({RESULTS})")
    arguments = parser.parse_args()
    if min(*arguments.sizes, *arguments.latencies, arguments.spp,
           arguments.jobs) < 1:
        parser.error("sizes, latencies, samples and jobs are positive")
    return arguments


def run_experiment(arguments):
    picture = ["--size", arguments.size, "--spp", str(arguments.spp),
               "--depth", "1"]
    simulator = Simulator(ROOT, arguments.bin, arguments.folder, arguments.chip,
                          picture)
    for scene in arguments.scenes:
        simulator.add_scene(scene, IN_THE_TREE.get(
            scene, arguments.scene_folder / f"{scene}.glb"))
    kernels = [Kernel(policy, slot_format) for policy in arguments.policies
               for slot_format in arguments.formats]
    for kernel in [Kernel(), *kernels]:
        simulator.compile(kernel)
    runs = run_all(simulator, all_configurations(
        arguments.scenes, kernels, sorted(set(arguments.sizes)),
        sorted(set(arguments.latencies))), arguments.jobs)
    return make_results(runs, arguments.chip, picture, arguments.jobs)


def split_section(path, name):
    """What stands before and behind a section's text."""
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    begin, end = section_marks(name)
    before, found_begin, rest = text.partition(begin)
    _, found_end, after = rest.partition(end)
    if not found_begin or not found_end:
        raise BenchError(f"{path}: no lines '{begin}' and '{end}' to put the "
                         "table between")
    return before + begin, end + after


def chart_links(path, charts):
    """Copies the charts into the manual's folder of images."""
    images = path.parent / "images"
    images.mkdir(exist_ok=True)
    links = ""
    for chart, title in charts.items():
        target = images / f"report-{chart.name}"
        shutil.copyfile(chart, target)
        links += f"**{title}**\n\n![{title}](images/{target.name})\n\n"
    return links


def fill_section(path, name, results, charts):
    """Replaces the text of a section."""
    before, after = split_section(path, name)
    text = (chart_links(path, charts) + markdown(results, is_short=True)
            if name == RESULTS else summary(results))
    path.write_text(f"{before}\n\n{text}\n{after}", encoding="utf-8")


def report(arguments):
    """Does everything; the exit status."""
    # What is missing shows before an hour of runs.
    load_pyplot()
    if arguments.markdown:
        split_section(arguments.markdown, arguments.section)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    if arguments.source:
        results = read_results(arguments.source)
    else:
        results = run_experiment(arguments)
        write_results(results, arguments.folder / "results.json")
    table = markdown(results)
    (arguments.folder / "table.md").write_text(table, encoding="utf-8")
    charts = draw_all(results, arguments.folder)
    if arguments.markdown:
        fill_section(arguments.markdown, arguments.section, results, charts)
    print(table, end="")
    wrong = problems(results)
    for problem in wrong:
        print(f"error: {problem}", file=sys.stderr)
    return 1 if wrong else 0


def main():
    arguments = parse_arguments()
    try:
        return report(arguments)
    except BenchError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("error: interrupted; the finished runs are kept, start again to "
              "go on", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
