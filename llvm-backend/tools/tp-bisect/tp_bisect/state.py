# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What is known of configurations, kept in a file so that a search that was
stopped goes on where it was."""

import json
import os
import threading
from pathlib import Path

_VERSION = 1


class State:
    """Verdicts by the key of their configuration.

    They count for one fingerprint: the request and the programs that the good
    and the bad flags give, so that any change to a source or to the compiler
    starts afresh.
    """

    def __init__(self, path):
        self._path = Path(path)
        self._lock = threading.Lock()
        self._fingerprint = None
        self._verdicts = {}

    def open(self, fingerprint):
        """Takes over what the file knows for this fingerprint; says whether
        there was anything."""
        self._fingerprint = fingerprint
        try:
            stored = json.loads(self._path.read_text())
            is_mine = (
                stored["version"] == _VERSION
                and stored["fingerprint"] == fingerprint
            )
            self._verdicts = dict(stored["verdicts"]) if is_mine else {}
        except (OSError, ValueError, KeyError, TypeError):
            self._verdicts = {}
        return bool(self._verdicts)

    def get(self, key):
        """The verdict as it was stored; None if there is none."""
        with self._lock:
            return self._verdicts.get(key)

    def put(self, key, verdict):
        """Stores a verdict at once."""
        with self._lock:
            self._verdicts[key] = verdict
            content = {
                "version": _VERSION,
                "fingerprint": self._fingerprint,
                "verdicts": self._verdicts,
            }
            fresh = self._path.with_suffix(".new")
            fresh.write_text(json.dumps(content))
            os.replace(fresh, self._path)
