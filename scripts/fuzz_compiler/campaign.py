# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares programs in parallel, counts, and remembers what was done."""

import concurrent.futures
import os
import sys
import tempfile
import threading
import time

from programs import compare, keep
from reduction import reduce


class Campaign:
    """The log in the directory has a line for each program; a campaign that
    is started again with it goes on after them."""

    def __init__(self, tools, options):
        self.tools = tools
        self.options = options
        self.counts = {}
        self.failures = {}
        self.done = set()
        self.reduced = 0
        self.lock = threading.Lock()
        self.start = time.monotonic()
        os.makedirs(options.keep, exist_ok=True)
        self.log_path = os.path.join(options.keep, "log")
        if options.resume and os.path.exists(self.log_path):
            self.read_log()
        elif os.path.exists(self.log_path):
            os.remove(self.log_path)

    def read_log(self):
        with open(self.log_path, encoding="utf-8") as file:
            for line in file:
                kind, seed, result, note = line.rstrip("\n").split("\t")
                self.count(kind, int(seed), result, note)

    def count(self, kind, seed, result, note):
        self.done.add((kind, seed))
        key = (kind, result)
        self.counts[key] = self.counts.get(key, 0) + 1
        if result == "failed":
            for failure in note.split("; "):
                name = failure.split(" at ")[0]
                self.failures[name] = self.failures.get(name, 0) + 1

    def compared(self, kind):
        return (self.counts.get((kind, "passed"), 0)
                + self.counts.get((kind, "failed"), 0))

    def run(self, kind, wanted):
        """Seeds in turn until so many programs were compared."""
        seed = self.options.first
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            pending = set()
            while self.compared(kind) < wanted or pending:
                room = min(wanted - self.compared(kind),
                           2 * self.options.jobs) - len(pending)
                for _ in range(room):
                    while (kind, seed) in self.done:
                        seed += 1
                    pending.add(pool.submit(self.one, kind, seed))
                    seed += 1
                finished, pending = concurrent.futures.wait(
                    pending,
                    return_when=concurrent.futures.FIRST_COMPLETED)
                for future in finished:
                    future.result()
                self.report_progress(kind, wanted, len(finished))

    def one(self, kind, seed):
        options = self.options
        with tempfile.TemporaryDirectory() as directory:
            outcome = compare(self.tools, kind, seed, options.levels,
                              options.modes, directory)
            if outcome.failures:
                self.keep(outcome, directory)
        with self.lock:
            self.count(kind, seed, outcome.result, outcome.note)
            note = " ".join(outcome.note.split())[:300]
            with open(self.log_path, "a", encoding="utf-8") as file:
                file.write(f"{kind}\t{seed}\t{outcome.result}\t{note}\n")

    def keep(self, outcome, directory):
        kept = os.path.join(self.options.keep,
                            f"{outcome.kind}-{outcome.seed}")
        source = next(
            os.path.join(directory, name) for name in os.listdir(directory)
            if name in ("program.c", "program.cpp"))
        source = keep(self.tools, outcome, source, kept)
        print(f"FAILED: {outcome.kind} seed {outcome.seed}: {outcome.note}, "
              f"kept in {kept}", flush=True)
        with self.lock:
            self.reduced += 1
            if self.reduced > self.options.reduce:
                return
        reduced = reduce(self.tools, outcome.failures[0], source, kept,
                         self.options.reduction_seconds)
        print(f"seed {outcome.seed}, reduced: {reduced}", flush=True)

    def report_progress(self, kind, wanted, finished):
        compared = self.compared(kind)
        if finished and (compared % 50 == 0 or compared >= wanted):
            seconds = time.monotonic() - self.start
            failed = self.counts.get((kind, "failed"), 0)
            print(f"{kind}: {compared}/{wanted} compared, {failed} failed, "
                  f"{seconds:.0f} s", file=sys.stderr, flush=True)

    def report(self, kinds):
        """Prints the figures; whether nothing failed."""
        passed = failed = 0
        for kind in kinds:
            values = [self.counts.get((kind, result), 0)
                      for result in ("passed", "failed", "unusable")]
            print(f"{kind}: {values[0]} passed, {values[1]} failed, "
                  f"{values[2]} not comparable")
            passed += values[0]
            failed += values[1]
        for name, number in sorted(self.failures.items()):
            print(f"  {name}: {number}")
        print(f"{passed} passed, {failed} failed; levels "
              f"{' '.join(self.options.levels)}, modes "
              f"{' '.join(self.options.modes)}")
        return failed == 0
