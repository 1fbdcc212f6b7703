# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Debug information of a program as llvm-dwarfdump prints it."""

import bisect
import re
import subprocess


def dump(program, *options):
    command = ["llvm-dwarfdump", *options, program]
    return subprocess.run(
        command, capture_output=True, text=True, check=True
    ).stdout


class Die:
    """A debugging information entry: tag, attributes as text, children."""

    def __init__(self, offset, tag, parent):
        self.offset, self.tag, self.parent = offset, tag, parent
        self.attributes, self.children = {}, []

    def walk(self):
        yield self
        for child in self.children:
            yield from child.walk()

    def number(self, name):
        text = self.attributes.get(name)
        return int(text, 0) if text and re.fullmatch(r"\w+", text) else None


def read_dies(program):
    """All entries by their offsets."""
    dies, stack, attribute = {}, [], None
    for line in dump(program, "--debug-info").splitlines():
        entry = re.match(r"0x([0-9a-f]+):( +)(\w+)", line)
        if entry:
            depth = (len(entry[2]) - 1) // 2
            del stack[depth:]
            if entry[3] == "NULL":
                continue
            parent = stack[-1] if stack else None
            die = Die(int(entry[1], 16), entry[3], parent)
            dies[die.offset] = die
            if parent:
                parent.children.append(die)
            stack.append(die)
            continue
        start = re.match(r"\s+(DW_AT_\w+)\s*\((.*)", line)
        if start:
            attribute = start[1]
            stack[-1].attributes[attribute] = start[2]
        elif attribute and stack and line.strip():
            stack[-1].attributes[attribute] += "\n" + line.strip()
    for die in dies.values():
        for name, text in die.attributes.items():
            die.attributes[name] = text.strip().removesuffix(")")
    return dies


def address_ranges(die):
    """What code an entry covers, as pairs of addresses."""
    if "DW_AT_ranges" in die.attributes:
        pairs = re.findall(
            r"\[(0x\w+), (0x\w+)\)", die.attributes["DW_AT_ranges"]
        )
        return [(int(low, 16), int(high, 16)) for low, high in pairs]
    low, high = die.number("DW_AT_low_pc"), die.number("DW_AT_high_pc")
    return [] if low is None or high is None else [(low, high)]


def covers(die, pc):
    return any(low <= pc < high for low, high in address_ranges(die))


def location_at(die, pc):
    """The expression for where a variable is at pc, as text, or None."""
    text = die.attributes.get("DW_AT_location")
    if text is None:
        return None
    if "loclist" not in text:
        return text
    for low, high, expression in re.findall(
        r"\[(0x\w+), (0x\w+)\): (.*)", text
    ):
        if int(low, 16) <= pc < int(high, 16):
            return expression
    return None


class LineTable:
    """Which line of which file an address belongs to."""

    def __init__(self, program):
        self.rows, files = [], {}
        number = None
        for line in dump(program, "--debug-line").splitlines():
            if line.startswith("debug_line["):
                files = {}
            file = re.match(r"file_names\[\s*(\d+)\]", line)
            if file:
                number = int(file[1])
            name = re.match(r'\s+name: "(.*)"', line)
            if name and number is not None:
                files[number] = name[1]
            row = re.match(
                r"0x(\w+)\s+(\d+)\s+\d+\s+(\d+)\s.*?([a-z].*)?$", line
            )
            if row:
                self.rows.append(
                    (
                        int(row[1], 16),
                        files.get(int(row[3])),
                        int(row[2]),
                        row[4] or "",
                    )
                )
        self.rows.sort(key=lambda row: row[0])
        self.addresses = [row[0] for row in self.rows]

    def at(self, pc):
        """(file, line) of pc."""
        index = bisect.bisect_right(self.addresses, pc) - 1
        return self.rows[index][1:3] if index >= 0 else (None, 0)


class FrameTable:
    """The rules of .debug_frame for each address."""

    def __init__(self, program):
        self.rows, self.ends = [], []
        end = None
        for line in dump(program, "--debug-frame").splitlines():
            entry = re.search(r" FDE .*pc=\w+\.\.\.(\w+)", line)
            if entry:
                end = int(entry[1], 16)
            elif " CIE" in line or line.endswith(" CIE"):
                end = None
            row = re.match(
                r"\s+0x(\w+): CFA=reg(\d+)([+-]\d+)?(?:: (.*))?", line
            )
            if row and end is not None:
                rules = {
                    int(register): int(offset or 0)
                    for register, offset in re.findall(
                        r"reg(\d+)=\[CFA([+-]\d+)?\]", row[4] or ""
                    )
                }
                undefined = {
                    int(register)
                    for register in re.findall(
                        r"reg(\d+)=undefined", row[4] or ""
                    )
                }
                self.rows.append(
                    (
                        int(row[1], 16),
                        end,
                        int(row[2]),
                        int(row[3] or 0),
                        rules,
                        undefined,
                    )
                )
        self.rows.sort(key=lambda row: row[0])
        self.addresses = [row[0] for row in self.rows]

    def at(self, pc):
        """(CFA register, CFA offset, saved registers' offsets from the CFA,
        undefined registers), or None where there is no information."""
        index = bisect.bisect_right(self.addresses, pc) - 1
        if index < 0 or pc >= self.rows[index][1]:
            return None
        return self.rows[index][2:]
