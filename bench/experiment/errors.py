# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What ends the bench with a message instead of a traceback."""


class BenchError(Exception):
    """Its text names what failed and the cure."""
