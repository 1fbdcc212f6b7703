# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random functions: expressions, variables, loops and the memory between."""

import dataclasses
import random
import re

from expressions import ExpressionMaker, operand_count, simpler

# What may stand before the statements.
PRAGMAS = (
    "contract(off)", "contract(on)", "contract(fast)", "reassociate(off)",
    "reassociate(on)", "reciprocal(off)", "reciprocal(on)",
)

# A loop: its lines, whose {0} and {1} are expressions before the loop. The
# result is the variable %.
LOOPS = (
    # Sums and products.
    "Real % = 0.0@; for (int i = 0; i < n; ++i) % += p[i];",
    "Real % = {0}; for (int i = 0; i < n; ++i) % += p[i] * {1};",
    "Real % = 1.0@; for (int i = 0; i < 6; ++i) % *= p[i];",
    "Real % = 0.0@; for (int i = 0; i < 8; ++i) % += p[i] * q[i];",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) % += p[i] * q[i];",
    "Real % = 0.0@; for (int i = 0; i < 8; ++i) % += p[i] * p[i];",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) "
    "{{ Real t = p[i] - {0}; % += t * t; }}",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) % += p[i] / {0};",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) if (p[i] > {0}) % += p[i];",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) % -= p[i] * {0};",
    "Real u% = 0.0@, v% = 0.0@; for (int i = 0; i < n; ++i) "
    "{{ u% += p[i]; v% += p[i] * p[i]; }} Real % = v% - u% * u% / 8.0@;",
    # Horner and recurrences.
    "Real % = {0}; for (int i = 0; i < 5; ++i) % = % * {1} + p[i];",
    "Real % = {0}; for (int i = 0; i < n; ++i) % = 0.5@ * (% + {1} / %);",
    "Real % = {0}; for (int i = 0; i < n; ++i) % = % * 1.7@ * (1.0@ - %);",
    "Real % = 1.0@; for (int i = 0; i < n; ++i) % = % / {0};",
    "Real % = {0}; for (int i = 1; i < n; ++i) % = % / (p[i] - p[i - 1]);",
    "Real % = {0}; for (int i = 0; i < n; ++i) % = % * % - {1};",
    # Minimum and maximum.
    "Real % = p[0]; for (int i = 1; i < n; ++i) % = fmin@(%, p[i]);",
    "Real % = p[0]; for (int i = 1; i < 8; ++i) % = p[i] > % ? p[i] : %;",
    "Real % = {0}; for (int i = 0; i < n; ++i) % = fmax@(%, p[i] * {1});",
    # Nested, with an early end, and with the sum in memory.
    "Real % = 0.0@; for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j) "
    "% += p[i] * p[j + 3] / {0};",
    "Real % = {0}; for (int i = 0; i < n; ++i) "
    "{{ if (% * {1} > 100.0@) break; % += p[i] * p[i] * {1}; }}",
    "q[6] = 0.0@; for (int i = 0; i < n; ++i) q[6] += p[i] * {0}; "
    "Real % = q[6];",
    "Vector<Real> w% = {{0.0@, 0.0@, 0.0@}}; for (int i = 0; i < n; ++i) "
    "w% = w% + s * p[i] * Real({0}); Real % = length(w%);",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) "
    "% += mix<Real>(p[i], {0}, {1});",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) % += (Real)i * {0} / {1};",
    # Stores that other pointers may see.
    "for (int i = 0; i < n; ++i) q[i] = p[i] * {0}; Real % = q[1];",
    "for (int i = 0; i < 4; ++i) q[i] = q[i] / {0} + p[i]; Real % = q[3];",
    "Real % = 0.0@; for (int i = 0; i < n; ++i) "
    "{{ q[i] = {0} / p[i]; % += q[i]; }}",
)


@dataclasses.dataclass(frozen=True)
class Statement:
    """Lines whose {0}, {1}, ... are the expressions."""

    template: str
    expressions: tuple

    def text(self):
        return self.template.format(*(e.text() for e in self.expressions))


@dataclasses.dataclass(frozen=True)
class Function:
    """A random function Real eN(a, b, c, d, s, p, q, n)."""

    number: int
    type: str
    statements: tuple
    # Parameters of a call in a loop that change from iteration to iteration.
    varying: frozenset
    # The values of a, b, c, d, s.x, s.y, s.z, p[0] ... p[11] and n.
    inputs: tuple

    def body(self):
        suffix = "f" if self.type == "float" else ""
        lines = [statement.text() for statement in self.statements]
        return "\n".join("  " + line for line in lines).replace("@", suffix)

    def calls_library(self):
        """Whether its results are those of the target's own library."""
        return re.search(
            r"\b(sin|exp|log|pow@\(fabs)|2\.2@", "".join(self.templates())
        )

    def templates(self):
        """Of all its expressions."""
        pending = [e for s in self.statements for e in s.expressions]
        while pending:
            expression = pending.pop()
            yield expression.template
            pending.extend(expression.operands)

    def asks_for_contraction(self):
        return any(
            f"contract({word})" in self.statements[0].template
            for word in ("on", "fast")
        )


SETS = 3
MEMORY = 12


def random_value(generator):
    kind = generator.random()
    if kind < 0.25:
        return float(generator.randrange(-8, 9))
    if kind < 0.45:
        return generator.randrange(-40, 41) * 0.1
    if kind < 0.9:
        return generator.uniform(-4, 4)
    return generator.choice((-1, 1)) * 10.0 ** generator.uniform(-6, 6)


def special_value(generator):
    return generator.choice(
        (0.0, -0.0, float("inf"), float("-inf"), float("nan"), 1e-40, 3e38)
    )


def random_inputs(generator):
    """One set in three has a special value."""
    values = [random_value(generator) for _ in range(7 + MEMORY)]
    if generator.random() < 0.33:
        values[generator.randrange(len(values))] = special_value(generator)
    return (*values, generator.randrange(3, 9))


def random_function(seed, number):
    """The same function for the same seed and number."""
    generator = random.Random(f"{seed} {number}")
    maker = ExpressionMaker(generator)
    statements = []
    if generator.random() < 0.15:
        pragma = f"_Pragma(\"clang fp {generator.choice(PRAGMAS)}\")"
        statements.append(Statement(pragma, ()))
    for i in range(generator.choices((0, 1, 2, 3), (10, 5, 2, 1))[0]):
        name = f"v{i}"
        kind = generator.random()
        if kind < 0.35:
            template = generator.choice(LOOPS).replace("%", name)
            operands = (maker.make(1), maker.make(1))[: operand_count(template)]
        elif kind < 0.45:
            template = "q[%d] = {0};" % generator.randrange(4)
            operands = (maker.make(2),)
        elif kind < 0.55:
            template = "Real % = {0}; if ({1} < {2}) % = {3};"
            template = template.replace("%", name)
            operands = tuple(maker.make(d) for d in (1, 1, 0, 2))
        else:
            template = f"Real {name} = {{0}};"
            operands = (maker.make(2),)
        statements.append(Statement(template, operands))
        if f"Real {name}" in template:
            maker.names.append(name)
    result = maker.make(generator.choice((1, 2, 2, 3)))
    statements.append(Statement("return {0};", (result,)))
    parameters = ("a", "b", "c", "d", "s", "m")
    return Function(
        number,
        generator.choice(("float", "float", "double")),
        tuple(statements),
        frozenset(generator.sample(parameters, generator.randrange(4))),
        tuple(random_inputs(generator) for _ in range(SETS)),
    )


def simpler_functions(function):
    """Functions that are one step simpler, the simplest first."""
    statements = function.statements
    for i in range(len(statements) - 1):
        rest = statements[:i] + statements[i + 1 :]
        names = re.findall(r"\bReal (v\d)", statements[i].template)
        if not any(
            re.search(rf"\b{name}\b", other.text())
            for name in names
            for other in rest
        ):
            yield dataclasses.replace(function, statements=rest)
    for i, statement in enumerate(statements):
        for position, expression in enumerate(statement.expressions):
            for replacement in simpler(expression):
                expressions = list(statement.expressions)
                expressions[position] = replacement
                changed = list(statements)
                changed[i] = dataclasses.replace(
                    statement, expressions=tuple(expressions)
                )
                yield dataclasses.replace(function, statements=tuple(changed))
    for i in range(len(function.inputs) if len(function.inputs) > 1 else 0):
        yield dataclasses.replace(function, inputs=(function.inputs[i],))
    for name in function.varying:
        yield dataclasses.replace(function, varying=function.varying - {name})
