# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles and runs a program on the simulated TP or natively."""

import dataclasses
import os
import subprocess

LEVELS = ("-O0", "-O1", "-O2", "-O3", "-Os")

# What -ftp-fp=reproducible stands for, where clang's own driver is used.
REPRODUCIBLE = (
    "-fassociative-math", "-freciprocal-math", "-fapprox-func",
    "-fno-signed-zeros", "-fno-trapping-math", "-ffp-contract=off",
)
FLAG_SETS = {
    "fast-infinities": ("-ffast-math", "-fno-finite-math-only"),
    "fast": ("-ffast-math",),
    "reproducible": ("-ftp-fp=reproducible",),
    "strict": ("-ftp-fp=strict",),
}
NATIVE_FLAGS = {
    "-ftp-fp=reproducible": REPRODUCIBLE,
    "-ftp-fp=strict": ("-ffp-contract=off",),
}
# Under these flags infinities and NaN have no meaning.
FINITE_ONLY = ("fast",)
# Under these flags a product and a sum may be fused.
CONTRACTED = ("fast-infinities", "fast")

TARGETS = ("tp", "tp-fma", "native", "native-fma")
# tpcc's defaults that matter here, for clang.
NATIVE_DEFAULTS = (
    "-ffp-contract=off", "-fno-math-errno", "-fno-strict-float-cast-overflow",
    # No start-up code that makes the processor flush subnormal numbers.
    "-mno-daz-ftz",
)


class Failure(Exception):
    """A compilation or run that went wrong."""


@dataclasses.dataclass(frozen=True)
class Configuration:
    """One way to compile and run a program."""

    target: str
    flags: str
    level: str

    @property
    def has_fma(self):
        return self.target.endswith("-fma")

    @property
    def is_native(self):
        return self.target.startswith("native")

    def contracts(self, function):
        """Whether its expressions are fused; the TP's doubles are software."""
        return (
            self.has_fma
            and (self.flags in CONTRACTED or function.asks_for_contraction())
            and (self.is_native or function.type == "float")
        )

    def __str__(self):
        return f"{self.target} {self.level} {self.flags}"


class Tools:
    """Where the tools are, and whether they canonicalize."""

    def __init__(self, directory, canonicalize):
        self.directory = directory
        self.canonicalize = canonicalize
        self.include = os.path.dirname(os.path.abspath(__file__))

    def tool(self, name):
        return os.path.join(self.directory, name)

    def plugin(self):
        return os.path.join(self.directory, "..", "lib", "TPFloatingPoint.so")

    def compile_command(self, configuration, source, output):
        command = ["-std=c++20", "-w", configuration.level, "-I", self.include]
        flags = FLAG_SETS[configuration.flags]
        if configuration.is_native:
            compiler = "clang++-22"
            command += NATIVE_DEFAULTS
            for flag in flags:
                command += NATIVE_FLAGS.get(flag, (flag,))
            if configuration.has_fma:
                command.append("-mfma")
            if self.canonicalize:
                command.append(f"-fpass-plugin={self.plugin()}")
        else:
            compiler = self.tool("tpcc")
            command += flags
            if configuration.has_fma:
                command.append("-mfma")
            if not self.canonicalize:
                command += ["-mllvm", "-tp-fp-canonicalize=0"]
        return [compiler, *command, source, "-o", output]

    def run_command(self, configuration, program):
        if configuration.is_native:
            return [program]
        return [self.tool("tpsim"), "--chip", "1x1", "--quiet",
                "--host-threads", "1", program]

    def run(self, configuration, source):
        """The program's output."""
        name = str(configuration).replace(" ", "_")
        program = os.path.join(os.path.dirname(source), f"{name}.out")
        execute(self.compile_command(configuration, source, program))
        output = execute(self.run_command(configuration, program))
        os.unlink(program)
        return output

    def run_check(self, source):
        """The output of a program that uses checked.h."""
        program = f"{source}.out"
        execute([
            "clang++-22", "-std=c++20", "-w", "-O1", *NATIVE_DEFAULTS,
            "-I", self.include, source, "-o", program,
        ])
        return execute([program])


def execute(command):
    """The standard output of a command that should succeed."""
    try:
        result = subprocess.run(
            command, capture_output=True, text=True, timeout=600, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise Failure(f"{' '.join(command)}\ntakes too long") from error
    if result.returncode != 0:
        raise Failure(
            f"{' '.join(command)}\nexit status {result.returncode}\n"
            f"{result.stderr[:1000]}"
        )
    return result.stdout
