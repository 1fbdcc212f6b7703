# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Puts a whole program together."""

import random

from cxx import declarations
from cxx.classes import Hierarchy
from cxx.expressions import Expressions
from cxx.functions import Functions
from cxx.scope import Scope, Variable
from cxx.statements import Statements
from cxx.types import (
    Array, BOOLEAN, DOUBLE, Enumeration, FLOAT, Floating, HALF, INTEGERS,
    Structure, Vector, bit_integer, triple_types, vector_types,
)

CLANG_ONLY = "// clang only"
MOST_COST_OF_MAIN = 400_000

PICK = """static uint32_t pickState = 1;
static NOINLINE uint32_t pick(uint32_t Count) {
  pickState = pickState * 1664525 + 1013904223;
  return (pickState >> 16) % Count;
}"""


class Program:
    """A program of a seed."""

    def __init__(self, seed):
        self.generator = random.Random(f"program {seed}")
        # Every fourth has what only clang knows.
        self.is_for_clang = seed % 4 == 3
        self.lines = [CLANG_ONLY] if self.is_for_clang else []
        self.lines += ['#include "fuzz.h"', ""]
        self.bit_integers = []
        self.enumerations = []
        self.structures = []
        self.vectors = []
        self.make_types()
        self.types = self.chosen_types()
        self.expressions = Expressions(self.generator, self.vectors,
                                       self.enumerations, self.bit_integers)
        self.statements = Statements(self.generator, self.expressions,
                                     self.types)
        self.globals = []
        self.make_globals()
        self.make_functions()

    def text(self):
        return "\n".join(self.lines) + "\n"

    def make_types(self):
        if self.is_for_clang:
            self.make_bit_integers()
        chosen = self.generator.sample(vector_types(), 4)
        # Conversions between vectors need another of as many elements.
        for kind, text in vector_types():
            if any(kind.count == other.count for other, _ in chosen):
                self.vectors.append(kind)
                self.lines += [text, declarations.checksum(kind)]
        for kind, text in triple_types() if self.is_for_clang else ():
            self.vectors.append(kind)
            self.lines += [text, declarations.checksum(kind)]
        for number in range(self.generator.randint(1, 3)):
            kind, text = declarations.enumeration(self.generator, number)
            self.enumerations.append(kind)
            self.lines += [text, declarations.checksum(kind)]
        for number in range(self.generator.randint(3, 8)):
            if self.generator.random() < 0.15:
                kind, text = declarations.union(self.generator, number,
                                                self.enumerations)
            else:
                kind, text = declarations.structure(
                    self.generator, number, self.structures,
                    self.enumerations, self.vectors)
            self.structures.append(kind)
            self.lines += [text, declarations.checksum(kind)]
            self.lines += self.maker(kind)

    def make_bit_integers(self):
        for _ in range(self.generator.randint(1, 3)):
            bits = self.generator.choice((5, 7, 13, 24, 33, 48, 63, 65, 96, 100,
                                          128))
            kind, text = bit_integer(bits, self.generator.random() < 0.5)
            if all(kind.name != other.name for other in self.bit_integers):
                self.bit_integers.append(kind)
                self.lines += [text, declarations.checksum(kind)]

    def chosen_types(self):
        """What variables, parameters and results have: each program prefers
        some."""
        scalars = INTEGERS + [BOOLEAN, FLOAT, DOUBLE, HALF]
        favourites = self.generator.sample(scalars, 5)
        return (scalars + favourites * 3 + [FLOAT] * 2 + self.enumerations
                + self.structures * 2 + self.bit_integers * 4
                + self.generator.sample(self.vectors, 2))

    @staticmethod
    def value(kind):
        """An expression of the variable Seed."""
        if isinstance(kind, Structure):
            return f"make{kind.name}(Seed)"
        if isinstance(kind, Floating):
            return f"({kind.name})(int32_t)(Seed >> 32) / 16"
        if kind is HALF:
            return "half((float)(int16_t)(Seed >> 32) / 8)"
        if isinstance(kind, Enumeration):
            return f"({kind.name})({kind.underlying.name})(Seed >> 32)"
        return f"({kind.name})(Seed >> 32)"

    def maker(self, kind):
        """The function make<Type>(), whose argument decides the fields."""
        step = "Seed = Seed * 6364136223846793005 + 1442695040888963407;"
        lines = [f"[[maybe_unused]] static {kind.name} "
                 f"make{kind.name}(uint64_t Seed) {{", f"  {kind.name} Value;"]
        for field in kind.fields[:1] if kind.is_union else kind.fields:
            place, element, indent = f"Value.{field.name}", field.type, "  "
            lines.append(f"  {step}")
            if isinstance(element, Array):
                lines.append(f"  for (int I = 0; I != {element.count}; ++I) {{")
                lines.append(f"    {step}")
                place, element, indent = f"{place}[I]", element.element, "    "
            if isinstance(element, Vector):
                lines += [f"{indent}for (int J = 0; J != {element.count}; ++J)",
                          f"{indent}  {place}[J] = "
                          f"{self.value(element.element)} + J;"]
            else:
                lines.append(f"{indent}{place} = {self.value(element)};")
            if isinstance(field.type, Array):
                lines.append("  }")
        return lines + ["  return Value;", "}"]

    def make_globals(self):
        for bits in (8, 16, 32, 64):
            self.lines.append(f"static uint{bits}_t atomic{bits} = {bits};")
        for number in range(self.generator.randint(6, 14)):
            kind = self.generator.choice(self.types)
            name = f"g{number}"
            if self.generator.random() < 0.25:
                count = self.generator.randint(1, 9)
                values = ", ".join(self.expressions.constant(kind)
                                   for _ in range(count))
                text = f"{name}[{count}] = {{{values}}}"
                array = Array("", kind, count)
            else:
                text = f"{name} = {self.expressions.constant(kind)}"
                array = kind
            is_constant = self.generator.random() < 0.1
            prefix = self.generator.choice(("", "static ", "static "))
            if is_constant:
                prefix = "static const "
            self.lines.append(f"{prefix}{kind.name} {text};")
            self.globals.append(Variable(name, array, not is_constant))
        self.statements.global_names = frozenset(
            v.text for v in self.globals if v.is_writable)

    def make_functions(self):
        functions = Functions(self.generator, self.statements, self.types,
                              self.globals)
        callable_functions = []
        for number in range(self.generator.randint(2, 6)):
            made, lines = functions.make(f"f{number}", callable_functions)
            callable_functions += made
            self.lines += lines
        self.lines.append(PICK)
        hierarchy = Hierarchy(self.generator, functions,
                              list(callable_functions))
        self.lines += hierarchy.lines(self.generator.choice((0, 3, 4, 6)))
        made, lines = hierarchy.objects()
        callable_functions += made
        self.lines += lines
        for number in range(10, 10 + self.generator.randint(2, 6)):
            made, lines = functions.make(f"f{number}", callable_functions)
            callable_functions += made
            self.lines += lines
        self.make_main(callable_functions)

    def make_main(self, functions):
        lines = []
        for kind in self.structures:
            lines += declarations.layout_check(kind)
        lines.append("  report(Total);")
        cost = 0
        self.statements.allows_effects = True
        for number, function in enumerate(functions):
            turns = self.generator.randint(1, 6)
            turns = max(1, min(turns, MOST_COST_OF_MAIN // 20 // function.cost))
            cost += function.cost * turns
            if cost > MOST_COST_OF_MAIN:
                break
            scope = Scope(self.globals)
            scope.variables.append(Variable("I", INTEGERS[5], False))
            arguments = [self.statements.expression(p, scope, 3)
                         for p in function.parameters]
            lines += [
                f"  for (uint32_t I = 0; I != {turns}; ++I)",
                f"    mix(Total, {function.call_text(arguments)});",
            ]
            if number % 3 == 2:
                lines.append("  report(Total);")
        for variable in self.globals:
            if isinstance(variable.type, Array):
                lines.append(f"  for (auto &Element : {variable.text}) "
                             "mix(Total, Element);")
            else:
                lines.append(f"  mix(Total, {variable.text});")
        for bits in (8, 16, 32, 64):
            lines.append(f"  mix(Total, atomic{bits});")
        self.lines += ["int main() {", *lines, "  report(Total);",
                       "  return 0;", "}"]


def program(seed):
    return Program(seed).text()
