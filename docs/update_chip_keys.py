#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Puts the table of keys that `tpsim --print-chip-schema` prints into
docs/chip-files.md: update_chip_keys.py < table."""

import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).parent / "chip-files.md"

table = sys.stdin.read()
text = re.sub(r"(<!-- keys -->\n).*?(<!-- end of keys -->)",
              lambda found: found[1] + table + found[2], PAGE.read_text(),
              flags=re.DOTALL)
PAGE.write_text(text)
