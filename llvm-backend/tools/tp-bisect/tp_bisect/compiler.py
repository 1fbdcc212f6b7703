# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The compiler that the build command runs: what it makes of flags, and what
gives it a scope or a limit of passes."""

import os
import shlex
import shutil
import tempfile
from pathlib import Path

from tp_bisect.errors import UserError
from tp_bisect.flags import is_setting_word, read_settings

_QUERY_TIMEOUT = 60
_PLUGIN = "TPFloatingPoint.so"


def find_compiler(build_command, given):
    """The compiler of the user's words, or the one in the build command."""
    candidates = [given] if given else _command_words(build_command)
    for word in candidates:
        name = os.path.basename(word)
        if given or name.startswith(("clang", "tpcc")):
            path = shutil.which(word)
            if path:
                return path
    if given:
        raise UserError(f"--compiler: there is no program '{given}'")
    raise UserError(
        "the build command names neither tpcc nor clang; say with --compiler "
        "which of them it runs"
    )


def _command_words(command):
    lexer = shlex.shlex(command, posix=True, punctuation_chars=True)
    lexer.whitespace_split = True
    try:
        return list(lexer)
    except ValueError as error:
        raise UserError(f"--build: {error}") from error


class Compiler:
    """Asks the compiler's driver, and words what the search wants of it."""

    def __init__(self, path, runner, tool_folder):
        self.path = path
        self._runner = runner
        self._settings = {}
        self.is_tpcc = b"tpcc" in self._ask(["--version"]).stdout
        self._plugin = Path(tool_folder).parent / "lib" / _PLUGIN

    def _ask(self, words):
        return self._runner.run([self.path, *words], _QUERY_TIMEOUT)

    def settings(self, flags):
        """The settings that the driver makes of flags."""
        key = tuple(flags)
        if key not in self._settings:
            self._settings[key] = read_settings(self._jobs(flags))
        return self._settings[key]

    def _jobs(self, flags):
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "empty.cpp")
            Path(source).touch()
            answer = self._ask([*flags, "-###", source, "-o", source + ".out"])
        text = answer.stderr.decode(errors="replace")
        jobs = [line for line in text.splitlines() if line.startswith(' "')]
        if answer.status or not jobs:
            errors = [x for x in text.splitlines() if "error:" in x] or [text]
            raise UserError(
                f"{self.path} does not accept '{shlex.join(flags)}':\n  "
                + "\n  ".join(errors)
            )
        return [word for job in jobs for word in shlex.split(job)]

    def origin(self, flags, setting, value):
        """The flag that gave the setting its value; empty: the default did."""
        origin = ""
        before = self.settings([])[setting]
        for place, word in enumerate(flags):
            if not is_setting_word(word):
                continue
            now = self.settings(flags[: place + 1])[setting]
            if now == value and now != before:
                origin = word
            before = now
        return origin

    def overridden_word(self, flags, origin, setting, value):
        """A flag before `origin` that would give the setting another value if
        it stood last; empty if there is none."""
        for place, word in enumerate(flags[: _last(flags, origin)]):
            if not is_setting_word(word) or word.startswith("-O"):
                continue
            moved = flags[:place] + flags[place + 1 :] + [word]
            if self.settings(moved)[setting] != value:
                return word
        return ""

    def scope_problem(self):
        """Why parts of the program cannot be made strict; None if they can."""
        if self.is_tpcc or self._plugin.exists():
            return None
        return f"the plug-in {self._plugin} is missing; build TPFloatingPoint"

    def scope_words(self, flags, options):
        """Flags that give the scope pass its options."""
        words = []
        if not self.is_tpcc and not any(_PLUGIN in word for word in flags):
            words += [f"-fplugin={self._plugin}", f"-fpass-plugin={self._plugin}"]
            options = ["-tp-fp-canonicalize=0", *options]
        return words + llvm_words(options)

    def disassembler(self):
        """The words of the program that disassembles what is built."""
        if self.is_tpcc:
            beside = Path(self.path).resolve().parent / "tp-objdump"
            return [str(beside), "-d"] if beside.exists() else None
        for name in ("llvm-objdump-22", "llvm-objdump"):
            if shutil.which(name):
                return [name, "-d", "--no-show-raw-insn", "--no-leading-addr"]
        return None


def _last(flags, word):
    """The place of its last occurrence; 0 if there is none."""
    return len(flags) - 1 - flags[::-1].index(word) if word in flags else 0


def llvm_words(options):
    """Flags that hand options to LLVM."""
    return [word for option in options for word in ("-mllvm", option)]
