# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The C++ program that evaluates functions in every context."""

import math

CONTEXTS = (
    "called", "in a loop", "unrolled", "constant arguments", "by pointer",
)
UNROLLED = 2
# Inputs that are also compiled as constants, the first ones.
CONSTANT_SETS = 1


def literal(value, real):
    suffix = "f" if real == "float" else ""
    if math.isnan(value):
        return f"__builtin_nan{suffix}(\"\")"
    if math.isinf(value):
        sign = "-" if value < 0 else ""
        return f"{sign}__builtin_inf{suffix}()"
    return value.hex() + suffix


def initializers(function):
    return "".join(
        f"    {initializer(values, function.type)},\n"
        for values in function.inputs
    )


def initializer(values, real):
    """Of an Input."""
    numbers = [literal(value, real) for value in values[:-1]]
    scalars, vector, memory = numbers[:4], numbers[4:7], numbers[7:]
    return (
        f"{{{', '.join(scalars)}, {{{', '.join(vector)}}}, "
        f"{{{{{', '.join(memory)}}}}}, {values[-1]}}}"
    )


def definition(function):
    return f"""\
static Real e{function.number}(Real a, Real b, Real c, Real d,
    const Vector<Real> &s, Real *p, Real *q, int n) {{
{function.body()}
}}
"""


def call(function, varying, constant):
    """Of the function, with the parameters that vary from Each."""
    arguments = [
        f"{'each' if name in varying else constant}.{name}"
        for name in ("a", "b", "c", "d", "s")
    ]
    return (
        f"e{function.number}({', '.join(arguments)}, m.Values, "
        f"m.Values + 1, {constant}.n)"
    )


def memory(varying, constant):
    owner = "each" if "m" in varying else constant
    return f"Memory<Real> m = {owner}.m;"


def driver(function, numbers):
    """The function that evaluates a function in every context, for the inputs
    of these numbers."""
    number, varying = function.number, function.varying
    hoisted = ("a", "b", "c", "d", "s")
    constants = "\n".join(
        f"""\
    case {k}: {{
      constexpr Input<Real> in = {initializer(values, function.type)};
      {memory((), 'in')}
      [[clang::always_inline]] r = {call(function, (), 'in')};
      break;
    }}"""
        for k, values in enumerate(function.inputs[:CONSTANT_SETS])
        if k in numbers
    )
    locals_ = "".join(
        f" auto {name} = in.{name};" for name in hoisted if name not in varying
    )
    arguments = ", ".join(
        f"each.{name}" if name in varying else name for name in hoisted
    )
    return f"""\
static Input<Real> inputs{number}[] = {{
{initializers(function)}}};
static void run{number}() {{
  auto pointer = opaque(&e{number});
  const int numbers[] = {{{', '.join(map(str, numbers))}}};
  for (int k : numbers) {{
    const Input<Real> &in = *opaque(&inputs{number}[k]);
    Line line({number}, k);
    Real direct, r;
    {{
      {memory((), 'in')}
      [[clang::noinline]] direct = {call(function, (), 'in')};
    }}
    line.value(direct);
    Input<Real> copies[{UNROLLED + 1}];
    for (int i = 0; i != {UNROLLED + 1}; ++i)
      copies[i] = in;
    const Input<Real> *all = opaque(&copies[0]);
    {{
      Real values[{UNROLLED + 1}], related = 0;
      int count = opaque({UNROLLED + 1});
      int n = in.n;{locals_}
      for (int i = 0; i < count; ++i) {{
        const Input<Real> &each = all[i];
        {memory(varying, 'in')}
        [[clang::always_inline]] r =
            e{number}({arguments}, m.Values, m.Values + 1, n);
        values[i] = r;
        related = r / in.b;
      }}
      use(related);
      line.values(values, count, direct);
    }}
    {{
      Real values[{UNROLLED}];
#pragma unroll
      for (int i = 0; i < {UNROLLED}; ++i) {{
        const Input<Real> &each = all[i];
        {memory(varying or {'m'}, 'in')}
        [[clang::always_inline]] r = {call(function, varying, 'in')};
        values[i] = r;
      }}
      line.values(values, {UNROLLED}, direct);
    }}
    r = direct;
    switch (k) {{
{constants}
    }}
    line.value(r);
    {memory((), 'in')}
    line.value(pointer(in.a, in.b, in.c, in.d, in.s, m.Values, m.Values + 1,
                       in.n));
  }}
}}
"""


def group(function, parts):
    """In a namespace where Real is the function's type."""
    return (
        f"namespace n{function.number} {{\nusing Real = {function.type};\n"
        f"{parts}}} // namespace n{function.number}\n\n"
    )


def program(functions, excepted):
    """Prints a line per function and input: harness.h says which. Does not
    evaluate the excepted (function, input)."""
    groups, calls = [], []
    for f in functions:
        numbers = [
            k for k in range(len(f.inputs)) if (f.number, k) not in excepted
        ]
        if numbers:
            groups.append(group(f, definition(f) + driver(f, numbers)))
            calls.append(f"  n{f.number}::run{f.number}();\n")
    return (
        f'#include "harness.h"\n\n{"".join(groups)}'
        f'int main() {{\n{"".join(calls)}}}\n'
    )


def range_check(functions):
    """Prints what each evaluation meets in IEEE arithmetic: function, input,
    Range."""
    parts = []
    for f in functions:
        parts.append(
            f"""\
namespace n{f.number} {{
using Real = Checked<{f.type}>;
{definition(f)}
static void run{f.number}() {{
  Input<Real> inputs[] = {{
{initializers(f)}  }};
  for (int k = 0; k != {len(f.inputs)}; ++k) {{
    Input<Real> &in = inputs[k];
    MetRange = Ordinary;
    in.a.used(), in.b.used(), in.c.used(), in.d.used();
    e{f.number}(in.a, in.b, in.c, in.d, in.s, in.m.Values, in.m.Values + 1,
        in.n).used();
    printf("%x %x %x\\n", {f.number}, k, MetRange);
  }}
}}
}} // namespace n{f.number}
"""
        )
    calls = "\n".join(f"  n{f.number}::run{f.number}();" for f in functions)
    return (
        '#include "checked.h"\n#include "harness.h"\n\n'
        + "\n".join(parts)
        + f"\nint main() {{\n{calls}\n}}\n"
    )
