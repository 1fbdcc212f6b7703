# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Which functions, and which of their instructions, have to have fast math for
the program to be bad."""

import json
from dataclasses import dataclass, replace

from tp_bisect.configuration import ScopeEntry
from tp_bisect.delta import minimize

EVERYTHING = (ScopeEntry(),)
LINE_TABLES = "-gline-tables-only"


@dataclass(frozen=True)
class Item:
    """Something that fast math may change: see ScopeList.h."""

    number: int
    what: str
    flags: str
    file: str = ""
    line: int = 0
    column: int = 0

    def place(self):
        """`file:line:column`; empty if it is not known."""
        if not self.line:
            return ""
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True)
class Function:
    """A function with the items that matter."""

    source: str
    function: str
    name: str
    local: bool
    items: tuple
    file: str = ""
    line: int = 0

    def entry(self):
        """What keeps fast math in all its items."""
        return ScopeEntry(self.source if self.local else "*", self.function)

    def entry_of(self, items):
        """What keeps it in some."""
        return replace(self.entry(), items=tuple(i.number for i in items))


def read_list(text):
    """The functions of a list that the scope pass has written; a function that
    several sources have, such as a template's, stands once for each."""
    functions = []
    for line in text.splitlines():
        entry = json.loads(line)
        items = tuple(
            Item(number, **item) for number, item in enumerate(entry.pop("items"))
        )
        functions.append(Function(items=items, **entry))
    return functions


def with_line_tables(flags):
    """Flags with which instructions know their lines."""
    if any(word.startswith("-g") and word != "-g0" for word in flags):
        return flags
    return (*flags, LINE_TABLES)


@dataclass
class PlaceSearch:
    """What the search by scope has found, among the functions known by their
    mangled names. `problem` says why it found nothing;
    `is_front_end` that the program is bad even with all instructions strict."""

    functions: tuple = ()
    known: frozenset = frozenset()
    problem: str = ""
    is_front_end: bool = False

    def scope(self):
        """The smallest scope that is bad; None if none was found."""
        if not self.functions:
            return None
        return tuple(f.entry_of(f.items) for f in self.functions)


def find_places(evaluator, progress, configuration, folder):
    """Searches source files, then functions, then instructions. `folder` gets
    the list of what there is."""
    path = folder / "items.jsonl"
    path.unlink(missing_ok=True)
    listing = replace(
        configuration.with_scope(EVERYTHING),
        flags=with_line_tables(configuration.flags),
        options=(f"-tp-fp-scope-list={path}",),
    )
    verdicts = evaluator.judge_all([listing, configuration.with_scope(())])
    problem = _problem_of_ends(*verdicts)
    if problem:
        return problem
    if not path.exists():
        evaluator.build_log(listing)
    functions = read_list(path.read_text()) if path.exists() else []
    if not functions:
        return PlaceSearch(
            problem="the build compiled nothing that fast math may change; it "
            "has to compile every time"
        )
    return _narrow(evaluator, progress, configuration, functions)


def _problem_of_ends(whole, none):
    """Why there is nothing to search between all and nothing; None if there
    is."""
    for verdict in (whole, none):
        if verdict.is_bad is None:
            return PlaceSearch(problem=verdict.reason)
    if not whole.is_bad:
        return PlaceSearch(
            problem="with the scope pass in the compiler the program is good"
        )
    return PlaceSearch(is_front_end=True) if none.is_bad else None


def _narrow(evaluator, progress, configuration, functions):
    def guilty_of(candidates, to_entries):
        return minimize(
            candidates,
            evaluator.jobs,
            lambda chosen: evaluator.are_bad(
                [configuration.with_scope(to_entries(c)) for c in chosen]
            ),
        )

    sources = sorted({f.source for f in functions})
    if len(sources) > 1:
        progress.phase(f"searching {len(sources)} source files")
        sources = guilty_of(sources, lambda c: [ScopeEntry(s) for s in c])
    unique = {f.entry(): f for f in functions if f.source in sources}
    progress.phase(f"searching {len(unique)} functions")
    entries = guilty_of(list(unique), list)
    places = [(unique[e], item) for e in entries for item in unique[e].items]
    progress.phase(f"searching {len(places)} instructions")
    places = guilty_of(places, _entries)
    guilty = tuple(
        replace(f, items=tuple(item for g, item in places if g is f))
        for f in dict.fromkeys(f for f, _ in places)
    )
    return PlaceSearch(guilty, frozenset(f.function for f in functions))


def _entries(places):
    by_function = {}
    for function, item in places:
        by_function.setdefault(function, []).append(item)
    return [f.entry_of(items) for f, items in by_function.items()]
