# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Random constants, among them those at the ends of ranges."""

FLOATS = (
    "0.0", "-0.0", "1.0", "-1.0", "0.5", "2.0", "0.1", "-3.75", "1e-3",
    "12345.678", "16777216.0", "2147483648.0", "-2147483648.0", "4294967296.0",
    "9.5e18", "1e-30", "3e38", "65504.0", "65520.0", "6e-8", "1e-39",
)
DOUBLES = FLOATS + ("1e300", "-1e-300", "4.5e15", "9007199254740993.0",
                    "18446744073709551616.0", "5e-324")


def integer(generator, bits, signed):
    """A value that the type holds."""
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if signed else (
        0, (1 << bits) - 1)
    kind = generator.randrange(5)
    if kind == 0:
        return generator.choice((low, high, low + 1, high - 1))
    if kind == 1:
        return generator.randint(low, high)
    if kind == 2:
        value = (1 << generator.randrange(bits)) + generator.choice((-1, 0, 1))
        return min(value, high)
    return max(low, min(high, generator.randint(-16, 64)))


def integer_text(value, bits, signed):
    """As C++; the least value of a type has no literal."""
    if bits > 32:
        if value == -(1 << 63):
            return "(-9223372036854775807ll - 1)"
        return f"{value}{'ll' if signed else 'ull'}"
    if value == -(1 << 31) and bits == 32:
        return "(-2147483647 - 1)"
    return f"{value}{'' if signed or bits < 32 else 'u'}"


def floating(generator, bits, suffix):
    if generator.random() < 0.05:
        return generator.choice(("", "-")) + f"__builtin_inf{suffix}()"
    text = generator.choice(FLOATS if bits == 32 else DOUBLES)
    if generator.random() < 0.5:
        text = f"{generator.uniform(-1000, 1000):.{generator.randint(1, 6)}f}"
    return text + suffix
