# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Judges a built program by the test command."""

import shlex
import struct
from dataclasses import dataclass, field

from tp_bisect.errors import UserError
from tp_bisect.image import ImageError, describe_difference, read_image

# The exit status that says "neither good nor bad", as for `git bisect run`.
SKIP_STATUS = 125


@dataclass
class Observation:
    """What a run of the test command showed."""

    finished: object
    files: dict = field(default_factory=dict)

    def missing_file(self):
        """A file that should be there and is not."""
        return next((n for n, data in self.files.items() if data is None), None)


class Oracle:
    """Runs the test command and says what is wrong."""

    def __init__(self, request, runner):
        self._request = request
        self._runner = runner
        self.reference = None

    @property
    def compares(self):
        """Whether good means: as the good build."""
        r = self._request
        return bool(r.compare_output or r.compare_image or r.compare_memory)

    def observe(self, build):
        """Runs the test on a build."""
        memory_file = build.folder / "memory"
        memory = ""
        if self._request.compare_memory:
            option = f"{self._request.compare_memory}={memory_file}"
            memory = f"--dump-memory {shlex.quote(option)}"
        command = build.fill(self._request.test, memory=memory)
        observation = Observation(
            self._runner.run(command, self._request.test_timeout)
        )
        for name, path in self._files(build, memory_file):
            observation.files[name] = path.read_bytes() if path.is_file() else None
        return observation

    def _files(self, build, memory_file):
        if self._request.compare_memory:
            yield self._request.compare_memory, memory_file
        for pattern in self._request.compare_image:
            matches = sorted(build.folder.glob(pattern))
            for path in matches:
                yield str(path.relative_to(build.folder)), path
            if not matches:
                yield pattern, build.folder / pattern

    def complaint(self, seen):
        """What is bad about a run; None if it is good."""
        if seen.finished.timed_out:
            return f"no end after {self._request.test_timeout} s"
        if not self.compares:
            if seen.finished.status:
                return seen.finished.describe_status() + _first_line(seen)
            return None
        expected = self.reference
        if seen.finished.status != expected.finished.status:
            return (
                f"{seen.finished.describe_status()} instead of "
                f"{expected.finished.describe_status()}" + _first_line(seen)
            )
        if self._request.compare_output:
            problem = _compare_text(expected.finished.stdout, seen.finished.stdout)
            if problem:
                return problem
        return self._compare_files(expected, seen)

    def _compare_files(self, expected, seen):
        if expected.files.keys() != seen.files.keys():
            return "other files than the good build writes: " + ", ".join(seen.files)
        for name, data in expected.files.items():
            problem = self._compare_file(data, seen.files[name])
            if problem:
                return f"{name}: {problem}"
        return None

    def _compare_file(self, expected, actual):
        if actual is None:
            return "not written"
        if expected == actual:
            return None
        try:
            images = read_image(expected), read_image(actual)
        except ImageError as error:
            raise UserError(f"--compare-image: {error}") from error
        if None not in images:
            return describe_difference(*images, self._request.tolerance)
        return _compare_bytes(expected, actual)


def _first_line(seen):
    for text in (seen.finished.stderr, seen.finished.stdout):
        for line in text.decode(errors="replace").splitlines():
            if line.strip():
                return f" ({line.strip()[:100]})"
    return ""


def _compare_text(expected, actual):
    if expected == actual:
        return None
    old = expected.decode(errors="replace").splitlines()
    new = actual.decode(errors="replace").splitlines()
    for number, (a, b) in enumerate(zip(old, new), 1):
        if a != b:
            return f"line {number} of the output: '{b[:60]}' instead of '{a[:60]}'"
    return f"{len(new)} lines of output instead of {len(old)}"


def _compare_bytes(expected, actual):
    if len(expected) != len(actual):
        return f"{len(actual)} bytes instead of {len(expected)}"
    place = next(i for i, (a, b) in enumerate(zip(expected, actual)) if a != b)
    word = place & ~3
    if word + 4 > len(expected):
        return f"byte {place} differs"
    old, new = _word_text(expected, word), _word_text(actual, word)
    return f"the word at byte {word} is {new} instead of {old}"


def _word_text(data, place):
    (bits,) = struct.unpack_from("<I", data, place)
    (value,) = struct.unpack_from("<f", data, place)
    return f"0x{bits:08x} ({value:g})"
