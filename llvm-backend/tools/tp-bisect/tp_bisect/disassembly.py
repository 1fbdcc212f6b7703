# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The machine code of one function."""

import re

_TIMEOUT = 60
_HEADING = re.compile(r"^(?:[0-9a-f]+ )?<(.+)>:$")
_ADDRESS = re.compile(r"^\s*[0-9a-f]+:\s*(?:[0-9a-f]{8}\s+)?")
_TARGET = re.compile(r"\b0x[0-9a-f]+ (<.*>)")


def disassemble(runner, words, program, function):
    """The instructions of a function without addresses; empty if the program
    does not have it."""
    finished = runner.run([*words, str(program)], _TIMEOUT)
    lines, is_inside = [], False
    for line in finished.stdout.decode(errors="replace").splitlines():
        heading = _HEADING.match(line)
        if heading:
            is_inside = heading[1] == function
        elif is_inside and line.strip():
            lines.append(_TARGET.sub(r"\1", _ADDRESS.sub("", line)).strip())
    return lines
