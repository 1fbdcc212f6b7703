# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""csmith's programs."""

import random
import subprocess

# Each is chosen for some of the programs.
VARIATIONS = (
    (0.2, "--no-unions"),
    (0.2, "--no-volatiles"),
    (0.3, "--no-jumps"),
    (0.3, "--inline-function"),
    (0.1, "--no-inline-function"),
    (0.2, "--no-longlong"),
    (0.1, "--no-bitfields"),
    (0.1, "--no-const-pointers"),
    (0.3, "--addr-taken-of-locals"),
    (0.1, "--random-random"),
)


def options(seed):
    """csmith's command line for a seed."""
    generator = random.Random(seed)
    words = ["--seed", str(seed), "--concise",
             "--no-hash-value-printf"]
    words += ["--max-funcs", str(generator.randint(2, 7))]
    words += ["--max-block-depth", str(generator.randint(2, 4))]
    words += ["--max-expr-complexity", str(generator.randint(4, 10))]
    words += ["--max-array-dim", str(generator.randint(1, 3))]
    # A pointer to a packed field would be to a misaligned object, which is
    # undefined.
    words += ["--no-packed-struct" if generator.random() < 0.6
              else "--no-pointers"]
    return words + [
        word for chance, word in VARIATIONS if generator.random() < chance
    ]


def program(seed, directory):
    """The program's text. csmith leaves a file in the directory."""
    return subprocess.run(
        ["csmith", *options(seed)], cwd=directory, capture_output=True,
        text=True, check=True, timeout=4,
    ).stdout
