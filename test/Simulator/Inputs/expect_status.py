# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""expect_status.py STATUS COMMAND...: fails unless the command ends with STATUS."""

import subprocess
import sys

expected = int(sys.argv[1])
status = subprocess.run(sys.argv[2:]).returncode
if status != expected:
    sys.exit(f"{sys.argv[2]} ended with status {status}, expected {expected}")
