#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Checks the table of docs/language.md: each row has a known status and tests
that exist; each test of this folder is in it."""

import pathlib
import re
import sys

STATUSES = {"works", "refused"}
TEST_SUFFIXES = {".c", ".cpp", ".test"}
# The test that runs this script.
UNLISTED = {"table.test"}


def rows(text):
    """The cells of the rows of the table of features."""
    table = text.split("| Feature | Status | Test |\n|---|---|---|\n")[1]
    for line in table.splitlines():
        if not line.startswith("|"):
            return
        yield [cell.strip() for cell in line.strip("|").split("|")]


def check(document):
    folder = document.parent
    listed = set()
    for feature, status, tests in rows(document.read_text()):
        if status not in STATUSES:
            yield f"{feature}: unknown status '{status}'"
        paths = re.findall(r"\]\(([^)]*)\)", tests)
        if not paths:
            yield f"{feature}: no test"
        for path in paths:
            listed.add((folder / path).resolve())
            if not (folder / path).is_file():
                yield f"{feature}: {path} does not exist"
    for test in sorted((folder / "../test/Language").resolve().iterdir()):
        if test.suffix in TEST_SUFFIXES and test not in listed:
            if test.name not in UNLISTED:
                yield f"{test.name} is not in the table"


def main():
    document = pathlib.Path(sys.argv[1])
    problems = list(check(document))
    for problem in problems:
        print(f"{document}: error: {problem}", file=sys.stderr)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
