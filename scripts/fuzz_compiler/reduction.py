# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes a failing program small: cvise on the source, and llvm-reduce on the
IR if the compiler itself fails. Both ask is_interesting() through a script."""

import os
import shlex
import shutil
import sys

from targets import (
    COMMON, SANITIZED, Failure, Unusable, compile_failure, language,
    native_compilers, run,
)

COMPILER_FAILURES = ("crash", "verifier", "rejected", "endless compilation")

# What makes a program undefined must not be what a reduction ends with.
CHECKED = SANITIZED + ["-Werror=uninitialized", "-Werror=return-type",
                       "-Werror=conditional-uninitialized"]


def signature(text):
    """The line that says what went wrong."""
    for line in text.splitlines():
        for word in ("LLVM ERROR", "Bad machine code", "fatal error",
                     "error:", "Assertion"):
            if word in line:
                return line.split(":", 1)[-1].strip()[:80]
    return ""


def natives_print(tools, source, directory, expected):
    """Whether plain and optimized native programs print what is expected."""
    try:
        return expected and all(
            tools.expected(source, compiler, directory, [level]) == expected
            for compiler in native_compilers(source)
            for level in ("-O0", "-O2"))
    except Unusable:
        return False


def is_interesting(tools, source, wanted, directory):
    """Whether the source still fails as the wanted Failure does."""
    expected = b""
    needs_output = wanted.kind not in COMPILER_FAILURES
    if needs_output:
        try:
            expected = tools.expected(source, native_compilers(source)[0],
                                      directory, CHECKED)
        except Unusable:
            return False
    failure = tools.check(source, wanted.level, wanted.mode, expected,
                          directory)
    if failure is None or failure.kind != wanted.kind:
        return False
    if needs_output:
        return natives_print(tools, source, directory, expected)
    return signature(failure.text) == wanted.text


def is_interesting_ir(tools, source, wanted):
    """Likewise of LLVM IR and a failure of the compiler."""
    result = run([tools.tpcc, "-c", "-fno-lto", wanted.level, "-mllvm",
                  "-verify-machineinstrs", source, "-o", os.devnull], 60)
    if result is None:
        return wanted.kind == "endless compilation"
    return (result.returncode != 0
            and compile_failure(result) == wanted.kind
            and signature(result.stderr.decode(errors="replace"))
            == wanted.text)


def write_script(path, tools, name, wanted):
    words = [
        sys.executable, os.path.dirname(os.path.abspath(__file__)),
        "--tools", os.path.abspath(tools.tools), "--parts", tools.directory,
        "--interesting", name, f"--level={wanted.level}", "--mode",
        wanted.mode, "--failure", wanted.kind, "--signature", wanted.text,
    ]
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"#!/bin/sh\nexec {shlex.join(words)}\n")
    os.chmod(path, 0o755)


def reduce(tools, failure, source, directory, seconds):
    """The name of the smaller program, or why there is none."""
    wanted = Failure(failure.kind, failure.level, failure.mode,
                     signature(failure.text)
                     if failure.kind in COMPILER_FAILURES else "")
    if failure.kind in ("crash", "verifier"):
        reduced = reduce_ir(tools, wanted, source, directory, seconds)
        if reduced:
            return reduced
    if not shutil.which("cvise"):
        return "not reduced: cvise is missing"
    name = f"reduced.{language(source)}"
    reduced = os.path.join(directory, name)
    shutil.copy(source, reduced)
    script = os.path.join(directory, "interesting.sh")
    write_script(script, tools, name, wanted)
    run(["cvise", "--n", "1", "--timeout", "60", script, name], seconds,
        cwd=directory)
    return reduced


def reduce_ir(tools, wanted, source, directory, seconds):
    ir = os.path.join(directory, "program.ll")
    result = run([tools.tpcc, *COMMON, "-w", "-S", "-emit-llvm", wanted.level,
                  source, "-o", ir], 60)
    if (result is None or result.returncode != 0
            or not is_interesting_ir(tools, ir, wanted)):
        return None
    script = os.path.join(directory, "interesting-ir.sh")
    write_script(script, tools, "", wanted)
    with open(script, encoding="utf-8") as file:
        text = file.read()
    with open(script, "w", encoding="utf-8") as file:
        file.write(text.replace("--interesting ''", '--interesting "$1"'))
    reduced = os.path.join(directory, "reduced.ll")
    run(["llvm-reduce-22", f"--test={script}", ir, "-o", reduced], seconds)
    return reduced if os.path.exists(reduced) else ir
