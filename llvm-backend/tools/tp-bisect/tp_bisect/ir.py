# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reads LLVM IR as the compiler prints it, to show what a pass changed."""

import difflib
import os
import re
from dataclasses import dataclass, field

_HEADER = re.compile(
    r"^; \*\*\* IR Dump (Before|After) (\d+)-(\S+) on (.*?)"
    r"( \(invalidated\)| invalidated:)? \*\*\*",
    re.M,
)
_DEFINE = re.compile(r'^define .*?@("(?:[^"\\]|\\.)*"|[\w.$-]+)\(')
_NODE = re.compile(r"^(!\d+) = (?:distinct )?!(.*)$")
_DEBUG = re.compile(r", !dbg (!\d+)")
_OTHER_METADATA = re.compile(r", ![a-zA-Z_.]+ !\d+")
_UNNAMED = re.compile(r"%\d+\b")
_FIELD = r"\b%s: (?:\"([^\"]*)\"|(![0-9]+|\w+))"
_MOST_INLINED = 8


@dataclass
class Module:
    """The functions of a module, each a list of lines, and its metadata."""

    source: str = ""
    functions: dict = field(default_factory=dict)
    nodes: dict = field(default_factory=dict)

    @staticmethod
    def parse(text):
        """Reads a printed module."""
        module = Module()
        body = None
        for line in text.splitlines():
            if body is not None:
                if line == "}":
                    body = None
                else:
                    body.append(line)
            elif match := _DEFINE.match(line):
                body = module.functions.setdefault(match[1].strip('"'), [])
            elif match := _NODE.match(line):
                module.nodes[match[1]] = match[2]
            elif line.startswith("source_filename = "):
                module.source = line.split('"')[1]
        return module

    def lines(self, function):
        """A function's lines with source places in the stead of metadata."""
        return [self._readable(line) for line in self.functions.get(function, [])]

    def _readable(self, line):
        match = _DEBUG.search(line)
        line = _OTHER_METADATA.sub("", line).rstrip()
        if not match:
            return line
        chain = self.places(match[1])
        return f"{line}  ; {' <- '.join(chain)}" if chain else line

    def places(self, node):
        """`file:line:column` of a debug location, then where it is inlined."""
        chain = []
        while node in self.nodes and len(chain) < _MOST_INLINED:
            text = self.nodes[node]
            line = _field(text, "line") or "0"
            if line != "0":
                column = _field(text, "column") or "0"
                chain.append(f"{self._file(_field(text, 'scope'))}:{line}:{column}")
            node = _field(text, "inlinedAt")
        return chain

    def _file(self, scope):
        while scope in self.nodes:
            text = self.nodes[scope]
            node = _field(text, "file")
            if node in self.nodes:
                return os.path.basename(_field(self.nodes[node], "filename") or "?")
            scope = _field(text, "scope")
        return "?"


def _field(text, name):
    match = re.search(_FIELD % name, text)
    return (match[1] if match[1] is not None else match[2]) if match else None


@dataclass
class Dump:
    """A module before and after a pass."""

    number: int
    pass_name: str
    unit: str
    before: Module
    after: Module = None


def read_dumps(text):
    """The pairs of dumps in what a compiler printed; without an `after` where
    the pass has removed what it ran on."""
    headers = list(_HEADER.finditer(text))
    pending, dumps = {}, []
    for place, header in enumerate(headers):
        when, number, name, unit, invalidated = header.groups()
        end = headers[place + 1].start() if place + 1 < len(headers) else len(text)
        key = (number, name)
        if when == "Before":
            body = Module.parse(text[header.end() : end])
            pending[key] = Dump(int(number), name, unit, body)
            dumps.append(pending[key])
        elif key in pending and not invalidated:
            pending.pop(key).after = Module.parse(text[header.end() : end])
    return dumps


@dataclass(frozen=True)
class Change:
    """What became of a function."""

    function: str
    diff: tuple


def changes(dump, context, most_lines):
    """The functions that differ, as trimmed diffs."""
    if dump.after is None:
        return []
    found = []
    for function in {**dump.before.functions, **dump.after.functions}:
        old, new = dump.before.lines(function), dump.after.lines(function)
        diff = trimmed_diff(old, new, context, most_lines)
        if diff:
            found.append(Change(function, diff))
    return found


def trimmed_diff(old, new, context, most_lines):
    """A unified diff without heading, of at most so many lines. The numbers of
    unnamed values make no difference."""
    keys = [[_UNNAMED.sub("%", line) for line in lines] for lines in (old, new)]
    matcher = difflib.SequenceMatcher(None, *keys, autojunk=False)
    lines = []
    for group in matcher.get_grouped_opcodes(context):
        if lines:
            lines.append("...")
        for kind, a0, a1, b0, b1 in group:
            if kind == "equal":
                lines += [" " + line for line in old[a0:a1]]
            else:
                lines += ["-" + line for line in old[a0:a1]]
                lines += ["+" + line for line in new[b0:b1]]
    if len(lines) > most_lines:
        left = len(lines) - most_lines
        lines = lines[:most_lines] + [f"... {left} more lines"]
    return tuple(lines)
