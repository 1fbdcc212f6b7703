# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random class hierarchies: virtual functions, several bases, virtual bases,
pointers to members, results of a derived class's type."""

import dataclasses

from cxx import declarations
from cxx.functions import MOST_COST
from cxx.scope import Function, Variable
from cxx.statements import indented
from cxx.types import BOOLEAN, Floating, Integer


@dataclasses.dataclass
class Method:
    name: str
    result: object
    kinds: tuple
    # The most that any class's version costs.
    cost: int


@dataclasses.dataclass
class Class:
    name: str
    bases: list
    is_virtual_base: bool
    fields: list
    methods: list
    returns_self: bool

    def ancestors(self):
        """Itself and all bases, each once."""
        result = [self]
        for base in self.bases:
            result += [a for a in base.ancestors() if a not in result]
        return result

    def unshareable(self):
        return {a.name for a in self.ancestors() if not a.is_virtual_base}


class Hierarchy:
    """Makes classes; methods call only the functions given."""

    def __init__(self, generator, functions, callees):
        self.generator = generator
        self.functions = functions
        self.callees = callees
        self.classes = []

    def lines(self, count):
        result = []
        for number in range(count):
            result += self.make_class(number)
        return result

    def make_class(self, number):
        name = f"C{number}"
        bases = self.choose_bases() if number >= 2 else []
        made = Class(name, bases, self.generator.random() < 0.3, [], [],
                     self.generator.random() < 0.3)
        made.fields = [
            Variable(f"m{number}_{i}", declarations.scalar_type(
                self.generator, []))
            for i in range(self.generator.randint(0, 4))
        ]
        lines = [f"class {name}{self.base_list(bases)} {{", "public:"]
        lines += [f"  {f.type.name} {f.text} = {self.initial(f.type)};"
                  for f in made.fields]
        lines += [f"  virtual ~{name}() {{ mix(Total, (uint64_t){number}); }}"]
        if made.returns_self:
            lines.append(f"  virtual {name} *self{number}() "
                         "{ return this; }")
        for ancestor in made.ancestors()[1:]:
            if ancestor.returns_self and self.generator.random() < 0.5:
                place = ancestor.name[1:]
                lines.append(f"  {name} *self{place}() override "
                             "{ return this; }")
        lines += self.methods_of(made, number)
        self.classes.append(made)
        return lines + ["};"]

    def initial(self, kind):
        return self.functions.statements.expressions.constant(kind)

    def choose_bases(self):
        """Classes that share no base, unless it is virtual."""
        chosen, taken = [], set()
        for base in self.generator.sample(self.classes, len(self.classes)):
            if len(chosen) < 3 and not taken & base.unshareable() and not any(
                    base in c.ancestors() or c in base.ancestors()
                    for c in chosen):
                chosen.append(base)
                taken |= base.unshareable()
            if self.generator.random() < 0.4:
                break
        return chosen

    @staticmethod
    def base_list(bases):
        names = [f"public {'virtual ' if b.is_virtual_base else ''}{b.name}"
                 for b in bases]
        return " : " + ", ".join(names) if names else ""

    def methods_of(self, made, number):
        lines = []
        inherited = [m for a in made.ancestors()[1:] for m in a.methods]
        # What two bases override apart must be overridden again.
        for method in inherited:
            if self.generator.random() < 0.6 or len(made.bases) > 1:
                lines += self.method(made, method, " override")
        for i in range(self.generator.randint(1, 3)):
            result, kinds = self.functions.signature()
            if i == 1 and self.generator.random() < 0.7:
                result, kinds = made.methods[0].result, made.methods[0].kinds
            method = Method(f"f{number}_{i}", result, tuple(kinds[:5]), 0)
            lines += self.method(made, method, "", "virtual ")
            made.methods.append(method)
        return lines

    def method(self, made, method, suffix, prefix=""):
        scope = self.functions.scope(False, self.callees)
        for ancestor in made.ancestors():
            scope.variables += ancestor.fields
        self.functions.begin(False)
        statements = self.functions.statements
        self.functions.parameters(method.kinds, scope)
        lines = statements.block(scope, self.generator.randint(1, 3), 1)
        value = statements.expression(method.result, scope, 2)
        if statements.cost > MOST_COST:
            self.functions.begin(False)
            lines = []
            value = statements.expressions.constant(method.result)
        method.cost = max(method.cost, statements.cost)
        # A version for another class has the same parameters.
        texts = [f"{kind.name} a{i}" for i, kind in enumerate(method.kinds)]
        head = (f"  {prefix}{method.result.name} {method.name}"
                f"({', '.join(texts)}){suffix} {{")
        return [head, *indented(indented(lines + [f"return {value};"])), "  }"]

    def objects(self):
        """Global objects, tables of pointers to bases, and the functions that
        are called through them."""
        lines = [f"static {c.name} object{c.name};" for c in self.classes]
        functions = []
        for base in self.classes:
            derived = [c for c in self.classes if base in c.ancestors()]
            table = f"table{base.name}"
            names = ", ".join(f"&object{c.name}" for c in derived)
            lines.append(f"static {base.name} *const {table}[] = {{{names}}};")
            place = f"{table}[pick({len(derived)})]->"
            functions += self.calls(base, place)
            functions_of_members, more = self.member_pointers(base)
            lines += more
            functions += functions_of_members
        return functions, lines

    def calls(self, base, place):
        result = []
        for method in base.methods:
            call = place
            if base.returns_self and self.generator.random() < 0.5:
                call += f"self{base.name[1:]}()->"
            result.append(Function(method.name, method.result, method.kinds,
                                   method.cost + 20, False,
                                   call + method.name))
        return result

    def member_pointers(self, base):
        """A function that calls one of several methods of the same type, and
        one that chooses among the fields of the same type."""
        functions, lines = [], []
        groups = {}
        for method in base.methods:
            groups.setdefault((method.result, method.kinds), []).append(method)
        for (result, kinds), methods in groups.items():
            if len(methods) > 1:
                made, more = self.method_pointer(base, result, kinds, methods)
                functions.append(made)
                lines += more
        for field in base.fields[:1]:
            same = [f for f in base.fields if f.type == field.type]
            if isinstance(field.type, (Integer, Floating, type(BOOLEAN))):
                made, more = self.field_pointer(base, field.type, same)
                functions.append(made)
                lines += more
        return functions, lines

    def method_pointer(self, base, result, kinds, methods):
        name = f"any{base.name}"
        types = ", ".join(k.name for k in kinds)
        parameters = ", ".join(f"{k.name} a{i}" for i, k in enumerate(kinds))
        arguments = ", ".join(f"a{i}" for i in range(len(kinds)))
        members = ", ".join(f"&{base.name}::{m.name}" for m in methods)
        count = sum(base in c.ancestors() for c in self.classes)
        lines = [
            f"static NOINLINE {result.name} {name}({parameters}) {{",
            f"  {result.name} ({base.name}::*Members[])({types}) = "
            f"{{{members}}};",
            f"  auto Member = Members[pick({len(methods)})];",
            f"  return (table{base.name}[pick({count})]->*Member)"
            f"({arguments});", "}",
        ]
        cost = max(m.cost for m in methods) + 30
        return Function(name, result, kinds, cost, False), lines

    def field_pointer(self, base, kind, fields):
        name = f"field{base.name}"
        members = ", ".join(f"&{base.name}::{f.text}" for f in fields)
        count = sum(base in c.ancestors() for c in self.classes)
        lines = [
            f"static NOINLINE {kind.name} {name}({kind.name} Value) {{",
            f"  static {kind.name} {base.name}::*const Members[] = "
            f"{{{members}}};",
            f"  {base.name} &Object = *table{base.name}[pick({count})];",
            f"  auto Member = Members[pick({len(fields)})];",
            f"  {kind.name} Old = Object.*Member;",
            "  Object.*Member = Value;", "  return Old;", "}",
        ]
        return Function(name, kind, (kind,), 20, False), lines
