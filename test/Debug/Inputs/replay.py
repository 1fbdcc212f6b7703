# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A thread's registers and memory at each instruction of a run, from what
`tpsim --trace-instructions` writes."""

import re
import struct
import subprocess

STACK_POINTER, RETURN_ADDRESS = 29, 31
STORED_BYTES = {"sb": 1, "sh": 2, "sw": 4, "swc1": 4}


def disassemble(program):
    """The instructions' texts by address."""
    command = ["tp-objdump", "-d", "--no-aliases", program]
    output = subprocess.run(
        command, capture_output=True, text=True, check=True
    ).stdout
    return {
        int(address, 16): text.strip()
        for address, text in re.findall(
            r"^\s*([0-9a-f]+):\s+[0-9a-f]{8}\s+(.*)$", output, re.M
        )
    }


def load_image(program):
    """The bytes of the loaded segments by address."""
    data = open(program, "rb").read()
    offset, entry_size, count = (
        struct.unpack_from("<I", data, 28)[0],
        *struct.unpack_from("<HH", data, 42),
    )
    image = {}
    for number in range(count):
        kind, start, address, _, size = struct.unpack_from(
            "<IIIII", data, offset + number * entry_size
        )
        if kind == 1:
            image.update(enumerate(data[start : start + size], address))
    return image


def register_number(name):
    return int(name[1:]) + (32 if name[0] == "f" else 0)


class Thread:
    """The state before the instruction at pc."""

    def __init__(self, program):
        self.instructions = disassemble(program)
        self.memory = load_image(program)
        self.registers = [0] * 64
        self.pc = None

    def load(self, address, size=4):
        """Little-endian bytes; what was never written is 0."""
        return bytes(
            self.memory.get((address + index) & 0xFFFFFFFF, 0)
            for index in range(size)
        )

    def word(self, address):
        return int.from_bytes(self.load(address), "little")

    def _apply_store(self, text):
        store = re.match(
            r"(sbx?|shx?|swx?|swx?c1)\s+([rf]\d+), ([^(]+)\((r\d+)\)",
            text,
        )
        if not store:
            return
        size = STORED_BYTES[store[1].replace("x", "")]
        offset = (
            self.registers[register_number(store[3])]
            if re.fullmatch(r"r\d+", store[3])
            else int(store[3], 0)
        )
        address = self.registers[register_number(store[4])] + offset
        value = self.registers[register_number(store[2])]
        for index in range(size):
            self.memory[(address + index) & 0xFFFFFFFF] = (
                value >> 8 * index
            ) & 0xFF

    def follow(self, trace):
        """Yields the address of each executed instruction, with the state as it
        is before it."""
        for line in open(trace):
            pc, *changes = line.split()
            if self.pc is not None:
                self._apply_store(self.instructions[self.pc])
            for change in changes:
                name, value = change.split("=")
                self.registers[register_number(name)] = int(value, 16)
            self.pc = int(pc, 16)
            yield self.pc


def unwind(registers, word, row):
    """The caller's registers, and where it goes on, by a row of the frame
    table; word(address) reads memory."""
    base, offset, saved, _ = row
    frame = (registers[base] + offset) & 0xFFFFFFFF
    caller = list(registers)
    for register, distance in saved.items():
        caller[register] = word((frame + distance) & 0xFFFFFFFF)
    caller[STACK_POINTER] = frame
    return caller, caller[RETURN_ADDRESS]
