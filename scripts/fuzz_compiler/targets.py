# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles and runs a program natively and on the simulated 1x1 chip."""

import dataclasses
import os
import re
import signal
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
INCLUDE = os.path.join(HERE, "include")
SUPPORT = os.path.join(HERE, "support")

LEVELS = ["-O0", "-O1", "-O2", "-O3", "-Os"]

# How the program and the runtime come together.
MODES = {
    # One module, which is optimized as a whole.
    "whole": [],
    # The program is one module, the runtime an object.
    "module": ["-nostdlib"],
    # Every file is an object.
    "objects": ["-nostdlib", "-fno-lto"],
}

# Both reach the command line of each compiler.
COMMON = ["-ffreestanding", "-I", INCLUDE, "-idirafter", "/usr/include"]

NATIVE = [
    "-m32", "-msse2", "-mfpmath=sse", "-malign-double", "-ffp-contract=off",
    "-fno-pic", "-fno-pie", "-fno-stack-protector", "-fno-strict-aliasing",
    "-march=pentium4", "-mno-mmx", "-fno-math-errno",
]
# A program with a pointer to a packed field is not comparable. What the warning
# does not see traps.
NATIVE_ERRORS = [
    "-Wno-everything", "-Werror=address-of-packed-member",
    "-fsanitize=alignment", "-fsanitize-trap=alignment",
]
# The undefined ends a native C++ program, which then does not count.
SANITIZED = ["-fsanitize=undefined,bounds,float-cast-overflow",
             "-fsanitize-trap=all"]
NATIVE_LINK = ["-static", "-nostdlib", "-no-pie"]
NATIVE_COMPILERS = {
    "c": ["clang-22", "gcc"],
    "cpp": ["clang++-22", "g++"],
}
CXX = ["-std=gnu++20", "-fno-exceptions", "-fno-rtti"]
NATIVE_CXX = ["-fno-threadsafe-statics", "-Wno-psabi"]

NATIVE_SECONDS = 0.3
COMPILE_SECONDS = 120
SIMULATED_CYCLES = 40_000_000
SIMULATED_SECONDS = 120


class Unusable(Exception):
    """The program cannot be compared: it is too long or not valid."""


@dataclasses.dataclass
class Failure:
    """kind: crash, verifier, rejected, trap, endless or mismatch."""

    kind: str
    level: str
    mode: str
    text: str

    def __str__(self):
        return f"{self.kind} at {self.level}, {self.mode}"


def run(arguments, seconds, **options):
    """The finished process; None if it took too long, and then it has ended
    with all that it started."""
    with subprocess.Popen(
        arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True, **options,
    ) as process:
        try:
            output, errors = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return None
    return subprocess.CompletedProcess(
        arguments, process.returncode, output, errors)


def language(source):
    return "cpp" if source.endswith(".cpp") else "c"


def native_compilers(source):
    """Clang first, and alone if the source says so in its first line."""
    with open(source, encoding="utf-8") as file:
        is_for_clang = file.readline().startswith("// clang only")
    compilers = NATIVE_COMPILERS[language(source)]
    return compilers[:1] if is_for_clang else compilers


def compile_failure(result):
    """What kind of failure a compiler's end is."""
    text = result.stderr.decode(errors="replace")
    if "Bad machine code" in text:
        return "verifier"
    crashed = result.returncode not in (0, 1) or re.search(
        "PLEASE submit a bug report|Stack dump:|LLVM ERROR", text
    )
    return "crash" if crashed else "rejected"


def native_builtins():
    """Clang's library of 64-bit arithmetic for 32-bit programs."""
    path = subprocess.run(
        ["clang-22", "-m32", "-rtlib=compiler-rt", "-print-libgcc-file-name"],
        capture_output=True, text=True, check=True,
    ).stdout.strip()
    if not os.path.exists(path):
        raise FileNotFoundError(
            f"{path} is missing; install libclang-rt-22-dev")
    return path


class Tools:
    """The compilers, and the parts that every program is linked with, which
    are in a directory and compiled here for the modes given."""

    def __init__(self, tools, directory, modes=()):
        self.tpcc = os.path.join(tools, "tpcc")
        self.tpsim = os.path.join(tools, "tpsim")
        self.tools = tools
        self.directory = os.path.abspath(directory)
        self.native_builtins = native_builtins()
        if modes:
            os.makedirs(self.directory, exist_ok=True)
            self._prepare(modes != ["whole"])

    def _part(self, name):
        return os.path.join(self.directory, name)

    def _prepare(self, needs_runtime):
        runtime = os.path.join(self.tools, "../lib/tp/runtime.bc")
        report = os.path.join(SUPPORT, "report.c")
        native = os.path.join(SUPPORT, "native.c")
        if needs_runtime:
            subprocess.run(
                [self.tpcc, "-O2", "-fno-lto", "-c", "-x", "ir", runtime,
                 "-o", self._part("tp-runtime.o")], check=True)
        for command in (
            [self.tpcc, *COMMON, "-O2", "-fno-lto", "-c", report,
             "-o", self._part("tp-report.o")],
            ["clang-22", *NATIVE, *COMMON, "-O2", "-c", report,
             "-o", self._part("native-report.o")],
            ["clang-22", *NATIVE, *COMMON, "-O2", "-fno-builtin", "-c", native,
             "-o", self._part("native.o")],
        ):
            subprocess.run(command, check=True)

    def native_command(self, source, compiler, output, extra=()):
        options = CXX + NATIVE_CXX if language(source) == "cpp" else []
        if compiler.startswith("clang"):
            options = options + NATIVE_ERRORS
        else:
            options = options + ["-w"]
        return [
            compiler, *NATIVE, *NATIVE_LINK, *COMMON, *options, *extra, source,
            self._part("native.o"), self._part("native-report.o"),
            self.native_builtins, "-o", output,
        ]

    def tp_command(self, source, level, mode, output):
        # An option for one of the two compilations of a whole program would
        # be "unused" in the other.
        parts = [self._part("tp-report.o")]
        if mode != "whole":
            parts.append(self._part("tp-runtime.o"))
        options = CXX if language(source) == "cpp" else []
        return [
            self.tpcc, *COMMON, "-w", *options, *MODES[mode], level,
            "-mllvm", "-verify-machineinstrs", source, *parts, "-o", output,
        ]

    def expected(self, source, compiler, directory, extra=()):
        """The native run's output, at -O0 unless extra says otherwise."""
        program = os.path.join(directory, "native")
        command = self.native_command(source, compiler, program, extra)
        result = run(command, COMPILE_SECONDS)
        if result is None or result.returncode != 0:
            text = result.stderr.decode() if result else "time"
            raise Unusable(f"{compiler} refuses it: {text[:2000]}")
        result = run([program], NATIVE_SECONDS)
        if result is None:
            raise Unusable("long")
        if result.returncode != 0:
            raise Unusable(f"native exit status {result.returncode}")
        return result.stdout

    def _simulate(self, program):
        """The run; None if it does not end. What is long goes on without
        timing."""
        command = [self.tpsim, program, "--chip", "1x1", "--quiet"]
        result = run([*command, "--max-cycles", str(SIMULATED_CYCLES)],
                     SIMULATED_SECONDS)
        if result and b"max-cycles" in result.stderr:
            result = run([*command, "--functional"], SIMULATED_SECONDS)
        return result

    def check(self, source, level, mode, expected, directory):
        """None if the program prints what is expected, else a Failure."""
        program = os.path.join(directory, "program.elf")
        command = self.tp_command(source, level, mode, program)
        result = run(command, COMPILE_SECONDS)
        if result is None:
            return Failure("endless compilation", level, mode, "")
        if result.returncode != 0:
            return Failure(compile_failure(result), level, mode,
                           result.stderr.decode(errors="replace"))
        result = self._simulate(program)
        if result is None:
            return Failure("endless", level, mode, "")
        if result.returncode != 0:
            return Failure("trap", level, mode,
                           result.stderr.decode(errors="replace"))
        if result.stdout != expected:
            return Failure(
                "mismatch", level, mode,
                f"expected {expected!r}, got {result.stdout!r}",
            )
        return None
