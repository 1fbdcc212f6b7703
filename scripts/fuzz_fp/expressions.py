# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random floating-point expressions, as trees that print as C++."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Expression:
    """A template whose {0}, {1}, ... are the operands.

    In a template @ is the suffix of the type in names and literals: sqrt@ is
    sqrtf or sqrt, 0.5@ is 0.5f or 0.5.
    """

    template: str
    operands: tuple = ()

    def text(self):
        return self.template.format(*(o.text() for o in self.operands))

    def with_operand(self, position, operand):
        operands = list(self.operands)
        operands[position] = operand
        return Expression(self.template, tuple(operands))


SCALARS = ("a", "b", "c", "d")
MEMBERS = ("s.x", "s.y", "s.z")
ELEMENTS = ("p[0]", "p[1]", "p[2]", "p[3]", "q[0]", "q[1]")
LITERALS = (
    "0.5@", "2.0@", "3.0@", "0.1@", "1.0@", "-1.0@", "7.0@", "0.25@",
    "1.7@", "100.0@", "0.3@", "1.0e-3@",
)

# Weights and templates. An operand that occurs twice is a shared subexpression.
OPERATIONS = (
    (10, "({0} + {1})"),
    (8, "({0} - {1})"),
    (10, "({0} * {1})"),
    (7, "({0} / {1})"),
    (4, "({0} / {1} / {2})"),
    (2, "({0} / {1} / {2} / {3})"),
    (3, "({0} * {1} / {2})"),
    (3, "({0} * {1} * {2} * {3})"),
    (2, "({0} * {0})"),
    (2, "({0} * {0} * {0})"),
    (3, "({0} * {0} * {0} * {0})"),
    (1, "({0} * {0} * {0} * {0} * {0} * {0})"),
    (4, "({0} * {1} - {2} * {3})"),
    (4, "({0} * {1} + {2} * {3})"),
    (2, "({0} * {2} + {1} * {2})"),
    (2, "({0} * {2} - {2} * {1})"),
    (3, "({0} * {1} + {2})"),
    (2, "({2} - {0} * {1})"),
    (3, "({0} + {1} + {2} + {3})"),
    (2, "(({0} + {1}) - {0})"),
    (2, "({0} + ({1} - {0}) * {2})"),
    (2, "(({0} - {1}) / ({2} - {1}))"),
    (2, "({0} / {2} + {1} / {2})"),
    (2, "({0} / {1} - {2} / {3})"),
    (2, "(1.0@ / {0})"),
    (2, "(2.0@ * {0} / 3.0@)"),
    (2, "sqrt@(fabs@({0}))"),
    (1, "sqrt@({0})"),
    (2, "(1.0@ / sqrt@(fabs@({0})))"),
    (1, "(1.0@ / sqrt@({0}))"),
    (2, "({0} / sqrt@({0} * {0} + {1} * {1}))"),
    (1, "(sqrt@({0}) * sqrt@({0}))"),
    (1, "(sqrt@({0}) * sqrt@({1}))"),
    (2, "pow@({0}, {power})"),
    (3, "fmin@({0}, {1})"),
    (3, "fmax@({0}, {1})"),
    (2, "fmin@(fmax@({0}, 0.0@), 1.0@)"),
    (3, "fabs@({0})"),
    (3, "(- {0})"),
    (1, "({0} - - {1})"),
    (2, "(- {0} * {1} + {2})"),
    (2, "({0} < {1} ? {2} : {3})"),
    (2, "({0} < {1} ? {0} : {1})"),
    (1, "({0} >= {1} ? {2} / {1} : {2} / {0})"),
    (1, "({0} * {1} - {1} * {0} > 0.0@ ? {0} : {1})"),
    (1, "({0} == {1} ? {2} : {0} - {1})"),
    (2, "(Real)(int)({0})"),
    (1, "(Real)(int)(16.0@ * ({0} / {1}))"),
    (1, "({0} - (Real)(int)({0}))"),
    (1, "floor@({0})"),
    (1, "({0} - floor@({0}))"),
    (1, "({0} < 0.0@ ? - {0} : {0})"),
    (1, "({0} < {1} && {2} / {1} > 1.0@ ? {2} : {3})"),
    (1, "(Real)((double){0} * {1})"),
    (1, "(Real)((float){0} / (float){1})"),
    (1, "((Real)(n * 3) * {0})"),
    # Of the library, which is another one natively.
    (1, "sin@({0})"),
    (1, "exp@({0})"),
    (1, "log@(fabs@({0}))"),
    (1, "pow@(fabs@({0}), {1})"),
    (1, "pow@({0}, 2.2@)"),
    # Inline functions.
    (2, "dot(s, Vector<Real>{{{0}, {1}, {2}}})"),
    (2, "length(Vector<Real>{{{0}, {1}, {2}}})"),
    (1, "(s * Real({0}) + Vector<Real>{{{1}, {2}, {0}}} * Real({1})).y"),
    (2, "normalize(Vector<Real>{{{0}, {1}, {2}}}).z"),
    (2, "mix<Real>({0}, {1}, {2})"),
    (1, "(({0} * 0.3@ + 1.7@) * {0} + 0.25@)"),
    (1, "((({0} * {1} + {2}) * {1} + {3}) * {1} + {0})"),
)
# Powers that are multiplications and square roots.
POWERS = (
    "2.0@", "3.0@", "4.0@", "5.0@", "0.5@", "1.5@", "-1.0@", "-2.0@", "0.25@",
    "-0.5@", "2.5@", "1.0@",
)


def operand_count(template):
    return sum("{%d}" % i in template for i in range(4))


class ExpressionMaker:
    """Makes random expressions over names in scope."""

    def __init__(self, random):
        self.random = random
        self.names = []

    def leaf(self):
        kind = self.random.random()
        if kind < 0.12:
            return Expression(self.random.choice(LITERALS))
        if self.names and kind < 0.35:
            return Expression(self.random.choice(self.names))
        if kind < 0.70:
            return Expression(self.random.choice(SCALARS))
        if kind < 0.85:
            return Expression(self.random.choice(MEMBERS))
        return Expression(self.random.choice(ELEMENTS))

    def make(self, depth):
        if depth == 0 or self.random.random() < 0.12:
            return self.leaf()
        template = self.random.choices(
            [operation[1] for operation in OPERATIONS],
            [operation[0] for operation in OPERATIONS],
        )[0]
        template = template.replace("{power}", self.random.choice(POWERS))
        return Expression(
            template,
            tuple(
                self.make(depth - 1) for _ in range(operand_count(template))
            ),
        )


def simpler(expression):
    """Expressions that are one step simpler, the simplest first."""
    for operand in expression.operands:
        yield operand
    if expression.operands:
        yield Expression("a")
    for position, operand in enumerate(expression.operands):
        for replacement in simpler(operand):
            yield expression.with_operand(position, replacement)
