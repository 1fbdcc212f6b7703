# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Types of generated programs."""

import dataclasses


@dataclasses.dataclass(frozen=True)
class Type:
    name: str


@dataclasses.dataclass(frozen=True)
class Integer(Type):
    bits: int
    signed: bool

    @property
    def wide(self):
        """The unsigned type in which arithmetic wraps."""
        return f"uint{max(self.bits, 32)}_t"


@dataclasses.dataclass(frozen=True)
class BitInteger(Integer):
    """_BitInt(bits), which is not promoted to int."""

    @property
    def wide(self):
        return f"unsigned _BitInt({self.bits})"


def bit_integer(bits, signed):
    """(type, declaration)"""
    name = f"{'Signed' if signed else 'Unsigned'}{bits}"
    text = f"using {name} = {'' if signed else 'unsigned '}_BitInt({bits});"
    return BitInteger(name, bits, signed), text


@dataclasses.dataclass(frozen=True)
class Boolean(Type):
    pass


@dataclasses.dataclass(frozen=True)
class Floating(Type):
    bits: int
    # Of literals and of builtin functions.
    suffix: str


@dataclasses.dataclass(frozen=True)
class Half(Type):
    pass


@dataclasses.dataclass(frozen=True)
class Enumeration(Type):
    underlying: Integer
    constants: tuple


@dataclasses.dataclass(frozen=True)
class Vector(Type):
    element: Type
    count: int


@dataclasses.dataclass(frozen=True)
class Array(Type):
    """Only of variables and fields."""

    element: Type
    count: int


@dataclasses.dataclass(frozen=True)
class Field:
    name: str
    type: Type
    bits: int = 0
    prefix: str = ""

    def declaration(self):
        if isinstance(self.type, Array):
            element = self.type.element.name
            return f"{self.prefix}{element} {self.name}[{self.type.count}];"
        width = f" : {self.bits}" if self.bits else ""
        return f"{self.prefix}{self.type.name} {self.name}{width};"


@dataclasses.dataclass(frozen=True)
class Structure(Type):
    fields: tuple
    packed: bool = False
    is_union: bool = False
    # It or a part has a copy constructor: passed by reference to a copy.
    is_nontrivial: bool = False

    @property
    def is_variadic(self):
        """Whether it may be passed through an ellipsis."""
        return not self.is_nontrivial


INTEGERS = [
    Integer(f"{'' if signed else 'u'}int{bits}_t", bits, signed)
    for bits in (8, 16, 32, 64)
    for signed in (True, False)
]
UNSIGNED = [t for t in INTEGERS if not t.signed]
INT32 = INTEGERS[4]
UINT32 = INTEGERS[5]
UINT64 = INTEGERS[7]
BOOLEAN = Boolean("bool")
FLOAT = Floating("float", 32, "f")
DOUBLE = Floating("double", 64, "")
HALF = Half("half")


def vector_types():
    """(type, declaration) of each vector type."""
    result = []
    for element, short in (
        (UNSIGNED[0], "u8"), (UNSIGNED[1], "u16"), (UINT32, "u32"),
        (UINT64, "u64"), (FLOAT, "f32"), (DOUBLE, "f64"),
    ):
        for count in (2, 4, 8):
            name = f"{short}x{count}"
            size = element.bits // 8 * count
            text = (f"typedef {element.name} {name} "
                    f"__attribute__((vector_size({size})));")
            result.append((Vector(name, element, count), text))
    return result


def triple_types():
    """Vectors of three elements, which only clang has."""
    result = []
    for element, short in ((UINT32, "u32"), (FLOAT, "f32"), (UNSIGNED[0], "u8"),
                           (DOUBLE, "f64")):
        name = f"{short}x3"
        text = (f"typedef {element.name} {name} "
                f"__attribute__((ext_vector_type(3)));")
        result.append((Vector(name, element, 3), text))
    return result
