#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fuzzes the TP's assembler and disassembler.

usage: fuzz_mc.py [--tools DIRECTORY] [--words N] [--texts N] [--seed SEED]

Words: N random words, half of them made from valid opcodes, are disassembled.
Each is refused, or its text assembles to the same word.
Texts: N lines of random tokens are assembled, which may fail but not crash.
Files: objects with random bytes changed are disassembled, likewise.
"""

import argparse
import os
import random
import re
import struct
import subprocess
import sys
import tempfile

TOKENS = (
    "add addi lw swx jal beq ext ins li la mfsr atom_cas break nop foo .word "
    ".space .balign .set .quad r4 r31 f5 sp thread %hi %lo ( ) , + - * / << "
    "0 1 -1 32 65536 0xffffffff 99999999999999999999 1.5 \"a\" 'a' symbol . : "
    "= ; @ $ ! ~ [ ] { } \\"
).split(" ")


def run(arguments, text):
    return subprocess.run(
        arguments, input=text, capture_output=True, check=False
    )


def crashed(result):
    return result.returncode not in (0, 1)


def fail(message, material):
    print(f"fuzz_mc: {message}\n{material}", file=sys.stderr)
    sys.exit(1)


def random_words(generator, count):
    """Random words, the second half with few bits set below the opcode."""
    words = [generator.getrandbits(32) for _ in range(count // 2)]
    while len(words) < count:
        word = generator.randrange(64) << 26
        for shift, width in ((21, 5), (16, 5), (11, 5), (6, 5), (0, 6)):
            if generator.random() < 0.6:
                word |= generator.getrandbits(width) << shift
        words.append(word)
    return words


def check_words(tp_mc, words):
    """Disassembles words and assembles the text; returns how many are valid."""
    hexadecimal = "\n".join(
        " ".join(f"{byte:02x}" for byte in struct.pack("<I", word))
        for word in words
    )
    result = run([tp_mc, "-disassemble"], hexadecimal.encode())
    if crashed(result):
        fail("the disassembler crashed", hexadecimal)
    refused = {
        int(line) - 1
        for line in re.findall(
            r"^<stdin>:(\d+):1: error:", result.stderr.decode(), re.MULTILINE
        )
    }
    valid = [word for i, word in enumerate(words) if i not in refused]
    statements = [
        line for line in result.stdout.decode().splitlines() if line.strip()
    ]
    statements = [s for s in statements if not s.strip().startswith(".")]
    if len(statements) != len(valid):
        fail("statements are missing", result.stdout.decode())
    again = run(
        [tp_mc, "-show-encoding"], "\n".join(statements).encode() + b"\n"
    )
    if again.returncode != 0:
        fail("the disassembler's text does not assemble", again.stderr.decode())
    encodings = re.findall(
        r"encoding: \[0x(..),0x(..),0x(..),0x(..)\]", again.stdout.decode()
    )
    assembled = [int("".join(reversed(e)), 16) for e in encodings]
    for word, statement, other in zip(valid, statements, assembled):
        if word != other:
            fail("a word changed", f"{word:08x} {statement} {other:08x}")
    if len(assembled) != len(valid):
        fail("encodings are missing", again.stdout.decode())
    return len(valid)


def check_texts(tp_mc, generator, count, directory):
    object_name = os.path.join(directory, "text.o")
    for _ in range(count):
        text = "\n".join(
            " ".join(
                generator.choice(TOKENS) for _ in range(generator.randrange(9))
            )
            for _ in range(8)
        )
        # Enormous sections are legal and slow.
        text = re.sub(r"(\.space|\.balign)[^\n]*", r"\1 4", text)
        result = run(
            [tp_mc, "-filetype=obj", "-o", object_name], text.encode()
        )
        if crashed(result):
            fail("the assembler crashed", text)


def check_files(tp_mc, tp_objdump, generator, count, directory):
    source = (
        "main: jal callee\n lui r4, %hi(x)\n beq r4, r5, main\n .4byte 7\n"
        ".data\n .4byte main\n"
    )
    good = run([tp_mc, "-g", "-filetype=obj"], source.encode()).stdout
    name = os.path.join(directory, "broken.o")
    for _ in range(count):
        broken = bytearray(good)
        for _ in range(generator.randrange(1, 4)):
            broken[generator.randrange(20, len(broken))] = (
                generator.getrandbits(8)
            )
        if generator.random() < 0.2:
            del broken[generator.randrange(len(broken)) :]
        with open(name, "wb") as file:
            file.write(broken)
        for mode in ("-dthr", "--assembly"):
            if crashed(run([tp_objdump, mode, name], b"")):
                fail(f"tp-objdump {mode} crashed", broken.hex())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tools", default="", help="instead of the PATH")
    parser.add_argument("--words", type=int, default=100000)
    parser.add_argument("--texts", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    tp_mc = os.path.join(options.tools, "tp-mc")
    tp_objdump = os.path.join(options.tools, "tp-objdump")
    generator = random.Random(options.seed)
    valid = check_words(tp_mc, random_words(generator, options.words))
    with tempfile.TemporaryDirectory() as directory:
        check_texts(tp_mc, generator, options.texts, directory)
        check_files(tp_mc, tp_objdump, generator, options.texts, directory)
    print(
        f"{options.words} words, {valid} of them instructions; "
        f"{options.texts} texts; {options.texts} files"
    )


if __name__ == "__main__":
    main()
