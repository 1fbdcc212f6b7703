# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds what mends the program while the other flags stay, and tries it."""

import hashlib
import re
from dataclasses import dataclass
from pathlib import Path

from tp_bisect.configuration import Configuration

_PRECISE = "#pragma float_control(precise, on)"
_NO_LITERALS = re.compile(
    r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S
)


@dataclass
class Mending:
    """A change to the source or the flags, and whether a build with it was
    good. Without one `problem` says why."""

    pragmas: tuple = ()
    places: tuple = ()
    flags: tuple = ()
    verified: bool = False
    problem: str = ""


def find_mending(evaluator, bad_flags, units, functions, work_folder):
    """The first of the pragmas, then of the flags, that is good."""
    problem = "no function is known"
    folder = work_folder.resolve() / "mended"
    folder.mkdir(exist_ok=True)
    for pragmas, flags in _pragma_candidates(units):
        problem = _try_pragmas(
            evaluator, bad_flags + flags, pragmas, functions, folder
        )
        if problem is None:
            return Mending(pragmas, _places(functions), flags, verified=True)
    flags = tuple(word for unit in units for word in unit.off_words())
    if flags and _judge(evaluator, bad_flags + flags).is_bad is False:
        return Mending(flags=flags, verified=True, problem=problem)
    return Mending(problem=problem)


def _judge(evaluator, flags, replacements=()):
    return evaluator.judge(
        Configuration(tuple(flags), replacements=tuple(replacements))
    )


def _pragma_candidates(units):
    """Pragmas, with the flags that they need beside the bad ones."""
    own = tuple(dict.fromkeys(u.pragma() for u in units if u.pragma()))
    for pragma in own:
        yield (pragma,), ()
    if len(own) > 1:
        yield own, ()
    settings = {u.setting for u in units}
    if "contract" in settings:
        # Plain `fast` fuses whatever a pragma says.
        yield own, ("-ffp-contract=fast-honor-pragmas",)
    if any(u.setting for u in units):
        yield (_PRECISE,), ()


def _places(functions):
    return tuple(f"{f.file}:{f.line}" for f in functions)


def _try_pragmas(evaluator, flags, pragmas, functions, folder):
    """Builds copies of the sources with the pragmas; None if that is good,
    else what is wrong."""
    if not functions or not all(f.line for f in functions):
        return "the place of the function is not known"
    replacements = []
    for path in dict.fromkeys(f.file for f in functions):
        try:
            text = Path(path).read_text()
        except (OSError, UnicodeDecodeError) as error:
            return f"{path} cannot be read ({error})"
        lines = [f.line for f in functions if f.file == path]
        mended = insert_pragmas(text, lines, pragmas)
        if mended is None:
            return f"no function body is found at {path}:{lines[0]}"
        # By its content: a verdict on it holds in a later search, too.
        name = hashlib.sha256(mended.encode()).hexdigest()[:16]
        copy = folder / f"{name}-{Path(path).name}"
        copy.write_text(mended)
        replacements.append((path, str(copy)))
    verdict = _judge(evaluator, flags, replacements)
    if verdict.is_bad is None:
        return f"a source with a pragma cannot be judged: {verdict.reason}"
    return "no pragma in the function mends it" if verdict.is_bad else None


def insert_pragmas(text, lines, pragmas):
    """The source with the pragmas at the begin of the bodies of the functions
    that begin in `lines`; None where no body is found."""
    for line in sorted(lines, reverse=True):
        place = body_begin(text, line)
        if place is None:
            return None
        inserted = "\n" + "\n".join(pragmas) + "\n"
        text = text[:place] + inserted + text[place:]
    return text


def body_begin(text, line):
    """The place behind the brace that opens the body of the function that
    begins in a line."""
    begin = 0
    for _ in range(line - 1):
        begin = text.find("\n", begin) + 1
        if not begin:
            return None
    blank = _NO_LITERALS.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
    depth = 0
    for place in range(begin, len(blank)):
        char = blank[place]
        if char in "([":
            depth += 1
        elif char in ")]":
            depth -= 1
        elif char == ";" and depth == 0:
            return None
        elif char == "{" and depth == 0:
            return place + 1
    return None
