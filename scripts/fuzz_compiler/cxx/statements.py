# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random statements, each a list of lines."""

from cxx.scope import Variable
from cxx.types import (
    Array, BOOLEAN, BitInteger, Enumeration, Floating, Half, INTEGERS, Integer,
    Structure, UINT32, UNSIGNED, Vector,
)


def indented(lines):
    return ["  " + line for line in lines]


class Statements:
    """Makes blocks of statements. Their cost, in simple operations with the
    turns of loops, stays about within a budget."""

    def __init__(self, generator, expressions, types, label="L"):
        self.generator = generator
        self.expressions = expressions
        self.types = types
        self.label = label
        self.number = 0
        self.cost = 0
        # How often the place being written is executed.
        self.turns = 1
        self.allows_effects = True
        # An indirect jump may go to every label of the function whose address
        # is taken, and may not leave an object with a destructor.
        self.has_labels = False
        self.only_trivial = False

    def name(self, prefix="v"):
        self.number += 1
        return f"{prefix}{self.number}"

    def chance(self, probability):
        return self.generator.random() < probability

    def expression(self, kind, scope, depth=None):
        expressions = self.expressions
        expressions.budget = max(0, 3000 // self.turns)
        expressions.spent = 0
        if depth is None:
            depth = self.generator.randint(1, 4)
        text = expressions.make(kind, scope, depth)
        self.cost += self.turns * (expressions.spent + 4)
        return text

    def any_type(self):
        return self.generator.choice(
            [t for t in self.types if self.may_declare(t)])

    def may_declare(self, kind):
        return not (self.only_trivial and isinstance(kind, Structure)
                    and kind.is_nontrivial)

    def target(self, scope, wanted):
        """A part of a variable that may be written."""
        found = self.expressions.lvalues(
            scope, lambda v: v.is_writable and wanted(v))
        return self.generator.choice(found) if found else None

    def block(self, scope, length, depth):
        inner = scope.inner()
        lines = []
        for _ in range(length):
            lines += self.statement(inner, depth)
        return lines

    def statement(self, scope, depth):
        simple = [self.declaration] * 4 + [self.assignment] * 6 + [
            self.compound, self.compound, self.pointer, self.reference,
            self.copy, self.local_array, self.swap,
        ]
        if self.allows_effects:
            simple += [self.call, self.call, self.atomic, self.static_counter]
        if depth > 0:
            simple += [self.conditional] * 2 + [
                self.counted_loop, self.counted_loop, self.while_loop,
                self.switch, self.lambda_call, self.labels,
            ]
        return self.generator.choice(simple)(scope, depth) or self.assignment(
            scope, depth)

    def declaration(self, scope, _depth=0):
        kind = self.any_type()
        name = self.name()
        value = self.expression(kind, scope)
        prefix = "volatile " if self.chance(0.05) and not isinstance(
            kind, (Structure, Vector, Half)) else ""
        is_constant = not prefix and self.chance(0.15)
        if is_constant:
            prefix = "const "
        scope.variables.append(Variable(name, kind, not is_constant))
        if prefix == "volatile ":
            scope.variables[-1] = Variable(name, kind, True, False)
        return [f"{prefix}{kind.name} {name} = {value};"]

    def assignment(self, scope, _depth):
        target = self.target(scope, lambda v: not isinstance(v.type, Array))
        if not target:
            return self.declaration(scope, 0)
        return [f"{target.text} = {self.expression(target.type, scope)};"]

    def compound(self, scope, _depth):
        target = self.target(
            scope, lambda v: isinstance(v.type, (Integer, Floating, Vector)))
        if not target:
            return None
        kind = target.type
        value = self.expression(kind, scope)
        element = kind.element if isinstance(kind, Vector) else kind
        if isinstance(element, Floating):
            return [f"{target.text} {self.generator.choice('+-*')}= {value};"]
        if isinstance(kind, Integer) and not kind.signed and self.chance(0.3):
            return [f"{target.text}{self.generator.choice(('++', '--'))};"]
        # An unsigned int16_t is multiplied as an int.
        operators = "&|^"
        if not (isinstance(kind, Integer) and (kind.signed or kind.bits == 16)):
            operators += "+-*"
        return [f"{target.text} {self.generator.choice(operators)}= {value};"]

    def addressed(self, scope):
        return self.target(scope, lambda v: v.has_address and not isinstance(
            v.type, Array))

    def pointer(self, scope, _depth):
        first = self.addressed(scope)
        if not first:
            return None
        second = self.target(
            scope, lambda v: v.has_address and v.type == first.type)
        name = self.name("p")
        condition = self.expression(BOOLEAN, scope, 2)
        lines = [f"{first.type.name} *{name} = {condition} ? "
                 f"&{first.text} : &{second.text};"]
        scope.variables.append(Variable(f"(*{name})", first.type))
        return lines

    def reference(self, scope, _depth):
        target = self.addressed(scope)
        if not target:
            return None
        name = self.name("r")
        scope.variables.append(Variable(name, target.type))
        return [f"{target.type.name} &{name} = {target.text};"]

    def copy(self, scope, _depth):
        """Of a structure's bytes, as a structure is copied or by a call."""
        target = self.target(
            scope, lambda v: isinstance(v.type, Structure) and v.has_address)
        if not target:
            return None
        value = self.expression(target.type, scope, 1)
        if target.type.is_nontrivial:
            return [f"{target.text} = {value};"]
        name = self.name("c")
        return [f"{{ {target.type.name} {name} = {value};",
                f"  __builtin_memcpy(&{target.text}, &{name}, "
                f"sizeof({name})); }}"]

    def swap(self, scope, _depth):
        first = self.target(scope, lambda v: not isinstance(v.type, Array))
        if not first:
            return None
        second = self.target(scope, lambda v: v.type == first.type)
        name = self.name("t")
        return [f"{{ {first.type.name} {name} = {first.text};",
                f"  {first.text} = {second.text};",
                f"  {second.text} = {name}; }}"]

    def local_array(self, scope, _depth):
        """Of a constant length, of a variable length, or of alloca."""
        kind = self.any_type()
        count = self.generator.randint(2, 12)
        name, index = self.name("b"), self.name("i")
        method = self.generator.randrange(4)
        if isinstance(kind, Structure) and kind.is_nontrivial:
            method = 3
        if self.turns > 1:
            method = 3
        length = f"{count} + ({self.expression(UINT32, scope, 1)}) % 5"
        if method == 0:
            lines = [f"uint32_t {name}n = {length};",
                     f"{kind.name} {name}[{name}n];"]
        elif method == 1:
            lines = [
                f"uint32_t {name}n = {length};",
                f"{kind.name} *{name} = ({kind.name} *)"
                f"__builtin_alloca_with_align({name}n * sizeof({kind.name}), "
                f"8 * alignof({kind.name}));",
            ]
        else:
            lines = [f"constexpr uint32_t {name}n = {count};",
                     f"{kind.name} {name}[{count}];"]
        self.turns *= 10
        inner = scope.inner()
        inner.variables.append(Variable(index, UINT32, False))
        value = self.expression(kind, inner, 2)
        self.turns //= 10
        lines += [f"for (uint32_t {index} = 0; {index} != {name}n; ++{index})",
                  f"  {name}[{index}] = {value};"]
        scope.variables.append(Variable(name, Array("", kind, count)))
        return lines

    def conditional(self, scope, depth):
        condition = self.expression(BOOLEAN, scope)
        attribute = self.generator.choice(("", "", "", " [[likely]]",
                                           " [[unlikely]]"))
        lines = [f"if ({condition}){attribute} {{"]
        lines += indented(
            self.block(scope, self.generator.randint(1, 3), depth - 1))
        if self.chance(0.5):
            lines += ["} else {"] + indented(
                self.block(scope, self.generator.randint(1, 3), depth - 1))
        return lines + ["}"]

    def loop_body(self, scope, depth, turns):
        self.turns *= turns
        lines = self.block(scope, self.generator.randint(1, 4), depth - 1)
        if self.chance(0.25):
            word = self.generator.choice(("break", "continue"))
            condition = self.expression(BOOLEAN, scope, 2)
            lines.insert(self.generator.choice((0, len(lines))),
                         f"if ({condition}) {word};")
        self.turns //= turns
        return indented(lines)

    def counted_loop(self, scope, depth):
        if self.turns > 100:
            return None
        kind = self.generator.choice(INTEGERS[2:])
        name = self.name("i")
        turns = self.generator.randint(1, 12)
        step = self.generator.choice((1, 1, 1, 2, 3))
        start = self.generator.choice((0, 0, 0, 1, 5, 100))
        if not kind.signed or self.chance(0.7):
            head = (f"for ({kind.name} {name} = {start}; {name} < "
                    f"{start + turns * step}; {name} += {step}) {{")
        else:
            head = (f"for ({kind.name} {name} = {start + turns * step}; "
                    f"{name} > {start}; {name} -= {step}) {{")
        inner = scope.inner()
        inner.variables.append(Variable(name, kind, False))
        return [head] + self.loop_body(inner, depth, turns) + ["}"]

    def while_loop(self, scope, depth):
        if self.turns > 100:
            return None
        name = self.name("n")
        turns = self.generator.randint(1, 10)
        condition = self.expression(BOOLEAN, scope, 2)
        inner = scope.inner()
        inner.variables.append(Variable(name, INTEGERS[4], False))
        body = self.loop_body(inner, depth, turns)
        if self.chance(0.5):
            return ([f"int32_t {name} = {turns};",
                     f"while ({name}-- > 0 && {condition}) {{"] + body + ["}"])
        return ([f"int32_t {name} = {turns};", "do {"] + body
                + [f"}} while (--{name} > 0 && {condition});"])

    def switch(self, scope, depth):
        kind = self.generator.choice(
            [t for t in self.types if isinstance(t, (Integer, Enumeration))
             and not isinstance(t, BitInteger)])
        integer = kind.underlying if isinstance(kind, Enumeration) else kind
        value = f"({integer.name})({self.expression(kind, scope)})"
        if self.chance(0.6):
            value = f"({value}) & {self.generator.choice((7, 15, 31))}"
        labels = self.switch_labels(integer)
        lines = [f"switch ({value}) {{"]
        for label in labels:
            lines += [f"{label}: {{"]
            lines += indented(
                self.block(scope, self.generator.randint(1, 2), depth - 1))
            end = "" if self.chance(0.2) else " break;"
            lines += [f"}}{end}"]
        return lines + ["}"]

    def switch_labels(self, integer):
        if self.chance(0.6):
            start = self.generator.choice((0, 0, 0, 1, 3, 10))
            values = range(start, start + self.generator.randint(2, 16))
            values = [v for v in values if self.chance(0.85)]
        else:
            low = -(1 << integer.bits - 1) if integer.signed else 0
            values = {self.generator.randint(low, low + (1 << integer.bits) - 1)
                      for _ in range(self.generator.randint(2, 6))}
            values = [v for v in values if v != low]
        labels = [f"case {v}{'ull' if v >= 1 << 31 else ''}" for v in values]
        if self.chance(0.3):
            labels = ["case 40 ... 47"] + [
                f"case {v}" for v in values if v < 40]
        if self.chance(0.7):
            labels.insert(self.generator.randint(0, len(labels)), "default")
        return labels or ["default"]

    def lambda_call(self, scope, depth):
        """A closure with copies of some variables and references to others."""
        name = self.name("closure")
        kind, parameter = self.any_type(), self.any_type()
        inner = scope.inner()
        argument = self.name("x")
        inner.variables.append(Variable(argument, parameter))
        capture = self.generator.choice(("&", "="))
        saved = self.allows_effects
        if capture == "=":
            inner = self.read_only(inner, argument, parameter)
        body = self.block(inner, self.generator.randint(1, 3), depth - 1)
        result = self.expression(kind, inner)
        self.allows_effects = saved
        lines = [f"auto {name} = [{capture}]({parameter.name} {argument}) "
                 f"-> {kind.name} {{"]
        lines += indented(body + [f"return {result};"]) + ["};"]
        variable = self.name()
        value = self.expression(parameter, scope, 2)
        scope.variables.append(Variable(variable, kind))
        return lines + [f"{kind.name} {variable} = {name}({value});"]

    def read_only(self, scope, argument, kind):
        """The scope of a closure that copies: an array or a reference's
        object is left out."""
        visible = [
            Variable(v.text, v.type, v.text in self.global_names, v.has_address)
            for v in scope.all_variables()
            if not isinstance(v.type, Array) or v.text in self.global_names
            if v.text != argument and not v.text.startswith("(*")
        ]
        result = type(scope)(visible, scope.all_functions())
        result.variables.append(Variable(argument, kind))
        return result

    global_names = frozenset()

    def labels(self, scope, depth):
        """A machine of states: a computed goto."""
        if self.turns > 20 or self.has_labels:
            return None
        self.has_labels = self.only_trivial = True
        states = self.generator.randint(2, 4)
        number = self.name(self.label)
        steps = self.generator.randint(2, 8)
        state, left = f"{number}state", f"{number}left"
        names = ", ".join(f"&&{number}_{i}" for i in range(states))
        lines = [
            "{", f"  static void *const {number}table[] = {{{names}}};",
            f"  uint32_t {state} = {self.expression(UINT32, scope, 2)};",
            f"  int {left} = {steps};",
            f"  goto *{number}table[{state} % {states}];",
        ]
        self.turns *= steps
        for i in range(states):
            body = self.block(scope, self.generator.randint(1, 2), 0)
            lines += [f"{number}_{i}: {{"] + indented(body)
            lines += [
                f"  {state} = {state} * 5 + {i + 1};",
                f"  if (--{left} > 0) goto *{number}table[{state} % {states}];",
                f"  goto {number}_end;", "}",
            ]
        self.turns //= steps
        self.only_trivial = False
        return lines + [f"{number}_end:;", "}"]

    def call(self, scope, _depth):
        """Of any function; what has effects is called by itself."""
        limit = max(0, 4000 // self.turns)
        found = [f for f in scope.all_functions() if f.cost <= limit
                 and self.may_declare(f.result)]
        if not found:
            return None
        function = self.generator.choice(found)
        arguments = [self.expression(p, scope, 2) for p in function.parameters]
        self.cost += self.turns * function.cost
        name = self.name()
        scope.variables.append(Variable(name, function.result))
        return [f"{function.result.name} {name} = "
                f"{function.call_text(arguments)};"]

    def atomic(self, scope, _depth):
        kind = self.generator.choice(UNSIGNED)
        value = self.expression(kind, scope, 2)
        name = self.name()
        scope.variables.append(Variable(name, kind))
        operation = self.generator.choice(
            ("fetch_add", "fetch_sub", "fetch_and", "fetch_or", "fetch_xor",
             "exchange_n", "add_fetch", "nand_fetch"))
        return [f"{kind.name} {name} = __atomic_{operation}"
                f"(&atomic{kind.bits}, {value}, __ATOMIC_SEQ_CST);"]

    def static_counter(self, scope, _depth):
        kind = self.generator.choice(
            [t for t in self.types
             if not isinstance(t, Vector) and self.may_declare(t)])
        name = self.name("s")
        storage = self.generator.choice(("", "", "THREAD_LOCAL "))
        inner = type(scope)()
        text = self.expression(kind, inner, 1)
        scope.variables.append(Variable(name, kind))
        return [f"static {storage}{kind.name} {name} = {text};"]
