# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random functions. Each maker returns the Functions that may be called and
the lines that define them."""

from cxx.scope import Function, Scope, Variable
from cxx.statements import indented
from cxx.types import (
    BOOLEAN, DOUBLE, INT32, INTEGERS, Structure, UINT32, UINT64,
)

ATTRIBUTES = (
    "", "static ", "NOINLINE ", "static NOINLINE ", "static NOINLINE ",
    "static ALWAYS_INLINE ", "__attribute__((flatten)) ",
    "__attribute__((cold)) ", "__attribute__((minsize)) ",
)
MOST_COST = 20_000


class Functions:
    """Makes functions over the global variables."""

    def __init__(self, generator, statements, types, variables):
        self.generator = generator
        self.statements = statements
        self.types = types
        self.globals = variables

    def scope(self, is_pure, functions):
        variables = [
            Variable(v.text, v.type, v.is_writable and not is_pure,
                     v.has_address and not is_pure)
            for v in self.globals
        ]
        return Scope(variables, functions)

    def signature(self):
        count = self.generator.choice((0, 1, 1, 2, 2, 3, 3, 4, 5, 6, 9))
        kinds = [self.generator.choice(self.types) for _ in range(count)]
        return self.generator.choice(self.types), kinds

    def parameters(self, kinds, scope):
        """Declarations; now and then a reference to the argument."""
        texts = []
        for i, kind in enumerate(kinds):
            by_reference = self.generator.random() < 0.1
            scope.variables.append(Variable(f"a{i}", kind, not by_reference))
            texts.append(f"const {kind.name} &a{i}" if by_reference
                         else f"{kind.name} a{i}")
        return texts

    def begin(self, is_pure):
        self.statements.cost = 10
        self.statements.turns = 1
        self.statements.has_labels = False
        self.statements.allows_effects = not is_pure

    def body(self, scope, depth=2):
        return self.statements.block(
            scope, self.generator.randint(2, 7), depth)

    def make(self, name, functions):
        kind = self.generator.randrange(8)
        if kind == 0:
            return self.recursive(name, functions)
        if kind == 1:
            return self.variadic(name, functions)
        return self.plain(name, functions)

    def plain(self, name, functions):
        is_pure = self.generator.random() < 0.5
        result, kinds = self.signature()
        scope = self.scope(is_pure, functions)
        self.begin(is_pure)
        texts = self.parameters(kinds, scope)
        lines = self.body(scope)
        value = self.statements.expression(result, scope)
        # GCC does not inline a function with a table of its labels.
        attribute = self.generator.choice(
            ATTRIBUTES[:5] if self.statements.has_labels else ATTRIBUTES)
        head = f"{attribute}{result.name} {name}({', '.join(texts)}) {{"
        lines = [head] + indented(lines + [f"return {value};"]) + ["}"]
        function = Function(name, result, tuple(kinds), self.statements.cost,
                            is_pure)
        if function.cost > MOST_COST:
            return [], []
        if self.generator.random() < 0.4:
            types = ", ".join(t.rsplit(" ", 1)[0] + (
                " &" if "&" in t else "") for t in texts)
            lines.append(f"static {result.name} (*volatile {name}p)({types}) "
                         f"= {name};")
            function = Function(name, result, tuple(kinds), function.cost,
                                is_pure, f"{name}p")
        return [function], lines

    def recursive(self, name, functions):
        """It calls itself with a smaller depth, at its end or before."""
        result, kinds = self.signature()
        scope = self.scope(False, functions)
        self.begin(False)
        scope.variables.append(Variable("Depth", INT32, False))
        texts = ["int32_t Depth"] + self.parameters(kinds, scope)
        lines = self.body(scope, 1)
        stop = self.statements.expression(BOOLEAN, scope, 2)
        early = self.statements.expression(result, scope, 2)
        lines.append(f"if (Depth <= 0 || ({stop})) return {early};")
        arguments = ["Depth - 1"] + [
            self.statements.expression(kind, scope, 2) for kind in kinds]
        again = f"{name}({', '.join(arguments)})"
        if self.generator.random() < 0.5:
            lines.append(f"return {again};")
        else:
            lines.append(f"{result.name} Inner = {again};")
            scope.variables.append(Variable("Inner", result))
            lines += self.body(scope, 1)
            value = self.statements.expression(result, scope, 2)
            lines.append(f"return {value};")
        depth = self.generator.randint(1, 8)
        cost = self.statements.cost * (depth + 1)
        if cost > MOST_COST:
            return [], []
        lines = [f"static {result.name} {name}({', '.join(texts)}) {{",
                 *indented(lines), "}"]
        wrapper, more = self.wrapper(name, result, kinds, [str(depth)], cost)
        return [wrapper], lines + more

    def wrapper(self, name, result, kinds, first, cost):
        """A function of fixed arguments."""
        parameters = ", ".join(
            f"{kind.name} a{i}" for i, kind in enumerate(kinds))
        arguments = ", ".join(first + [f"a{i}" for i in range(len(kinds))])
        lines = [f"NOINLINE {result.name} {name}w({parameters}) {{",
                 f"  return {name}({arguments});", "}"]
        return (Function(f"{name}w", result, tuple(kinds), cost, False), lines)

    def variadic(self, name, functions):
        """Reads its arguments one by one, or all of one type in a loop."""
        allowed = [INT32, UINT32, INTEGERS[6], UINT64, DOUBLE] + [
            t for t in self.types
            if isinstance(t, Structure) and t.is_variadic
        ]
        result = self.generator.choice(self.types)
        scope = self.scope(False, functions)
        self.begin(False)
        count = self.generator.randint(1, 7)
        lines = ["va_list List;", "va_start(List, Count);"]
        if self.generator.random() < 0.3:
            kind = self.generator.choice(allowed)
            kinds = [kind] * count
            scope.variables.append(Variable("Last", kind))
            lines += [f"{kind.name} Last = va_arg(List, {kind.name});",
                      "for (uint32_t I = 1; I < Count; ++I) {",
                      "  mix(Total, Last);",
                      f"  Last = va_arg(List, {kind.name});", "}"]
        else:
            kinds = [self.generator.choice(allowed) for _ in range(count)]
            again = self.generator.randrange(count)
            for i, kind in enumerate(kinds):
                if i == again:
                    lines += ["va_list Copy;", "va_copy(Copy, List);"]
                lines.append(f"{kind.name} v{i} = va_arg(List, {kind.name});")
                scope.variables.append(Variable(f"v{i}", kind))
            lines += [f"mix(Total, va_arg(Copy, {kinds[again].name}));",
                      "va_end(Copy);"]
        self.statements.number += 10
        lines += ["va_end(List);"] + self.body(scope, 1)
        value = self.statements.expression(result, scope)
        head = f"static NOINLINE {result.name} {name}(uint32_t Count, ...)"
        lines = [f"{head} {{", *indented(lines + [f"return {value};"]), "}"]
        if self.statements.cost > MOST_COST:
            return [], []
        wrapper, more = self.wrapper(name, result, kinds, [str(count)],
                                     self.statements.cost + 20)
        return [wrapper], lines + more
