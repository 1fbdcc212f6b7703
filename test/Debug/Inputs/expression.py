# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Evaluates DWARF expressions in the form in which llvm-dwarfdump prints them.
"""

import re

MASK = 0xFFFFFFFF


class Unavailable(Exception):
    """The variable has no value here, as far as the program says."""


def split(text):
    """The operations of an expression."""
    parts, depth, start = [], 0, 0
    for index, char in enumerate(text):
        depth += (char == "(") - (char == ")")
        if char == "," and depth == 0:
            parts.append(text[start:index].strip())
            start = index + 1
    return [*parts, text[start:].strip()] if text.strip() else []


def signed(value):
    return value - (1 << 32) if value & 0x80000000 else value


BINARY = {
    "plus": lambda a, b: a + b,
    "minus": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: int(signed(a) / signed(b)),
    "mod": lambda a, b: a % b,
    "and": lambda a, b: a & b,
    "or": lambda a, b: a | b,
    "xor": lambda a, b: a ^ b,
    "shl": lambda a, b: a << b if b < 32 else 0,
    "shr": lambda a, b: a >> b if b < 32 else 0,
    "shra": lambda a, b: signed(a) >> min(b, 31),
    "eq": lambda a, b: signed(a) == signed(b),
    "ne": lambda a, b: signed(a) != signed(b),
    "lt": lambda a, b: signed(a) < signed(b),
    "le": lambda a, b: signed(a) <= signed(b),
    "gt": lambda a, b: signed(a) > signed(b),
    "ge": lambda a, b: signed(a) >= signed(b),
}
UNARY = {"neg": lambda a: -a, "not": lambda a: ~a}


class Evaluator:
    """Evaluates expressions in a frame, which has registers and the functions
    load(address, size), frame_base(), entry_value(expression), address(index)
    and base_type(offset), which gives (size, is signed)."""

    def __init__(self, frame):
        self.frame = frame
        self.stack = []

    def value_bytes(self, text, size):
        """The size bytes of what the expression describes."""
        result, self.stack, self.kind, self.pieces = b"", [], "memory", False
        for operation in split(text):
            name, operand = re.fullmatch(
                r"(\w+\(.*\)|\w+)\s*(.*)", operation
            ).groups()
            if name == "DW_OP_piece":
                result += self._piece(int(operand, 0))
                self.stack, self.kind, self.pieces = [], "memory", True
            else:
                self._step(name.removeprefix("DW_OP_"), operand)
        return result if self.pieces else self._piece(size)

    def number(self, text):
        """What the expression computes."""
        return int.from_bytes(self.value_bytes(text, 4), "little")

    def computed(self, text):
        """What the expression leaves on the stack."""
        return self.number(text + ", DW_OP_stack_value")

    def _piece(self, size):
        if not self.stack:
            raise Unavailable
        top = self.stack[-1]
        if self.kind == "memory":
            return self.frame.load(top & MASK, size)
        return (top & ((1 << 8 * size) - 1)).to_bytes(size, "little")

    def _step(self, name, operand):
        push = self.stack.append
        register = re.fullmatch(r"b?reg(\d+)", name)
        if register:
            self._register(name, int(register[1]), operand)
        elif name in ("regx", "bregx"):
            number, _, offset = operand.partition(" ")
            self._register(name, int(number, 0), offset)
        elif re.fullmatch(r"lit\d+", name):
            push(int(name[3:]))
        elif re.fullmatch(r"const\w+", name):
            push(int(operand, 0) & 0xFFFFFFFFFFFFFFFF)
        elif name == "fbreg":
            push((self.frame.frame_base() + int(operand, 0)) & MASK)
        elif name == "addr":
            push(int(operand, 0))
        elif name == "addrx":
            push(self.frame.address(int(operand, 0)))
        elif name == "plus_uconst":
            push((self.stack.pop() + int(operand, 0)) & MASK)
        elif name in BINARY:
            right, left = self.stack.pop(), self.stack.pop()
            push(int(BINARY[name](left, right)) & MASK)
        elif name in UNARY:
            push(UNARY[name](self.stack.pop()) & MASK)
        else:
            self._special(name, operand)

    def _register(self, name, number, offset):
        value = self.frame.registers[number]
        if name.startswith("breg"):
            self.stack.append((value + int(offset, 0)) & MASK)
        else:
            self.stack.append(value)
            self.kind = "value"

    def _special(self, name, operand):
        push, pop = self.stack.append, self.stack.pop
        if name == "stack_value":
            self.kind = "value"
        elif name == "deref":
            push(int.from_bytes(self.frame.load(pop(), 4), "little"))
        elif name == "deref_size":
            size = int(operand, 0)
            push(int.from_bytes(self.frame.load(pop(), size), "little"))
        elif name.startswith(("entry_value", "GNU_entry_value")):
            push(self.frame.entry_value(name[name.index("(") + 1 : -1]))
        elif name == "convert":
            size, is_signed = self.frame.base_type(
                int(re.search(r"0x\w+", operand)[0], 16)
            )
            value = pop() & ((1 << size) - 1)
            if is_signed and value >> (size - 1):
                value -= 1 << size
            push(value & MASK)
        elif name == "implicit_value":
            data = bytes(int(byte, 16) for byte in operand.split()[1:])
            push(int.from_bytes(data, "little"))
            self.kind = "value"
        elif name == "dup":
            push(self.stack[-1])
        elif name == "swap":
            self.stack[-2:] = self.stack[:-3:-1]
        elif name == "drop":
            pop()
        elif name not in ("form_tls_address", "GNU_push_tls_address"):
            # A thread_local object's offset is its address.
            raise ValueError(f"cannot evaluate DW_OP_{name} {operand}")
