# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The progress line on standard error."""

import resource
import sys
import threading
import time

_WIDTH = 78


def _processor_seconds():
    """What builds and tests that have ended took."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Progress:
    """Says what is searched: on a terminal in one line that changes, elsewhere
    in one line for each part of the search."""

    def __init__(self, quiet, stream=sys.stderr):
        self._quiet = quiet
        self._stream = stream
        self._is_terminal = stream.isatty()
        self._lock = threading.Lock()
        self._begin = time.monotonic()
        self._phase = ""
        self._detail = ""
        self.builds = 0
        self.tests = 0
        self.reused = 0

    def seconds(self):
        """Since the search began."""
        return time.monotonic() - self._begin

    def phase(self, text):
        """Begins a part of the search."""
        with self._lock:
            self._phase, self._detail = text, ""
            if not self._quiet and not self._is_terminal:
                print(f"tp-bisect: {text}", file=self._stream, flush=True)
            self._show()

    def detail(self, text):
        """Says how far the part is."""
        with self._lock:
            self._detail = text
            self._show()

    def count(self, builds=0, tests=0, reused=0):
        """Counts what was done."""
        with self._lock:
            self.builds += builds
            self.tests += tests
            self.reused += reused
            self._show()

    def summary(self):
        """What was done, in words."""
        reused = f", {self.reused} known from before" if self.reused else ""
        return (
            f"{self.builds} builds, {self.tests} tests{reused}, "
            f"{self.seconds():.1f} s, {_processor_seconds():.1f} s of processors"
        )

    def _show(self):
        if self._quiet or not self._is_terminal:
            return
        detail = f": {self._detail}" if self._detail else ""
        done = f"{self.builds} builds, {self.seconds():.0f} s"
        line = f"tp-bisect: {self._phase}{detail} ({done})"
        self._stream.write("\r" + line[:_WIDTH].ljust(_WIDTH))
        self._stream.flush()

    def clear(self):
        """Removes the line from the terminal."""
        if self._is_terminal and not self._quiet:
            self._stream.write("\r" + " " * _WIDTH + "\r")
            self._stream.flush()
