# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Shell commands with a time limit, all of which end when the search ends."""

import os
import signal
import subprocess
import threading
from dataclasses import dataclass


@dataclass(frozen=True)
class Finished:
    """How a command ended."""

    status: int
    stdout: bytes
    stderr: bytes
    timed_out: bool = False

    def describe_status(self):
        """The end in words."""
        if self.timed_out:
            return "timed out"
        if self.status < 0:
            return f"killed by {signal.Signals(-self.status).name}"
        # What a shell makes of its command's signal.
        if self.status > 128 and self.status - 128 in set(signal.Signals):
            return f"killed by {signal.Signals(self.status - 128).name}"
        return f"exit status {self.status}"


class ProcessRunner:
    """Runs commands from several threads."""

    def __init__(self):
        self._lock = threading.Lock()
        self._running = set()
        self._stopped = False

    def run(self, command, timeout, environment=None):
        """Runs a command line of the shell, or a list of words without one."""
        with self._lock:
            if self._stopped:
                raise KeyboardInterrupt
            process = subprocess.Popen(
                command,
                shell=isinstance(command, str),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env={**os.environ, **(environment or {})},
                start_new_session=True,
            )
            self._running.add(process)
        try:
            return self._wait(process, timeout)
        finally:
            with self._lock:
                self._running.discard(process)

    def _wait(self, process, timeout):
        try:
            stdout, stderr = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            _kill(process)
            stdout, stderr = process.communicate()
            return Finished(process.returncode, stdout, stderr, timed_out=True)
        if self._stopped:
            raise KeyboardInterrupt
        return Finished(process.returncode, stdout, stderr)

    def stop(self):
        """Ends what runs; nothing starts any more."""
        with self._lock:
            self._stopped = True
            for process in self._running:
                _kill(process)


def _kill(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
