# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What a piece of a generated program may name."""

import dataclasses

from cxx.types import Array, Structure, Type


@dataclasses.dataclass(frozen=True)
class Variable:
    """text is an lvalue; a bit-field and a packed field have no address."""

    text: str
    type: Type
    is_writable: bool = True
    has_address: bool = True


@dataclasses.dataclass(frozen=True)
class Function:
    """is_pure: it changes nothing but its own variables."""

    name: str
    result: Type
    parameters: tuple
    cost: int
    is_pure: bool
    # A function's name, or an object and an operator before it.
    call: str = ""

    def call_text(self, arguments):
        return f"{self.call or self.name}({', '.join(arguments)})"


class Scope:
    """Variables in sight and the functions that may be called."""

    def __init__(self, variables=(), functions=(), parent=None):
        self.variables = list(variables)
        self.functions = list(functions)
        self.parent = parent

    def inner(self):
        return Scope((), (), self)

    def all_variables(self):
        inherited = self.parent.all_variables() if self.parent else []
        return inherited + self.variables

    def all_functions(self):
        inherited = self.parent.all_functions() if self.parent else []
        return inherited + self.functions


def parts(variable, index):
    """A variable and what it consists of; index() gives an expression for a
    place in an array of a length."""
    result = [variable]
    if isinstance(variable.type, Array):
        place = index(variable.type.count)
        element = Variable(f"{variable.text}[{place}]", variable.type.element,
                           variable.is_writable, variable.has_address)
        return parts(element, index)
    if isinstance(variable.type, Structure):
        for field in variable.type.fields:
            member = Variable(
                f"{variable.text}.{field.name}", field.type,
                variable.is_writable,
                variable.has_address and not field.bits
                and not variable.type.packed,
            )
            result += parts(member, index)
    return result
