# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs the commands that a bench measures."""

import subprocess
import sys


def run(command, **options):
    """The finished process; ends the bench if it fails."""
    words = [str(word) for word in command]
    try:
        result = subprocess.run(words, text=True, capture_output=True,
                                check=False, **options)
    except OSError as error:
        sys.exit(f"error: {error}; build everything first (scripts/build.sh), "
                 "and install what is missing (scripts/install-packages.sh)")
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(words)}\n{result.stderr}")
    return result
