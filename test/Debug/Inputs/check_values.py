# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Stops a run at each call of probe() and compares the variables' values, as
the debug information describes them, with what the source says there:

    probe(); // a=5 b.x=1.5 list[2]=7 i=0|1|2

The values of several visits are separated by `|`.

    check_values.py <source> <program> <trace> [--all | --at-least <n>]

--all: every value must be available. --at-least: so many must be. A wrong value
is always an error.
"""

import argparse
import re
import struct
import sys

from dwarf import FrameTable, LineTable, covers, dump, location_at, read_dies
from expression import Evaluator, Unavailable
from replay import Thread, unwind


class Program:
    """What the debug information says of the whole program."""

    def __init__(self, path):
        self.dies = read_dies(path)
        self.lines, self.frames = LineTable(path), FrameTable(path)
        self.addresses = self._read_addresses(path)

    @staticmethod
    def _read_addresses(path):
        """The address tables of the units by their offsets."""
        tables, table, start = {}, None, 0
        for line in dump(path, "--debug-addr").splitlines():
            header = re.match(r"Address table header: length = (\w+)", line)
            if header:
                table = tables.setdefault(start + 8, [])
                start += 4 + int(header[1], 16)
            elif re.fullmatch(r"0x\w+", line.strip()):
                table.append(int(line, 16))
        return tables

    def function_at(self, pc):
        for die in self.dies.values():
            if die.tag == "DW_TAG_subprogram" and covers(die, pc):
                return die
        return None

    def origin(self, die):
        """The entry with name and type."""
        for name in ("DW_AT_abstract_origin", "DW_AT_specification"):
            text = die.attributes.get(name)
            if text and "DW_AT_name" not in die.attributes:
                return self.origin(self.dies[int(text.split()[0], 16)])
        return die

    def name(self, die):
        text = self.origin(die).attributes.get("DW_AT_name")
        return text.strip('"') if text else None

    def type_of(self, die):
        """The type without typedefs and qualifiers."""
        text = self.origin(die).attributes.get("DW_AT_type")
        if text is None:
            return None
        kind = self.dies[int(text.split()[0], 16)]
        plain = (
            "DW_TAG_typedef",
            "DW_TAG_const_type",
            "DW_TAG_volatile_type",
        )
        return self.type_of(kind) if kind.tag in plain else kind

    def size_of(self, kind):
        if kind.tag == "DW_TAG_array_type":
            return self.size_of(self.type_of(kind)) * self.count_of(kind)
        size = kind.number("DW_AT_byte_size")
        return 4 if size is None else size

    def count_of(self, kind):
        for child in kind.children:
            if child.number("DW_AT_count") is not None:
                return child.number("DW_AT_count")
            if child.number("DW_AT_upper_bound") is not None:
                return child.number("DW_AT_upper_bound") + 1
        raise ValueError("array without a bound")


class Frame:
    """A function's activation: registers, and the address of the instruction
    that it is at."""

    def __init__(self, program, thread, registers, pc):
        self.program, self.thread = program, thread
        self.registers, self.pc = registers, pc
        self.function = program.function_at(pc)

    def load(self, address, size):
        return self.thread.load(address, size)

    def frame_base(self):
        text = self.function.attributes["DW_AT_frame_base"]
        if text == "DW_OP_call_frame_cfa":
            return self.caller().registers[29]
        return Evaluator(self).number(text)

    def address(self, index):
        unit = self.function
        while unit.parent:
            unit = unit.parent
        return self.program.addresses[unit.number("DW_AT_addr_base")][index]

    def base_type(self, offset):
        attributes = self.program.dies[offset].attributes
        name = attributes["DW_AT_name"].strip('"')
        bits = re.search(r"_(\d+)$", name)
        size = int(attributes["DW_AT_byte_size"], 0) * 8
        return int(bits[1]) if bits else size, "_signed" in attributes[
            "DW_AT_encoding"
        ]

    def caller(self):
        """Whoever called; at the instruction of the call."""
        row = self.program.frames.at(self.pc)
        registers, address = unwind(self.registers, self.thread.word, row)
        return Frame(self.program, self.thread, registers, address - 4)

    def entry_value(self, expression):
        """What a register held when the function was called, if the caller can
        still tell."""
        caller = self.caller()
        for die in caller.function.walk() if caller.function else []:
            if die.tag != "DW_TAG_call_site" or caller.pc + 4 != die.number(
                "DW_AT_call_return_pc"
            ):
                continue
            origin = die.attributes.get("DW_AT_call_origin")
            if origin and int(origin.split()[0], 16) not in (
                self.function.offset,
                self.program.origin(self.function).offset,
            ):
                # A tail call is between the two.
                raise Unavailable
            for parameter in die.children:
                if parameter.attributes.get("DW_AT_location") == expression:
                    value = parameter.attributes.get("DW_AT_call_value")
                    return Evaluator(caller).computed(value)
        raise Unavailable

    def visible(self):
        """The variables in scope, the innermost first."""
        scope, found = self.function, [self.function]
        inner = True
        while inner:
            inner = next(
                (
                    child
                    for child in scope.children
                    if child.tag
                    in ("DW_TAG_lexical_block", "DW_TAG_inlined_subroutine")
                    and covers(child, self.pc)
                ),
                None,
            )
            if inner:
                scope = inner
                found.append(inner)
        for die in reversed(found):
            yield from die.children
            if die.tag != "DW_TAG_lexical_block":
                break
        unit = self.function.parent
        while unit.parent:
            unit = unit.parent
        yield from unit.children

    def variable(self, name):
        for die in self.visible():
            if die.tag in (
                "DW_TAG_variable",
                "DW_TAG_formal_parameter",
            ) and name == self.program.name(die):
                return die
        raise Unavailable

    def value(self, path):
        """What a variable, or a part of one, holds."""
        name, *parts = re.findall(r"\w+", path)
        die = self.variable(name)
        kind = self.program.type_of(die)
        data = self._data(die, self.program.size_of(kind))
        for part in parts:
            kind, data = self._part(kind, data, part)
        return self._number(kind, data)

    def _data(self, die, size):
        constant = die.attributes.get("DW_AT_const_value")
        if constant is not None:
            return (int(constant, 0) & ((1 << 8 * size) - 1)).to_bytes(
                size, "little"
            )
        text = location_at(die, self.pc)
        if text is None:
            raise Unavailable
        return Evaluator(self).value_bytes(text, size)

    def _part(self, kind, data, part):
        if kind.tag == "DW_TAG_array_type":
            element = self.program.type_of(kind)
            size = self.program.size_of(element)
            return element, data[int(part) * size :][:size]
        for member in kind.children:
            if self.program.name(member) == part:
                start = member.number("DW_AT_data_member_location") or 0
                inner = self.program.type_of(member)
                size = self.program.size_of(inner)
                return inner, data[start : start + size]
        raise ValueError(f"no member {part}")

    def _number(self, kind, data):
        encoding = kind.attributes.get("DW_AT_encoding", "")
        if encoding == "DW_ATE_float":
            form = {2: "<e", 4: "<f", 8: "<d"}[len(data)]
            return struct.unpack(form, data)[0]
        return int.from_bytes(data, "little", signed="_signed" in encoding)


def read_expectations(source):
    """By line number: paths with the values of the visits as text."""
    expectations = {}
    for number, line in enumerate(open(source), 1):
        comment = re.search(r"probe\(\); // (.*)", line)
        if comment:
            expectations[number] = [
                (path, values.split("|"))
                for path, values in re.findall(r"(\S+?)=(\S+)", comment[1])
            ]
    return expectations


class Checker:
    """Compares values and counts them."""

    def __init__(self, expectations):
        self.expectations = expectations
        self.visits = {line: 0 for line in expectations}
        self.available, self.missing, self.wrong = 0, [], []

    def visit(self, frame):
        line = frame.program.lines.at(frame.pc)[1]
        if line not in self.expectations:
            return
        for path, values in self.expectations[line]:
            expected = values[min(self.visits[line], len(values) - 1)]
            self._compare(frame, line, path, float(expected))
        self.visits[line] += 1

    def _compare(self, frame, line, path, expected):
        try:
            value = frame.value(path)
        except Unavailable:
            self.missing.append(f"line {line}: {path} is not available")
            return
        self.available += 1
        if value != expected:
            self.wrong.append(
                f"line {line}: {path} is {value}, not {expected:g}"
            )


def find_function(program, name):
    for die in program.dies.values():
        if die.tag == "DW_TAG_subprogram" and program.name(die) == name:
            if die.number("DW_AT_low_pc") is not None:
                return die.number("DW_AT_low_pc")
    raise SystemExit(f"the program has no function {name}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source")
    parser.add_argument("program")
    parser.add_argument("trace")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--at-least", type=int, default=1)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    program, thread = Program(options.program), Thread(options.program)
    checker = Checker(read_expectations(options.source))
    probe = find_function(program, "probe")
    for pc in thread.follow(options.trace):
        if pc == probe:
            checker.visit(Frame(program, thread, thread.registers, pc).caller())
    missing = checker.missing if options.all or options.verbose else []
    unvisited = [
        f"line {line} was not reached"
        for line, count in checker.visits.items()
        if not count
    ]
    print("\n".join(checker.wrong + missing + unvisited))
    print(
        f"{checker.available} values available, {len(checker.missing)} not, "
        f"{len(checker.wrong)} wrong"
    )
    failed = checker.wrong or unvisited or (options.all and checker.missing)
    sys.exit(1 if failed or checker.available < options.at_least else 0)


if __name__ == "__main__":
    main()
