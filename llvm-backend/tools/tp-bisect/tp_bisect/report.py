# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The report, as text and as JSON."""

import json
import os
import shlex
from dataclasses import asdict
from pathlib import Path

_INDENT = "  "


def to_json(found, request, progress):
    """The findings as JSON."""
    step = asdict(found.step)
    del step["configuration"]
    return json.dumps(
        {
            "good": request.good,
            "bad": request.bad,
            "reason": found.bad_reason,
            "flags": [
                {
                    "flag": guilty.unit.title(),
                    "words": guilty.unit.user_words(),
                    "setting": guilty.unit.setting,
                    "origin": guilty.origin,
                    "overridden": guilty.overridden,
                }
                for guilty in found.flags
            ],
            "smallest_bad_flags": found.user_flags,
            "good_without_them": found.rest_is_good,
            "functions": [asdict(f) for f in found.places.functions],
            "front_end": found.places.is_front_end,
            "places_problem": found.places.problem,
            "step": step,
            "machine_code": found.machine_code,
            "mending": asdict(found.mending),
            "failed_builds": found.failed_builds,
            "builds": progress.builds,
            "tests": progress.tests,
            "seconds": round(progress.seconds(), 1),
        },
        indent=2,
    )


def to_text(found, request, progress):
    """The findings for a person."""
    sections = [
        _flags_section(found),
        _places_section(found, request),
        _step_section(found),
        _mending_section(found, request),
    ]
    lines = [f"bad: {found.bad_reason}", ""]
    for section in sections:
        lines += section + [""]
    if found.failed_builds:
        lines += [
            f"{len(found.failed_builds)} builds failed and were taken for neither "
            "good nor bad; the first:",
            found.failed_builds[0],
            "",
        ]
    lines.append(f"({progress.summary()})")
    return "\n".join(lines) + "\n"


def _flags_section(found):
    names = " ".join(guilty.unit.title() for guilty in found.flags)
    lines = [f"guilty flag: {names}  (of {found.considered} differences)"]
    for guilty in found.flags:
        lines += _flag_lines(guilty)
    if found.user_flags_bad:
        lines.append(f"smallest bad flags: {shlex.join(found.user_flags)}")
    if not found.rest_is_good:
        lines.append(
            "without it the bad flags are bad still: another flag is guilty, too; "
            "search again when this one is mended"
        )
    return [lines[0]] + [_INDENT + line for line in lines[1:]]


def _flag_lines(guilty):
    unit = guilty.unit
    lines = [f"{unit.title()}: {unit.meaning()}"]
    if unit.setting and not guilty.origin:
        lines[0] += "; it is the compiler's default"
    elif unit.setting and guilty.origin != unit.title():
        lines[0] += f"; {guilty.origin} turns it on"
    company = unit.user_words()[1:]
    if company and unit.setting:
        lines.append(
            f"alone the driver ignores it: it wants {' '.join(company)} as well"
        )
    if guilty.overridden:
        lines.append(
            f"order: {guilty.overridden} stands before {guilty.origin}, which "
            "overrides it; put it last"
        )
    return lines


def _places_section(found, request):
    places = found.places
    if places.is_front_end:
        return [
            "guilty function: none; the program is bad with every instruction "
            "strict",
            _INDENT + "the flag acts before or beside the code: in what the front "
            "end folds, in start-up code",
        ]
    if not places.functions:
        macros = [g.unit.macro() for g in found.flags if g.unit.macro()]
        return (
            _macro_lines(macros, request)
            or _changed_lines(found.step)
            or [f"guilty function: not found: {places.problem}"]
        )
    lines = []
    for function in places.functions:
        lines.append(
            f"guilty function: {function.name}  (1 of {len(places.known)})"
        )
        lines += [_INDENT + line for line in _item_lines(function)]
    return lines


def _macro_lines(macros, request):
    """Where the sources that the build command names test a macro."""
    lines = []
    for path in filter(os.path.isfile, shlex.split(request.build)):
        text = Path(path).read_text(errors="replace").splitlines()
        for number, line in enumerate(text, 1):
            if any(macro in line for macro in macros):
                lines.append(f"{_INDENT}{path}:{number}: {line.strip()}")
    if macros:
        where = "tested here:" if lines else "tested in a header"
        lines.insert(
            0, f"guilty function: none, but the macro {macros[0]}, {where}"
        )
    return lines


def _changed_lines(step):
    """The functions that the guilty pass changed, and the first place."""
    lines = []
    for change in step.changes:
        touched = [x for x in change.diff if x[:1] in "+-" and "  ; " in x]
        lines.append(f"guilty function: {change.function}, which the pass changed")
        if touched:
            lines.append(f"{_INDENT}at {touched[0].rsplit('  ; ', 1)[1]}")
    return lines


def _item_lines(function):
    lines = []
    if not function.items[0].line:
        lines.append(f"{function.file}:{function.line}")
    for item in function.items:
        if item.what == "promises":
            lines.append("what it promises of its parameters and its result")
            continue
        flags = f" {item.flags}" if item.flags else ""
        lines.append(f"guilty instruction: {item.what}{flags}")
        if item.place():
            lines.append(f"at {item.place()}")
            lines += _source_lines(item.file, item.line, item.column)
    return lines


def _source_lines(path, line, column):
    try:
        text = Path(path).read_text(errors="replace").splitlines()[line - 1]
    except (OSError, IndexError):
        return []
    number = f"{line} | "
    blank = "".join("\t" if c == "\t" else " " for c in text[: max(column - 1, 0)])
    return [number + text, " " * len(number) + blank + "^"]


def _step_section(found):
    step = found.step
    if not step.kind:
        return [f"guilty pass: not found: {step.problem}"]
    if step.kind == "pass":
        lines = [f"guilty pass: step {step.number} of {step.total}: {step.description}"]
        if step.last_good != step.number - 1:
            lines.append(
                f"steps {step.last_good + 1} to {step.number - 1} could not be judged"
            )
    else:
        lines = [f"guilty pass: {step.description}"]
    if found.step_command:
        lines.append("again: " + found.step_command)
    for change in step.changes:
        lines.append(f"IR of {change.function} before (-) and after (+):")
        lines += [_INDENT + line for line in change.diff]
    for function, diff in found.machine_code:
        lines.append(f"machine code of {function}, good (-) and bad (+):")
        lines += [_INDENT + line for line in diff]
    return [lines[0]] + [_INDENT + line for line in lines[1:]]


def _mending_section(found, request):
    mending = found.mending
    if not mending.verified:
        return [f"mending: none that could be verified: {mending.problem}"]
    base = request.bad if found.rest_is_good else found.user_flags
    lines = [f"mending, verified by a good build with {shlex.join(base)}:"]
    for place in mending.places:
        lines.append(f"at the begin of the body of the function at {place}:")
        lines += [_INDENT + pragma for pragma in mending.pragmas]
    if mending.flags:
        lines.append(f"behind these flags: {shlex.join(mending.flags)}")
    return [lines[0]] + [_INDENT + line for line in lines[1:]]
