#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the simulator's tables from the TableGen records of the TP.

usage: generate_tables.py TPInstrs.json OUTPUT-DIRECTORY

Writes into the output directory:
  InstructionEnums.inc   the enumerations
  InstructionTraits.inc  constexpr unit and latency class of each opcode
  InstructionTables.inc  names, operands and encodings, for Instructions.cpp
  InstructionBodies.inc  one Body<Opcode> per instruction: its operands
"""

import json
import os
import re
import sys

FLOAT_BASE = 32
NO_REGISTER = 64
MAX_SOURCES = 3


class DefinitionError(Exception):
    pass


def location(record):
    """Place of a record in the .td files, to list records in their order."""
    file_name, line = record["!locs"][-1].rsplit(":", 1)
    return os.path.basename(file_name), int(line)


class Operand:
    """An operand of an instruction, explicit or implicit."""

    def __init__(self, name, record, records):
        self.name = name
        self.scale = 1
        self.signed = False
        self.width = 5
        self.shift = None
        self.implicit_register = None
        self.is_destination = False
        self.tied = None
        superclasses = record["!superclasses"]
        if "RegisterClass" in superclasses:
            types = {t["def"] for t in record["RegTypes"]}
            if types not in ({"i32"}, {"f32"}):
                raise DefinitionError(f"register class of types {types}")
            self.kind = "FloatRegister" if types == {"f32"} else "IntegerRegister"
        elif "TPImmediate" in superclasses:
            self.kind = "Immediate"
            self.width = record["Bits"]
            self.signed = bool(record["IsSigned"])
            self.scale = record["Scale"]
        else:
            raise DefinitionError(f"operand ${name} of unknown class")

    @property
    def c_type(self):
        if self.kind == "FloatRegister":
            return "float"
        return "int32_t" if self.signed else "uint32_t"


def implicit_operand(register, records):
    record = records[register]
    operand = Operand.__new__(Operand)
    operand.name = register.lower()
    operand.kind = (
        "FloatRegister" if register.startswith("F") else "IntegerRegister"
    )
    number = sum(
        bit << i for i, bit in enumerate(record["HWEncoding"]) if bit == 1
    )
    operand.implicit_register = number + (
        FLOAT_BASE if operand.kind == "FloatRegister" else 0
    )
    operand.signed = False
    operand.is_destination = False
    operand.tied = None
    return operand


class Instruction:
    def __init__(self, name, record, records):
        self.name = name
        self.mnemonic = record["Mnemonic"]
        self.latency_class = record["Time"]["def"]
        self.takes_time = (
            "TPLatencyClass" in records[self.latency_class]["!superclasses"]
        )
        self.parse_encoding(record)
        outs = self.explicit(record["OutOperandList"], records)
        ins = self.explicit(record["InOperandList"], records)
        for constraint in filter(None, record["Constraints"].split(",")):
            match = re.fullmatch(r"\s*\$(\w+)\s*=\s*\$(\w+)\s*", constraint)
            if not match:
                raise DefinitionError(f"unknown constraint '{constraint}'")
            for operand in ins:
                if operand.name == match[2]:
                    operand.tied = match[1]
        for operand in outs + ins:
            self.place(operand)
        destinations = outs + [
            implicit_operand(r["def"], records) for r in record["Defs"]
        ]
        for operand in destinations:
            operand.is_destination = True
        if len(destinations) > 1:
            raise DefinitionError("more than one destination")
        self.destination = destinations[0] if destinations else None
        self.sources = [o for o in ins if o.kind != "Immediate"] + [
            implicit_operand(r["def"], records) for r in record["Uses"]
        ]
        if len(self.sources) > MAX_SOURCES:
            raise DefinitionError(f"more than {MAX_SOURCES} sources")
        self.immediates = [o for o in ins if o.kind == "Immediate"]
        if len(self.immediates) > 2:
            raise DefinitionError("more than two immediates")
        if len(self.immediates) == 2:
            second = self.immediates[1]
            if second.signed or second.width > 8 or second.scale != 1:
                raise DefinitionError("the second immediate is not a uint8_t")
        self.assembly = outs + [o for o in ins if o.tied is None]

    def explicit(self, dag, records):
        return [
            Operand(name, records[argument["def"]], records)
            for argument, name in dag["args"]
        ]

    def parse_encoding(self, record):
        self.mask = 0
        self.value = 0
        self.fields = {}
        for position, bit in enumerate(record["Inst"]):
            if bit in (0, 1):
                self.mask |= 1 << position
                self.value |= bit << position
            elif isinstance(bit, dict) and bit["kind"] == "varbit":
                self.fields.setdefault(bit["var"], []).append(
                    (position, bit["index"])
                )
            else:
                raise DefinitionError(f"bit {position} is undefined")

    def place(self, operand):
        bits = self.fields.get(operand.tied or operand.name)
        if bits is None:
            raise DefinitionError(f"operand ${operand.name} is not encoded")
        shift = bits[0][0]
        expected = [(shift + i, i) for i in range(operand.width)]
        if sorted(bits) != expected:
            raise DefinitionError(
                f"operand ${operand.name} is not one field of "
                f"{operand.width} bits"
            )
        operand.shift = shift


def check_unambiguous(instructions):
    for i, first in enumerate(instructions):
        for second in instructions[i + 1 :]:
            common = first.mask & second.mask
            if first.value & common == second.value & common:
                raise DefinitionError(
                    f"{first.name} and {second.name} share an encoding"
                )


def enumeration(name, enumerators, comment):
    lines = [f"/// {comment}", f"enum class {name} : uint8_t {{"]
    lines += [f"  {e}," for e in enumerators]
    lines += ["};", f"inline constexpr unsigned {plural(name)} = {len(enumerators)};"]
    return "\n".join(lines) + "\n"


def plural(name):
    return "Num" + name + ("es" if name.endswith("s") else "s")


def switch(function, parameter, cases, default=False):
    """A function of an enumeration; with `default`, it leaves some out."""
    lines = [f"constexpr {function} {{", f"  switch ({parameter}) {{"]
    lines += [f"  case {key}:\n    return {value};" for key, value in cases]
    if default:
        lines.append("  default:\n    break;")
    lines += ["  }", "  __builtin_unreachable();", "}"]
    return "\n".join(lines) + "\n"


def array(declaration, elements):
    return "\n".join(
        [f"{declaration} = {{"] + [f"    {e}," for e in elements] + ["};"]
    ) + "\n"


def c_bool(value):
    return "true" if value else "false"


def operand_entry(operand):
    return (
        f'{{"{operand.name}", OperandKind::{operand.kind}, '
        f"{c_bool(operand.is_destination)}, {operand.shift}, {operand.width}, "
        f"{c_bool(operand.signed)}, {operand.scale}}}"
    )


def register_expression(operand):
    """C++ for the register number of an operand in the word `Word`."""
    if operand.implicit_register is not None:
        return str(operand.implicit_register)
    base = f" + {FLOAT_BASE}" if operand.kind == "FloatRegister" else ""
    return f"field(Word, {operand.shift}, 5){base}"


def immediate_expression(operand):
    function = "signedField" if operand.signed else "field"
    scale = f" * {operand.scale}" if operand.scale != 1 else ""
    return f"{function}(Word, {operand.shift}, {operand.width}){scale}"


def extraction(instruction):
    lines = [f"case Opcode::{instruction.name}:"]
    if instruction.destination:
        lines.append(
            "  Result.Destination = destination("
            f"{register_expression(instruction.destination)});"
        )
    for i, operand in enumerate(instruction.sources):
        lines.append(f"  Result.Source[{i}] = {register_expression(operand)};")
    for member, operand in zip(
        ("Immediate", "SecondImmediate"), instruction.immediates
    ):
        lines.append(f"  Result.{member} = {immediate_expression(operand)};")
    lines.append("  break;")
    return "\n".join(lines)


def body(instruction):
    lines = [f"template <> struct Body<Opcode::{instruction.name}> {{"]
    lines.append(
        f"  static constexpr unsigned NumSources = {len(instruction.sources)};"
    )
    has_destination = instruction.destination is not None
    lines.append(
        f"  static constexpr bool HasDestination = {c_bool(has_destination)};"
    )
    if has_destination:
        lines.append(
            f"  {instruction.destination.c_type} "
            f"{instruction.destination.name} = 0;"
        )
    operands = instruction.sources + instruction.immediates
    for operand in operands:
        lines.append(f"  {operand.c_type} {operand.name};")
    lines.append(
        "  explicit Body([[maybe_unused]] const Instruction &Decoded,\n"
        "                [[maybe_unused]] const uint32_t *Registers)"
    )
    initializers = [
        f"{operand.name}(fromBits<{operand.c_type}>("
        f"Registers[Decoded.Source[{i}]]))"
        for i, operand in enumerate(instruction.sources)
    ] + [
        f"{operand.name}(Decoded.{member})"
        for member, operand in zip(
            ("Immediate", "SecondImmediate"), instruction.immediates
        )
    ]
    if initializers:
        lines.append("      : " + ",\n        ".join(initializers))
    lines.append("  {}")
    result = (
        f"toBits({instruction.destination.name})" if has_destination else "0"
    )
    lines.append(f"  uint32_t result() const {{ return {result}; }}")
    lines.append("  template <class Context> void run(Context &context);")
    lines.append("};")
    return "\n".join(lines) + "\n"


def write(directory, name, parts):
    with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
        file.write("// Generated by simulator/isa/generate_tables.py.\n")
        file.write("\n".join(parts))


def main():
    source, directory = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        records = json.load(file)

    def instances(name):
        names = records["!instanceof"][name]
        return sorted(names, key=lambda n: location(records[n]))

    instructions = []
    for name in instances("TPInst"):
        if records[name]["isCodeGenOnly"]:
            continue
        try:
            instructions.append(Instruction(name, records[name], records))
        except DefinitionError as error:
            place = records[name]["!locs"][-1]
            sys.exit(f"{place}: error: instruction {name}: {error}")
    try:
        check_unambiguous(instructions)
    except DefinitionError as error:
        sys.exit(f"{source}: error: {error}")

    units = instances("TPUnit")
    classes = instances("TPLatencyClass")
    special = sorted(
        (records[n] for n in records["!instanceof"]["TPSpecialRegister"]),
        key=lambda r: location(r),
    )
    special = [
        (sum(b << i for i, b in enumerate(r["Encoding"])), r["Name"])
        for r in special
    ]
    if [number for number, _ in special] != list(range(len(special))):
        sys.exit(f"{source}: error: special registers are not numbered 0, 1, ...")

    os.makedirs(directory, exist_ok=True)
    names = [i.name for i in instructions]
    write(directory, "InstructionEnums.inc", [
        enumeration("Opcode", names, "An instruction of the TP."),
        enumeration("Unit", units, "A type of functional unit."),
        enumeration("LatencyClass", classes,
                    "Instructions of one unit and latency."),
        enumeration("SpecialRegister", [name for _, name in special],
                    "A register that mfsr reads."),
        "/// TP_EACH_OPCODE(X) expands to X(ADD) X(SUB) ... in opcode order.",
        "#define TP_EACH_OPCODE(X) "
        + " ".join(f"X({name})" for name in names) + "\n",
    ])
    write(directory, "InstructionTraits.inc", [
        switch("bool takesTime(Opcode Op)", "Op",
               [(f"Opcode::{i.name}", c_bool(i.takes_time))
                for i in instructions]),
        switch("LatencyClass latencyClassOf(Opcode Op)", "Op",
               [(f"Opcode::{i.name}", f"LatencyClass::{i.latency_class}")
                for i in instructions if i.takes_time],
               default=True),
        switch("Unit unitOf(LatencyClass Class)", "Class",
               [(f"LatencyClass::{c}", f"Unit::{records[c]['Unit']['def']}")
                for c in classes]),
        "constexpr Unit unitOf(Opcode Op) "
        "{ return unitOf(latencyClassOf(Op)); }\n",
    ])
    # An array cannot be empty: instructions without operands have none.
    operand_arrays = [
        array(f"static constexpr OperandInfo OperandsOf{i.name}[]",
              [operand_entry(o) for o in i.assembly])
        for i in instructions if i.assembly
    ]
    write(directory, "InstructionTables.inc", operand_arrays + [
        array("static constexpr std::span<const OperandInfo> Operands[]",
              [f"OperandsOf{i.name}" if i.assembly
               else "std::span<const OperandInfo>()" for i in instructions]),
        array("static constexpr std::string_view Mnemonics[]",
              [f'"{i.mnemonic}"' for i in instructions]),
        array("static constexpr Encoding Encodings[]",
              [f"{{{i.mask:#010x}, {i.value:#010x}}}" for i in instructions]),
        array("static constexpr std::string_view UnitNames[]",
              [f'"{u}"' for u in units]),
        array("static constexpr std::string_view LatencyClassNames[]",
              [f'"{c}"' for c in classes]),
        array("static constexpr uint32_t DefaultLatencies[]",
              [records[c]["Cycles"] for c in classes]),
        array("static constexpr std::string_view SpecialRegisterNames[]",
              [f'"{name}"' for _, name in special]),
        "static void extractOperands([[maybe_unused]] uint32_t Word,\n"
        "                            Instruction &Result) {\n"
        "switch (Result.Op) {",
        *[extraction(i) for i in instructions],
        "}\n}\n",
    ])
    write(directory, "InstructionBodies.inc", [body(i) for i in instructions])


if __name__ == "__main__":
    main()
