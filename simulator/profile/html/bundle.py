#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Puts the parts of the report into its page.

usage: bundle.py PAGE STYLE OUTPUT SCRIPT...

What remains is @DATA@, the place of the data.
"""

import sys
from pathlib import Path


def read(path):
    return Path(path).read_text(encoding="utf-8")


def main():
    page, style, output, *scripts = sys.argv[1:]
    text = read(page)
    parts = {"STYLE": read(style), "SCRIPT": "\n".join(map(read, scripts))}
    for name, part in parts.items():
        mark = f"@{name}@"
        if text.count(mark) != 1:
            sys.exit(f"error: {page}: expected {mark} once")
        text = text.replace(mark, part)
    if text.count("@DATA@") != 1:
        sys.exit(f"error: {page}: expected @DATA@ once")
    Path(output).write_text(text, encoding="utf-8")


main()
