# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Which step of the optimizer makes the program bad, by -opt-bisect-limit."""

import re
from dataclasses import dataclass, replace

from tp_bisect.delta import first_bad_step
from tp_bisect.ir import changes, read_dumps, trimmed_diff
from tp_bisect.places import with_line_tables

_STEP = re.compile(r"^BISECT: (?:NOT )?running pass \((\d+)\) (.*)$", re.M)
_NUMBERED = re.compile(r"^ *Running pass (\d+) (\S+) on (.*)$")
_REWRITING = (
    "aggressive-instcombine early-cse gvn instcombine instsimplify ipsccp licm "
    "loop-vectorize machine-combiner nary-reassociate reassociate sccp "
    "slp-vectorizer vector-combine"
).split()
_CANONICALIZER = "FloatingPointCanonicalizerPass"
_QUIET = "-opt-bisect-verbose=0"
_CONTEXT = 2
_MOST_LINES = 60


@dataclass(frozen=True)
class _Relevant:
    """What a pass changed, and how likely that is what is looked for."""

    relevance: int = 0
    changes: tuple = ()


_NO_CHANGE = _Relevant()


@dataclass
class PassStep:
    """The step and what it changed.

    `kind` is `pass`, `canonicalizer`, `code generator` (bad without any
    optional pass) or empty, then `problem` says why.
    """

    kind: str = ""
    problem: str = ""
    number: int = 0
    last_good: int = 0
    total: int = 0
    description: str = ""
    changes: tuple = ()
    configuration: object = None


def find_pass(evaluator, progress, configuration, places):
    """Searches the step that makes a bad configuration bad."""
    functions = places.functions
    base = replace(
        configuration,
        flags=(*with_line_tables(configuration.flags), "-fno-discard-value-names"),
    )
    progress.phase("counting the optimizer's steps")
    quiet = base.with_options(_QUIET)
    without = evaluator.begin(quiet.with_last_pass(0))
    log = evaluator.build_log(base.with_last_pass(-1))
    steps = [(int(n), what) for n, what in _STEP.findall(log or "")]
    if not steps:
        return PassStep(problem="the build prints no optimizer steps")
    total, _ = max(steps)
    without = without.result()
    if without.is_bad:
        return _find_required(evaluator, progress, base, total, functions)
    if without.is_bad is None:
        return PassStep(problem=without.reason, total=total)
    progress.phase(f"searching {total} optimizer steps")

    def judge_all(numbers):
        progress.detail(f"{numbers[0]}..{numbers[-1]}")
        return evaluator.are_bad([quiet.with_last_pass(n) for n in numbers])

    number, last_good = first_bad_step(
        0, total, evaluator.jobs, judge_all, _weights(steps, places.known)
    )
    if number == total and not judge_all([total])[0]:
        return PassStep(
            problem="with line tables and value names the program is good",
            total=total,
        )
    found = PassStep("pass", "", number, last_good, total)
    found.configuration = base.with_last_pass(number)
    _describe(evaluator, progress, found, functions)
    return found


def _weights(steps, known_functions):
    """How likely each step is the guilty one: passes that rewrite arithmetic,
    and functions in which fast math matters, are likelier."""
    weights = {}
    for number, description in steps:
        weight = 10 if description.split(" ", 1)[0] in _REWRITING else 1
        if description.rsplit(" ", 1)[-1].strip("()") in known_functions:
            weight *= 10
        weights[number] = max(weight, weights.get(number, 1))
    return lambda step: weights.get(step, 1)


def _describe(evaluator, progress, step, functions):
    """Names the step and fetches the IR around it. Where several compilers
    run, each has a step of the number: one that changes a guilty source, or
    anything at all, is the one."""
    progress.phase(f"printing the IR around step {step.number}")
    log = evaluator.build_log(step.configuration.with_options("-print-pass-numbers"))
    lines = (log or "").splitlines()
    wanted = f"BISECT: running pass ({step.number}) "
    found = []
    for line, following in zip(lines, [*lines[1:], ""]):
        if line.startswith(wanted):
            match = _NUMBERED.match(following)
            change = match and _changes_of(
                evaluator, step.configuration, match, functions
            )
            found.append((line[len(wanted) :], change or _NO_CHANGE))
    if found:
        found.sort(key=lambda pair: -pair[1].relevance)
        step.description, change = found[0]
        step.changes = change.changes


def _changes_of(evaluator, configuration, numbered, functions):
    """What a pass, with its number in its pipeline, changed."""
    number, pass_name, unit = numbered.groups()
    log = evaluator.build_log(
        configuration.with_options(
            _QUIET,
            f"-print-before-pass-number={number}",
            f"-print-after-pass-number={number}",
            "-print-module-scope",
        )
    )
    sources = {f.source for f in functions}
    best = _NO_CHANGE
    for dump in read_dumps(log or ""):
        found = changes(dump, _CONTEXT, _MOST_LINES)
        if not found or (dump.pass_name, dump.unit) != (pass_name, unit):
            continue
        # A link has all sources in one module.
        relevance = 2 if dump.before.source in sources else 1
        if relevance > best.relevance:
            best = _Relevant(relevance, _most_relevant(found, functions))
    return best


def _most_relevant(found, functions):
    """Of many changed functions those in which guilty lines are."""
    wanted = [
        f"{item.file.rsplit('/', 1)[-1]}:{item.line}:"
        for f in functions
        for item in f.items
        if item.line
    ]
    touching = [
        change
        for change in found
        if any(
            line[:1] in "+-" and any(place in line for place in wanted)
            for line in change.diff
        )
    ]
    return tuple((touching or found)[:2])


def _find_required(evaluator, progress, base, total, functions):
    """The program is bad without any optional pass: the canonicalizer or the
    code generator does it."""
    progress.phase("bad without optional passes: looking at the others")
    bare = base.with_last_pass(0)
    step = PassStep("code generator", total=total, configuration=bare)
    log = evaluator.build_log(bare.with_options("-print-pass-numbers", _QUIET)) or ""
    passes = [
        match
        for match in map(_NUMBERED.match, log.splitlines())
        if match and match[2] == _CANONICALIZER
    ]
    without = bare.with_options(_QUIET, "-tp-fp-canonicalize=0")
    if passes and not evaluator.judge(without).is_bad:
        step.kind = "canonicalizer"
        step.description = "tp-fp-canonicalize, which rewrites what the flags allow"
        found = [_changes_of(evaluator, bare, p, functions) for p in passes[:1]]
        step.changes = found[0].changes
        return step
    step.description = (
        "none: the program is bad before any optional pass, so by the code "
        "generator or the front end"
    )
    return step


def machine_code_changes(evaluator, disassemble, step, functions):
    """How the guilty functions' machine code differs from that of strict ones;
    `disassemble(program, function)` gives lines."""
    strict = step.configuration.with_options(_QUIET).with_scope(())
    guilty = step.configuration.with_options(_QUIET)

    def code(configuration, function):
        return (
            evaluator.with_program(
                configuration, lambda program: disassemble(program, function)
            )
            or []
        )

    found = []
    for function in functions:
        old, new = (code(c, function.function) for c in (strict, guilty))
        diff = trimmed_diff(old, new, _CONTEXT, _MOST_LINES)
        if diff:
            found.append((function.function, diff))
    return found
