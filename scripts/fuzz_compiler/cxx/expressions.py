# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random expressions without effects, one method per kind of type."""

from cxx import literals
from cxx.scope import parts
from cxx.types import (
    BOOLEAN, BitInteger, Boolean, DOUBLE, Enumeration, FLOAT, Floating, HALF,
    Half, INTEGERS, Integer, Structure, UINT32, UINT64, Vector,
)

COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")


class Expressions:
    """Makes expressions of a wanted type from what a scope offers. Calls are
    made while the budget lasts; spent says what they cost."""

    def __init__(self, generator, vectors, enumerations, bit_integers):
        self.generator = generator
        self.bit_integers = bit_integers
        self.vectors = vectors
        self.enumerations = enumerations
        self.budget = 0
        self.spent = 0

    def make(self, kind, scope, depth):
        """An expression of the type."""
        if depth <= 0 or self.chance(0.15):
            return self.leaf(kind, scope)
        if self.chance(0.1):
            call = self.call(kind, scope, depth)
            if call:
                return call
        if self.chance(0.08) and not isinstance(kind, Structure):
            return (f"({self.make(BOOLEAN, scope, depth - 1)} ? "
                    f"{self.make(kind, scope, depth - 1)} : "
                    f"{self.make(kind, scope, depth - 1)})")
        method = {
            Integer: self.integer, BitInteger: self.bit_integer,
            Boolean: self.boolean,
            Floating: self.floating, Half: self.half,
            Enumeration: self.enumeration, Vector: self.vector,
            Structure: self.structure,
        }[type(kind)]
        return method(kind, scope, depth)

    def chance(self, probability):
        return self.generator.random() < probability

    def choice(self, things):
        return self.generator.choice(things)

    def index(self, scope, count):
        if count == 1:
            return "0"
        if self.chance(0.5):
            return str(self.generator.randrange(count))
        return f"(uint32_t){self.simple_integer(scope)} % {count}"

    def simple_integer(self, scope):
        """A variable or a constant."""
        names = [v.text for v in scope.all_variables()
                 if isinstance(v.type, Integer)]
        return self.choice(names) if names else "3"

    def lvalues(self, scope, wanted):
        """The parts of variables for which wanted() holds."""
        result = []
        for variable in scope.all_variables():
            result += [
                part for part in parts(
                    variable, lambda count: self.index(scope, count))
                if wanted(part)
            ]
        return result

    def leaf(self, kind, scope):
        found = self.lvalues(scope, lambda v: v.type == kind)
        if found and self.chance(0.75):
            return self.choice(found).text
        return self.constant(kind)

    def constant(self, kind):
        if isinstance(kind, Integer):
            bits = min(kind.bits, 64)
            value = literals.integer(self.generator, bits, kind.signed)
            text = literals.integer_text(value, bits, kind.signed)
            if kind.bits > 64 and self.chance(0.5):
                shift = self.generator.randrange(kind.bits - 1)
                return f"({kind.name})(({kind.wide}){text} << {shift})"
            return f"({kind.name}){text}"
        if isinstance(kind, Boolean):
            return self.choice(("true", "false"))
        if isinstance(kind, Floating):
            return literals.floating(self.generator, kind.bits, kind.suffix)
        if isinstance(kind, Half):
            return f"half({literals.floating(self.generator, 32, 'f')})"
        if isinstance(kind, Enumeration):
            return self.choice(kind.constants)
        if isinstance(kind, Vector):
            return self.elements(kind, lambda: self.constant(kind.element))
        seed = literals.integer(self.generator, 64, False)
        return f"make{kind.name}({seed}ull)"

    def elements(self, kind, make):
        body = ", ".join(make() for _ in range(kind.count))
        return f"({kind.name}{{{body}}})"

    def call(self, kind, scope, depth):
        """A call of a function without effects, if there is one."""
        found = [f for f in scope.all_functions()
                 if f.is_pure and f.result == kind and f.cost <= self.budget]
        if not found:
            return None
        function = self.choice(found)
        self.budget -= function.cost
        self.spent += function.cost
        return function.call_text(
            [self.make(p, scope, depth - 2) for p in function.parameters])

    def integer(self, kind, scope, depth):
        method = self.choice(
            [self.arithmetic] * 5 + [self.bitwise] * 2 + [self.shift] * 2
            + [self.conversion] * 2
            + [self.division, self.bounded, self.counting, self.from_other,
               self.from_vector, self.overflowing, self.selection]
        )
        return method(kind, scope, depth - 1)

    def bit_integer(self, kind, scope, depth):
        method = self.choice(
            [self.arithmetic] * 4 + [self.bitwise] * 2 + [self.shift] * 2
            + [self.conversion] * 2
            + [self.division, self.bounded, self.selection])
        return method(kind, scope, depth - 1)

    def arithmetic(self, kind, scope, depth):
        left, right = (self.make(kind, scope, depth) for _ in range(2))
        operator = self.choice("++--*")
        return (f"({kind.name})(({kind.wide})({left}) {operator} "
                f"({kind.wide})({right}))")

    def bitwise(self, kind, scope, depth):
        left, right = (self.make(kind, scope, depth) for _ in range(2))
        if self.chance(0.2):
            return f"({kind.name})~({left})"
        return f"({kind.name})(({left}) {self.choice('&|^')} ({right}))"

    def shift(self, kind, scope, depth):
        value = self.make(kind, scope, depth)
        amount = f"(({self.make(UINT32, scope, depth)}) % {kind.bits})"
        if self.chance(0.5):
            amount = str(self.generator.randrange(kind.bits))
        if self.chance(0.5):
            return f"({kind.name})(({kind.wide})({value}) << {amount})"
        # A bit-field may be promoted to int, which is shorter than its type.
        return f"({kind.name})(({kind.name})({value}) >> {amount})"

    def conversion(self, kind, scope, depth):
        other = self.choice(INTEGERS + [BOOLEAN] + self.enumerations
                            + self.bit_integers * 2)
        return f"({kind.name})({self.make(other, scope, depth)})"

    def division(self, kind, scope, depth):
        name = self.choice(("divide", "remainderOf"))
        if self.chance(0.5):
            divisor = self.choice((2, 3, 5, 7, 8, 10, 16, 60, 100, 127))
            operator = self.choice("/%")
            value = self.make(kind, scope, depth)
            return f"({kind.name})(({value}) {operator} {divisor})"
        return (f"{name}<{kind.name}>({self.make(kind, scope, depth)}, "
                f"{self.make(kind, scope, depth)})")

    def bounded(self, kind, scope, depth):
        """Signed arithmetic that cannot overflow, and so may be changed."""
        left, right = (self.make(kind, scope, depth) for _ in range(2))
        limit = "3"
        if not isinstance(kind, BitInteger):
            limit = {8: "11", 16: "180", 32: "46000",
                     64: "3000000000ll"}[kind.bits]
        return (f"({kind.name})((({left}) % {limit}) {self.choice('+-*')} "
                f"(({right}) % {limit}))")

    def counting(self, kind, scope, depth):
        wide = self.choice((UINT32, UINT64))
        value = f"({wide.name})({self.make(wide, scope, depth)})"
        long = "" if wide is UINT32 else "ll"
        function = self.choice((
            "leadingZeros", "trailingZeros", f"__builtin_popcount{long}",
            f"__builtin_parity{long}", f"__builtin_bswap{wide.bits}",
        ))
        return f"({kind.name}){function}({value})"

    def from_other(self, kind, scope, depth):
        """Of a floating-point number: its value or its bits."""
        other = self.choice((FLOAT, DOUBLE))
        value = self.make(other, scope, depth)
        if self.chance(0.3):
            return f"({kind.name})bits({value})"
        return f"toInteger<{kind.name}>({value})"

    def from_vector(self, kind, scope, depth):
        vector = self.choice(self.vectors)
        value = self.make(vector, scope, min(depth, 1))
        place = self.index(scope, vector.count)
        element = f"{value}[{place}]"
        if isinstance(vector.element, Floating):
            return f"toInteger<{kind.name}>({element})"
        return f"({kind.name}){element}"

    def overflowing(self, kind, scope, depth):
        name = self.choice(("saturatingAdd", "saturatingSub", "saturatingMul"))
        return (f"{name}<{kind.name}>({self.make(kind, scope, depth)}, "
                f"{self.make(kind, scope, depth)})")

    def selection(self, kind, scope, depth):
        """min, max, absolute value, clamping."""
        left, right = (self.leaf(kind, scope) for _ in range(2))
        operator = self.choice(COMPARISONS)
        if self.chance(0.3):
            return (f"({kind.name})({left} < 0 ? ({kind.name})(0 - "
                    f"({kind.wide}){left}) : {left})")
        return (f"(({left}) {operator} ({right}) ? ({left}) : "
                f"{self.make(kind, scope, depth)})")

    def boolean(self, kind, scope, depth):
        depth -= 1
        method = self.generator.randrange(6)
        if method == 0:
            return (f"({self.make(kind, scope, depth)} "
                    f"{self.choice(('&&', '||', '!=', '=='))} "
                    f"{self.make(kind, scope, depth)})")
        if method == 1:
            return f"!({self.make(kind, scope, depth)})"
        if method == 2:
            integer = self.choice(INTEGERS)
            return f"((bool)({self.make(integer, scope, depth)}))"
        other = self.choice(INTEGERS * 2 + [FLOAT, FLOAT, DOUBLE])
        left, right = (self.make(other, scope, depth) for _ in range(2))
        if isinstance(other, Floating) and self.chance(0.3):
            name = self.choice(("isless", "isgreaterequal", "isunordered",
                                "islessgreater"))
            return f"(bool)__builtin_{name}({left}, {right})"
        return f"(({left}) {self.choice(COMPARISONS)} ({right}))"

    def floating(self, kind, scope, depth):
        depth -= 1
        method = self.generator.randrange(10)
        value = self.make(kind, scope, depth)
        if method < 4:
            other = self.make(kind, scope, depth)
            return f"(({value}) {self.choice('+-*/+*')} ({other}))"
        if method == 4:
            function = self.choice(("fabs", "sqrt"))
            return f"__builtin_{function}{kind.suffix}({value})"
        if method == 5:
            other = self.choice(
                (FLOAT, DOUBLE, BOOLEAN, HALF) + tuple(INTEGERS))
            return f"(({kind.name})({self.make(other, scope, depth)}))"
        if method == 6:
            word = UINT32 if kind.bits == 32 else UINT64
            return f"fromBits(({word.name}){self.make(word, scope, depth)})"
        if method == 7:
            other = self.leaf(kind, scope)
            operator = self.choice(("<", ">", "<=", ">="))
            return f"({other} {operator} ({value}) ? {other} : ({value}))"
        if method == 8:
            return f"copySign<{kind.name}>({value}, {self.leaf(kind, scope)})"
        return f"(-({value}))"

    def half(self, kind, scope, depth):
        other = self.choice((FLOAT, FLOAT, DOUBLE))
        if self.chance(0.5):
            left, right = (self.make(kind, scope, depth - 1) for _ in range(2))
            return (f"half((float)({left}) {self.choice('+-*/')} "
                    f"(float)({right}))")
        return f"half({self.make(other, scope, depth - 1)})"

    def enumeration(self, kind, scope, depth):
        value = self.make(kind.underlying, scope, depth - 1)
        return f"(({kind.name})({value}))"

    def vector(self, kind, scope, depth):
        depth = min(depth - 1, 2)
        left, right = (self.make(kind, scope, depth) for _ in range(2))
        method = self.generator.randrange(6)
        if method == 0:
            return self.elements(
                kind, lambda: self.make(kind.element, scope, depth - 1))
        if method == 1:
            order = ", ".join(str(self.generator.randrange(kind.count * 2))
                              for _ in range(kind.count))
            return f"__builtin_shufflevector({left}, {right}, {order})"
        if method == 2:
            operator = self.choice(COMPARISONS)
            other = self.leaf(kind, scope)
            # Without the casts one could be const and the other not.
            return (f"(({left} {operator} {right}) ? ({kind.name}){other} : "
                    f"({kind.name}){right})")
        if method == 3:
            return self.vector_conversion(kind, scope, depth)
        if isinstance(kind.element, Floating):
            return f"({left} {self.choice('+-*/')} {right})"
        if method == 4:
            mask = kind.element.bits - 1
            return f"({left} {self.choice(('<<', '>>'))} ({right} & {mask}))"
        return f"({left} {self.choice('+-*&|^')} {right})"

    def vector_conversion(self, kind, scope, depth):
        """From a vector of as many numbers; integers to floating point, but
        not back, where only some values are defined."""
        allowed = [
            v for v in self.vectors
            if v.count == kind.count and v != kind
            and (isinstance(kind.element, Floating)
                 or isinstance(v.element, Integer))
        ]
        other = self.make(self.choice(allowed), scope, depth)
        return f"__builtin_convertvector({other}, {kind.name})"

    def structure(self, kind, scope, depth):
        return self.leaf(kind, scope)
