#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Declares the TP's builtins for tools that do not know them:
builtin_declarations.py TPBuiltins.def HEADER"""

import re
import sys
from pathlib import Path

_ENTRY = re.compile(r'^TP_BUILTIN\((\w+), "([^"]+)", "(\w+)", \w+\)$', re.M)
_TYPE = re.compile(r"I?(U?)([fiv])(\*?)")
_NAMES = {"f": "float", "i": "int", "v": "void"}

_FRAME = """\
/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 * The TP's builtins as functions, for clangd and clang-tidy. Generated from
 * TPBuiltins.def. */
#ifdef __cplusplus
extern "C" {{
#endif
{declarations}
#ifdef __cplusplus
}}
#endif
"""


def c_types(encoding):
    """The types of clang's encoding: the result's, then the parameters'."""
    types = []
    place = 0
    while place < len(encoding):
        match = _TYPE.match(encoding, place)
        if not match:
            sys.exit(f"error: TPBuiltins.def: unknown type '{encoding[place:]}'")
        unsigned, name, pointer = match.groups()
        types.append("unsigned " * bool(unsigned) + _NAMES[name] + pointer)
        place = match.end()
    return types


def declaration(name, encoding, attributes):
    """One builtin as a function."""
    result, *parameters = c_types(encoding)
    suffix = " __attribute__((noreturn))" if "r" in attributes else ""
    return (
        f"{result} __builtin_tp_{name}({', '.join(parameters) or 'void'}){suffix};"
    )


def main(definitions, header):
    entries = _ENTRY.findall(Path(definitions).read_text())
    declarations = "\n".join(declaration(*entry) for entry in entries)
    Path(header).write_text(_FRAME.format(declarations=declarations))


if __name__ == "__main__":
    main(*sys.argv[1:])
