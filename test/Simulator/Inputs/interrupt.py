# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""interrupt.py COMMAND...: runs the command, sends it SIGINT once it has printed
a line, and ends with its status."""

import signal
import subprocess
import sys

process = subprocess.Popen(sys.argv[1:], stdout=subprocess.PIPE)
print(process.stdout.readline().decode(), end="", flush=True)
process.send_signal(signal.SIGINT)
process.communicate(timeout=60)
sys.exit(process.returncode)
