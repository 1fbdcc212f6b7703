# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""One way to build the program."""

import hashlib
import json
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class ScopeEntry:
    """Items that keep fast math: a line of a scope file."""

    source: str = "*"
    function: str = "*"
    items: tuple = ()

    def line(self):
        """The line; without items it means all of them."""
        items = ",".join(map(str, self.items)) or "*"
        return f"{self.source}\t{self.function}\t{items}\n"


@dataclass(frozen=True)
class Configuration:
    """Flags; what keeps fast math (None: there is no scope); the last
    optional pass (None: all run); further options for LLVM; a file in the
    place of another, as pairs."""

    flags: tuple
    scope: tuple = None
    last_pass: int = None
    options: tuple = ()
    replacements: tuple = ()

    def key(self):
        """What names it in the state file."""
        parts = (
            self.flags,
            None if self.scope is None else [e.line() for e in self.scope],
            self.last_pass,
            self.options,
            self.replacements,
        )
        return hashlib.sha256(json.dumps(parts).encode()).hexdigest()

    def with_scope(self, entries):
        """The same with another scope."""
        return replace(self, scope=tuple(entries))

    def with_last_pass(self, number):
        """The same that ends with another pass."""
        return replace(self, last_pass=number)

    def with_options(self, *options):
        """The same with further options for LLVM."""
        return replace(self, options=self.options + options)
