# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""interrupt.py COMMAND...: sends SIGINT once the command has judged something,
and expects it to end with status 130 at once."""

import os
import signal
import subprocess
import sys
import time

STATE = "tp-bisect.out/state.json"
process = subprocess.Popen(sys.argv[1:])
deadline = time.monotonic() + 60
while not os.path.exists(STATE) and process.poll() is None:
    if time.monotonic() > deadline:
        process.kill()
        sys.exit("nothing was judged in a minute")
    time.sleep(0.02)
process.send_signal(signal.SIGINT)
status = process.wait(timeout=30)
if status != 130:
    sys.exit(f"ended with status {status}, expected 130")
