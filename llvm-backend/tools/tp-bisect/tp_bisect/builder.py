# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs the build command for a configuration."""

import hashlib
import json
import shlex
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

from tp_bisect.compiler import llvm_words
from tp_bisect.processes import Finished


@dataclass
class Build:
    """What a build has left: its folder and how its command ended."""

    folder: Path
    finished: Finished

    @property
    def output(self):
        """The program, where the command names `{out}`."""
        return self.folder / "program"

    def output_hash(self):
        """The hash of the program; None if there is no such file."""
        if not self.output.is_file():
            return None
        return hashlib.sha256(self.output.read_bytes()).hexdigest()

    def fill(self, template, **more):
        """Replaces the placeholders of a command."""
        values = {
            "out": shlex.quote(str(self.output)),
            "dir": shlex.quote(str(self.folder)),
            **more,
        }
        for name, value in values.items():
            template = template.replace("{" + name + "}", value)
        return template

    def discard(self):
        """Removes what the build has left."""
        shutil.rmtree(self.folder, ignore_errors=True)


class Builder:
    """Builds configurations, each in a folder of its own."""

    def __init__(self, request, compiler, runner):
        self._request = request
        self._compiler = compiler
        self._runner = runner
        self._folder = Path(request.work_folder) / "builds"
        self._folder.mkdir(parents=True, exist_ok=True)

    def build(self, configuration):
        """Builds; a failed build is no error here."""
        folder = Path(tempfile.mkdtemp(dir=self._folder)).resolve()
        flags = shlex.join(self._flags(configuration, folder))
        built = Build(folder, None)
        command = built.fill(self._request.build, flags=flags)
        variable = self._request.flags_variable
        built.finished = self._runner.run(
            command,
            self._request.build_timeout,
            {variable: flags} if variable else None,
        )
        return built

    def command_line(self, configuration, folder):
        """The command that builds it with files in `folder`, for a person."""
        flags = shlex.join(self._flags(configuration, folder))
        command = self._request.build.replace("{flags}", flags)
        if self._request.flags_variable:
            command = f"{self._request.flags_variable}={shlex.quote(flags)} {command}"
        return command

    def _flags(self, configuration, folder):
        flags = list(configuration.flags)
        options = list(configuration.options)
        if configuration.scope is not None:
            scope_file = folder / "scope.txt"
            scope_file.write_text("".join(e.line() for e in configuration.scope))
            options.append(f"-tp-fp-scope={scope_file}")
        if configuration.last_pass is not None:
            options.append(f"-opt-bisect-limit={configuration.last_pass}")
        scope = [o for o in options if o.startswith("-tp-fp-scope")]
        if scope:
            flags += self._compiler.scope_words(flags, scope)
        flags += llvm_words([o for o in options if o not in scope])
        if configuration.replacements:
            flags += ["-ivfsoverlay", str(_write_overlay(configuration, folder))]
        return flags


def _write_overlay(configuration, folder):
    """A file that lets the compiler see copies in the place of files."""
    path = folder / "overlay.yaml"
    roots = [
        {
            "name": str(Path(original).parent),
            "type": "directory",
            "contents": [
                {
                    "name": Path(original).name,
                    "type": "file",
                    "external-contents": str(copy),
                }
            ],
        }
        for original, copy in configuration.replacements
    ]
    path.write_text(
        json.dumps({"version": 0, "use-external-names": False, "roots": roots})
    )
    return path
