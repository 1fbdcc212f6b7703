# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Puts the parts together."""

import shutil
import signal
import sys
from pathlib import Path

from tp_bisect import report
from tp_bisect.builder import Builder
from tp_bisect.command_line import parse
from tp_bisect.compiler import Compiler, find_compiler
from tp_bisect.errors import NothingToFind, UserError
from tp_bisect.evaluator import Evaluator
from tp_bisect.oracle import Oracle
from tp_bisect.processes import ProcessRunner
from tp_bisect.progress import Progress
from tp_bisect.search import Search
from tp_bisect.state import State

_FOUND, _ERROR, _NOTHING, _INTERRUPTED = 0, 1, 2, 130


def _stop(*_):
    raise KeyboardInterrupt


def main(arguments, tool_folder):
    """Runs tp-bisect; gives its exit status."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _stop)
    try:
        return _run(parse(arguments), tool_folder)
    except UserError as error:
        _print_error(error)
        return _ERROR
    except OSError as error:
        _print_error(error)
        return _ERROR
    except NothingToFind as reason:
        print(f"tp-bisect: {reason}", file=sys.stderr)
        return _NOTHING
    except KeyboardInterrupt:
        print(
            "tp-bisect: stopped; the same command goes on from here",
            file=sys.stderr,
        )
        return _INTERRUPTED


def _print_error(error):
    print(f"tp-bisect: error: {error}", file=sys.stderr)


def _run(request, tool_folder):
    runner = ProcessRunner()
    progress = Progress(request.quiet)
    compiler = Compiler(
        find_compiler(request.build, request.compiler), runner, tool_folder
    )
    request.work_folder.mkdir(parents=True, exist_ok=True)
    builder = Builder(request, compiler, runner)
    evaluator = Evaluator(
        request,
        builder,
        Oracle(request, runner),
        State(request.work_folder / "state.json"),
        progress,
    )
    search = Search(request, compiler, evaluator, builder, runner, progress)
    try:
        found = search.run()
    finally:
        runner.stop()
        evaluator.close()
        progress.clear()
        for folder in ("builds", "mended"):
            shutil.rmtree(request.work_folder / folder, ignore_errors=True)
    _write(found, request, progress)
    return _FOUND


def _write(found, request, progress):
    text = report.to_text(found, request, progress)
    print(text, end="")
    if request.report:
        Path(request.report).write_text(text)
    if request.json:
        Path(request.json).write_text(report.to_json(found, request, progress))
