# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random enumerations, structures and unions, with their checksums."""

from cxx import literals
from cxx.types import (
    Array, BOOLEAN, DOUBLE, Enumeration, FLOAT, Field, HALF, INTEGERS, Integer,
    Structure, Vector,
)


def enumeration(generator, number):
    """(type, declaration)"""
    underlying = generator.choice(INTEGERS)
    values = sorted({
        literals.integer(generator, underlying.bits, underlying.signed)
        for _ in range(generator.randint(2, 5))
    })
    name = f"E{number}"
    constants = tuple(f"{name}::C{i}" for i in range(len(values)))
    body = ", ".join(
        f"C{i} = "
        + literals.integer_text(value, underlying.bits, underlying.signed)
        for i, value in enumerate(values)
    )
    text = f"enum class {name} : {underlying.name} {{ {body} }};"
    return Enumeration(name, underlying, constants), text


def scalar_type(generator, enumerations):
    return generator.choice(
        INTEGERS * 2 + [BOOLEAN, FLOAT, FLOAT, FLOAT, DOUBLE, DOUBLE, HALF]
        + enumerations
    )


def field_type(generator, enumerations, packed):
    """Not half in a packed structure, since half may be a class."""
    kind = scalar_type(generator, enumerations)
    return FLOAT if packed and kind is HALF else kind


def _bit_field(generator, name, enumerations):
    kind = generator.choice(
        INTEGERS + [BOOLEAN] + [e for e in enumerations])
    if isinstance(kind, Integer):
        return Field(name, kind, generator.randint(1, kind.bits))
    if kind is BOOLEAN:
        return Field(name, kind, 1)
    return Field(name, kind, kind.underlying.bits)


def _field(generator, name, pool, enumerations, packed):
    kind = generator.random()
    if kind < 0.25:
        return _bit_field(generator, name, enumerations)
    if kind < 0.4:
        structures = [t for t in pool if not isinstance(t, Vector)]
        if structures and generator.random() < 0.5:
            element = generator.choice(structures)
        else:
            element = field_type(generator, enumerations, packed)
        return Field(name, Array("", element, generator.choice(
            (1, 2, 3, 3, 5, 5, 19))))
    if kind < 0.6 and pool:
        return Field(name, generator.choice(pool))
    prefix = ""
    if not packed and generator.random() < 0.08:
        prefix = f"alignas({generator.choice((8, 16, 32))}) "
    return Field(name, field_type(generator, enumerations, packed),
                 prefix=prefix)


def is_nontrivial_type(kind):
    if isinstance(kind, Array):
        kind = kind.element
    return isinstance(kind, Structure) and kind.is_nontrivial


def structure(generator, number, earlier, enumerations, vectors):
    """(type, declaration). The earlier structures may be fields."""
    name = f"S{number}"
    packed = generator.random() < 0.2
    # A packed structure's fields have no addresses that one may take.
    pool = [] if packed else earlier[-4:] + generator.sample(vectors, 1)
    count = generator.choice((0, 1, 1, 2, 2, 3, 3, 4, 5, 6, 8))
    fields = [
        _field(generator, f"f{i}", pool, enumerations, packed)
        for i in range(count)
    ]
    copies_itself = generator.random() < 0.2
    is_nontrivial = copies_itself or any(
        is_nontrivial_type(field.type) for field in fields)
    kind = Structure(name, tuple(fields), packed, False, is_nontrivial)
    lines = [f"struct {'PACKED ' if packed else ''}{name} {{"]
    for field in fields:
        lines.append("  " + field.declaration())
        if field.bits and generator.random() < 0.1:
            lines.append(f"  {field.type.name} : 0;")
    if copies_itself:
        lines += _copying(name, fields)
    lines.append("};")
    return kind, "\n".join(lines)


def _copying(name, fields):
    """A copy constructor that copies each field by itself."""
    lines = [f"  {name}() = default;", f"  {name}(const {name} &Other) {{"]
    for field in fields:
        if isinstance(field.type, Array):
            lines.append(f"    for (int I = 0; I != {field.type.count}; ++I)")
            lines.append(f"      {field.name}[I] = Other.{field.name}[I];")
        else:
            lines.append(f"    {field.name} = Other.{field.name};")
    return lines + [
        "  }",
        f"  {name} &operator=(const {name} &) = default;",
        f"  ~{name}() {{}}",
    ]


def union(generator, number, enumerations):
    """(type, declaration): all members are integers of one size or arrays of
    bytes, so that each may be read after any other was written."""
    name = f"U{number}"
    size = generator.choice((1, 2, 4, 8))
    same = [t for t in INTEGERS if t.bits == size * 8]
    fields = [Field("f0", generator.choice(same)),
              Field("f1", Array("", INTEGERS[1], size))]
    if size > 1 and generator.random() < 0.5:
        part = generator.choice([t for t in INTEGERS if t.bits < size * 8])
        fields.append(Field("f2", Array("", part, size * 8 // part.bits)))
    if generator.random() < 0.5:
        kind = generator.choice([t for t in INTEGERS if t.bits <= size * 8])
        fields.append(Field("f3", kind, generator.randint(1, kind.bits)))
    lines = [f"union {name} {{"]
    lines += ["  " + field.declaration() for field in fields] + ["};"]
    return Structure(name, tuple(fields), is_union=True), "\n".join(lines)


def _mix_field(field, object_name):
    path = f"{object_name}.{field.name}"
    if isinstance(field.type, Array):
        return [f"  for (int I = 0; I != {field.type.count}; ++I)",
                f"    mix(Checksum, ({field.type.element.name}){path}[I]);"
                if not isinstance(field.type.element, Structure) else
                f"    mix(Checksum, {path}[I]);"]
    if isinstance(field.type, Structure):
        return [f"  mix(Checksum, {path});"]
    return [f"  mix(Checksum, ({field.type.name}){path});"]


def checksum(kind):
    """mix() of a type that is no number."""
    head = f"inline void mix(uint32_t &Checksum, const {kind.name} &Value) {{"
    if isinstance(kind, Enumeration):
        return f"{head}\n  mix(Checksum, ({kind.underlying.name})Value);\n}}"
    if isinstance(kind, Integer):
        lines = [f"inline void mix(uint32_t &Checksum, {kind.name} Value) {{"]
        lines += [f"  mix(Checksum, (uint64_t)(Value >> {shift}));"
                  for shift in range(0, kind.bits, 64)]
        return "\n".join(lines + ["}"])
    if isinstance(kind, Vector):
        return (f"{head}\n  for (int I = 0; I != {kind.count}; ++I)\n"
                f"    mix(Checksum, Value[I]);\n}}")
    lines = [head]
    # Of a union, the bytes say everything.
    fields = kind.fields[:1] if kind.is_union else kind.fields
    for field in fields:
        lines += _mix_field(field, "Value")
    return "\n".join(lines + ["}"])


def has_wide_vector(kind):
    """GCC does not align what is wider than a register."""
    if isinstance(kind, Array):
        return has_wide_vector(kind.element)
    if isinstance(kind, Structure):
        return any(has_wide_vector(field.type) for field in kind.fields)
    return isinstance(kind, Vector) and kind.count * kind.element.bits > 128


def layout_check(kind):
    """Statements that add the layout to the checksum: sizes, and the bytes
    that each plain field occupies."""
    if has_wide_vector(kind):
        return []
    name = kind.name
    lines = [f"  mix(Total, (uint64_t)sizeof({name}));",
             f"  mix(Total, (uint64_t)alignof({name}));"]
    if kind.is_nontrivial:
        return lines
    for field in kind.fields:
        if isinstance(field.type, Array):
            lines.append(f"  mix(Total, (uint64_t)offsetof({name}, "
                         f"{field.name}));")
        elif isinstance(field.type, (Integer, Enumeration)):
            lines += [
                "  {", f"    {name} Value;",
                "    __builtin_memset((void *)&Value, 0, sizeof(Value));",
                f"    Value.{field.name} = ({field.type.name})-1;",
                "    mixBytes(Total, &Value, sizeof(Value));", "  }",
            ]
    return lines
