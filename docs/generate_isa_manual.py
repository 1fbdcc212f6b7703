#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the manual of the instruction set from the TableGen records of the TP.

usage: generate_isa_manual.py TPInstrs.json TPRelocations.def OUTPUT.md
"""

import json
import os
import re
import sys

INTRODUCTION = """\
# The TP's instruction set

Made by the build from `llvm-backend/TP*.td`, the only definition of the
instruction set. What exactly each instruction computes stands in
`simulator/isa/semantics`.

A TP is a 32-bit, little-endian, in-order processor with 32 integer registers
r0 to r31 (r0 reads as zero), 32 float registers f0 to f31 and fixed 32-bit
instructions, at addresses that are multiples of 4. There are no delay slots.
Branches and jumps count from their own address. All unused fields are zero; a
word that is none of the instructions below traps, and so does the word 0.

## Assembly language

- One instruction per line; `#` starts a comment; directives are the GNU
  assembler's (`.text`, `.globl`, `.word`, `.asciz`, `.balign`, ...).
- Memory operands are `offset(base)`, `(base)` or, with an index register,
  `index(base)`.
- `%hi(symbol + 4)` is the upper half of an address, rounded so that adding the
  sign-extended lower half `%lo(symbol + 4)` gives the address.
- A branch's target is a symbol, or the distance in bytes from the branch.
  Registers' names are symbols here: `jal f1` calls the function f1.
"""


def place(record):
    """File and line of a record, to list records in their order."""
    name, line = record["!locs"][-1].rsplit(":", 1)
    return os.path.basename(name), int(line)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    lines += [
        "| " + " | ".join(str(c).replace("|", "\\|") for c in row) + " |"
        for row in rows
    ]
    return "\n".join(lines) + "\n"


def syntax(assembly):
    """Operands as a reader writes them: `$rd, ${imm}(${rs})`."""
    parts = re.split(r"\s", assembly, maxsplit=1)
    operands = parts[1] if len(parts) > 1 else ""
    return parts[0], re.sub(r"\$\{?(\w+)\}?", r"\1", operands)


def fields(record):
    """Fields of an instruction's word from bit 31 down: (text, width)."""
    result = []
    for position in range(31, -1, -1):
        bit = record["Inst"][position]
        starts = position in (31, 25)
        if isinstance(bit, dict):
            if result and result[-1][0] == bit["var"] and not starts:
                result[-1][1] += 1
            else:
                result.append([bit["var"], 1])
        else:
            starts = starts or position in (20, 15, 10, 5)
            text = result[-1][0] if result else ""
            if not starts and text and set(text) <= {"0", "1"}:
                result[-1][0] += str(bit)
                result[-1][1] += 1
            else:
                result.append([str(bit), 1])
    return [(text, width) for text, width in result]


def format_of(record):
    """The diagram's cells of an instruction's format."""
    cells = []
    high = 31
    for text, width in fields(record):
        name = text
        if set(text) <= {"0", "1"}:
            name = "0"
            if high == 31:
                name = "opcode"
            elif high == 5 and "FormatR" in record["!superclasses"]:
                name = "funct"
        if cells and name == "0" and cells[-1][0] == "0":
            cells[-1] = ("0", cells[-1][1] + width)
        else:
            cells.append((name, width))
        high -= width
    return tuple(cells)


def diagram(cells):
    """A row of boxes, with the bit positions of each above it."""
    positions, boxes = "", ""
    high = 31
    for name, width in cells:
        low = high - width + 1
        size = max(len(name) + 2, 6 if width < 10 else 16)
        positions += " " + str(high) + str(low).rjust(size - len(str(high)))
        boxes += "|" + name.center(size)
        high = low - 1
    edge = re.sub(r"[^|]", "-", boxes).replace("|", "+") + "+"
    return "\n".join([positions, edge, boxes + "|", edge])


class Manual:
    def __init__(self, records):
        self.records = records
        self.instructions = [
            i for i in self.instances("TPInst") if not i["isCodeGenOnly"]
        ]

    def instances(self, name):
        found = [self.records[n] for n in self.records["!instanceof"][name]]
        return sorted(found, key=place)

    def latency_class(self, instruction):
        """The latency class of an instruction; None if it takes no time."""
        time = self.records[instruction["Time"]["def"]]
        return time if "TPLatencyClass" in time["!superclasses"] else None

    def formats(self):
        groups = {}
        for instruction in self.instructions:
            groups.setdefault(format_of(instruction), []).append(instruction)
        text = "## Formats\n"
        for cells, members in groups.items():
            names = ", ".join(f"`{m['Mnemonic']}`" for m in members)
            text += f"\n{names}\n\n```\n{diagram(cells)}\n```\n"
        return text

    def unit_tables(self):
        text = (
            "## Instructions by functional unit\n\n"
            "The TPs of a multiprocessor share its functional units. Cycles "
            "are from issue until the result can be used.\n"
        )
        for unit in self.instances("TPUnit"):
            rows = []
            for instruction in self.instructions:
                latency = self.latency_class(instruction)
                if latency and latency["Unit"]["def"] == unit["!name"]:
                    rows.append(self.row(instruction, latency["Cycles"]))
            title = f"{unit['!name']}: {unit['Meaning']}"
            text += self.instruction_table(title, rows)
        timeless = [
            self.row(instruction, 0)
            for instruction in self.instructions
            if not self.latency_class(instruction)
        ]
        title = "Messages to the observer of the run, without a unit"
        return text + self.instruction_table(title, timeless)

    def row(self, instruction, cycles):
        mnemonic, operands = syntax(instruction["AsmString"])
        word = " ".join(name for name, _ in fields(instruction))
        return (
            f"`{mnemonic}`",
            f"`{operands}`" if operands else "",
            self.float_operands(instruction),
            instruction["Action"],
            cycles,
            f"`{word}`",
        )

    @staticmethod
    def instruction_table(title, rows):
        columns = (
            "Instruction",
            "Operands",
            "Float registers",
            "Action",
            "Cycles",
            "Encoding",
        )
        return f"\n### {title}\n\n" + table(columns, rows)

    @staticmethod
    def float_operands(instruction):
        shown = syntax(instruction["AsmString"])[1]
        return ", ".join(
            f"`{name}`"
            for operands in ("OutOperandList", "InOperandList")
            for argument, name in instruction[operands]["args"]
            if argument["def"] == "FPR" and re.search(rf"\b{name}\b", shown)
        )

    def operands(self):
        rows = []
        for operand in self.instances("TPImmediate"):
            limit = 1 << operand["Bits"] - operand["IsSigned"]
            low = -limit if operand["IsSigned"] else 0
            scale = operand["Scale"]
            users = [
                i["Mnemonic"]
                for i in self.instructions
                if any(
                    a[0]["def"] == operand["!name"]
                    for a in i["InOperandList"]["args"]
                )
            ]
            if users:
                rows.append(
                    (
                        ", ".join(f"`{u}`" for u in users),
                        operand["Bits"],
                        f"{low * scale} to {(limit - 1) * scale}",
                        scale,
                    )
                )
        return (
            "## Immediates\n\nThe value is the field, times the scale.\n\n"
            + table(("Instructions", "Bits", "Values", "Scale"), rows)
        )

    def latency_classes(self):
        rows = [
            (c["!name"], c["Unit"]["def"], c["Cycles"], c["Source"])
            for c in self.instances("TPLatencyClass")
        ]
        return (
            "## Latency classes\n\nDefaults; a chip file may override them.\n\n"
            + table(("Class", "Unit", "Cycles", "Source"), rows)
        )

    def special_registers(self):
        rows = [
            (
                sum(bit << i for i, bit in enumerate(r["Encoding"])),
                f"`{r['Name']}`",
                r["Meaning"],
            )
            for r in self.instances("TPSpecialRegister")
        ]
        return "## Special registers\n\nRead by `mfsr`.\n\n" + table(
            ("Number", "Name", "Meaning"), rows
        )

    def registers(self):
        rows = [
            (f"`{r['AsmName']}`", ", ".join(f"`{n}`" for n in r["AltNames"]))
            for r in self.instances("TPReg")
            if r["AltNames"]
        ]
        return "## Registers with another name\n\n" + table(
            ("Register", "Name"), rows
        )

    def aliases(self):
        rows = []
        for alias in self.instances("InstAlias"):
            rows.append((self.statement(alias), self.meaning(alias)))
        for macro in self.instances("TPMacro"):
            rows.append((self.statement(macro), macro["Action"]))
        return "## Aliases and macros\n\n" + table(("Written", "Means"), rows)

    @staticmethod
    def statement(record):
        mnemonic, operands = syntax(record["AsmString"])
        return f"`{mnemonic} {operands}`" if operands else f"`{mnemonic}`"

    def meaning(self, alias):
        """The instruction that an alias makes, as it would be written."""
        dag = alias["ResultInst"]
        instruction = self.records[dag["operator"]["def"]]
        names = [
            name
            for operands in ("OutOperandList", "InOperandList")
            for _, name in instruction[operands]["args"]
        ]
        values = {}
        for name, (argument, own_name) in zip(names, dag["args"]):
            if own_name:
                values[name] = own_name
            elif isinstance(argument, dict):
                values[name] = argument["def"].lower()
            else:
                values[name] = str(argument)
        mnemonic, _ = syntax(instruction["AsmString"])
        text = re.sub(
            r"\$\{?(\w+)\}?",
            lambda match: values[match[1]],
            instruction["AsmString"].partition("\t")[2],
        )
        return f"`{mnemonic} {text}`"

    def features(self):
        rows = [
            (f"`{f['Name']}`", f["Desc"])
            for f in self.instances("SubtargetFeature")
        ]
        return "## Chip features\n\n" + table(("Feature", "Meaning"), rows)


def relocations(path):
    """Table of the relocations: each has its rule in the comment above it."""
    rows, comment = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            match = re.match(r"TP_RELOC\((\w+), (\d+)\)", line)
            if match:
                rows.append((match[2], f"`{match[1]}`", " ".join(comment)))
            is_comment = line.startswith("// ")
            comment = comment + [line[3:].strip()] if is_comment else []
    return (
        "## Relocations\n\nS: the symbol's value; A: the addend; P: the "
        "address of the place.\n\n" + table(("Type", "Name", "Writes"), rows)
    )


def main():
    source, relocation_source, output = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        manual = Manual(json.load(file))
    sections = [
        INTRODUCTION,
        manual.registers(),
        manual.formats(),
        manual.operands(),
        manual.unit_tables(),
        manual.special_registers(),
        manual.aliases(),
        manual.latency_classes(),
        manual.features(),
        relocations(relocation_source),
    ]
    with open(output, "w", encoding="utf-8") as file:
        file.write("\n".join(sections))


if __name__ == "__main__":
    main()
