# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""restored_regions.py JSON TPSIM...: checks that the run restored from
checkpoints at several cycles gives the statistics of JSON."""

import filecmp
import subprocess
import sys

expected, command = sys.argv[1], sys.argv[2:]
for cycle in range(1000, 20001, 1900):
    checkpoint, restored = f"{expected}.{cycle}.save", f"{expected}.restored"
    limited = ["--checkpoint", checkpoint, "--max-cycles", str(cycle)]
    subprocess.run(command + limited, stderr=subprocess.DEVNULL)
    subprocess.run(command + ["--restore", checkpoint, "--stats", restored], check=True)
    if not filecmp.cmp(expected, restored, shallow=False):
        sys.exit(f"restored from cycle {cycle}: other statistics")
