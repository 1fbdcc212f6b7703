# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""expect_status.py STATUS COMMAND...: succeeds if COMMAND ends with STATUS."""

import subprocess
import sys

status = subprocess.run(sys.argv[2:], check=False).returncode
if status != int(sys.argv[1]):
    sys.exit(f"expected status {sys.argv[1]}, got {status}")
