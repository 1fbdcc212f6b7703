# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The search from flags to the instruction."""

from dataclasses import dataclass, field

from tp_bisect.configuration import Configuration
from tp_bisect.delta import minimize
from tp_bisect.disassembly import disassemble
from tp_bisect.errors import UserError
from tp_bisect.flags import FlagSpace, Unit
from tp_bisect.mending import Mending, find_mending
from tp_bisect.passes import PassStep, find_pass, machine_code_changes
from tp_bisect.places import PlaceSearch, find_places


@dataclass
class GuiltyFlag:
    """A unit of the smallest guilty set and where it comes from."""

    unit: Unit
    origin: str = ""
    overridden: str = ""


@dataclass
class Findings:
    """All that the search found out."""

    bad_reason: str = ""
    considered: int = 0
    flags: list = field(default_factory=list)
    user_flags: list = field(default_factory=list)
    user_flags_bad: bool = False
    rest_is_good: bool = None
    places: PlaceSearch = field(default_factory=PlaceSearch)
    step: PassStep = field(default_factory=PassStep)
    machine_code: list = field(default_factory=list)
    mending: Mending = field(default_factory=Mending)
    step_command: str = ""
    failed_builds: list = field(default_factory=list)


def _configuration(space, units):
    return Configuration(tuple(space.render(units)))


class Search:
    """Carries the search out, part by part."""

    def __init__(self, request, compiler, evaluator, builder, runner, progress):
        self._request = request
        self._compiler = compiler
        self._evaluator = evaluator
        self._builder = builder
        self._runner = runner
        self._progress = progress

    def run(self):
        """From the check of the ends to the mending."""
        request = self._request
        self._progress.phase("building with the good and the bad flags")
        space = FlagSpace(
            request.good,
            request.bad,
            self._compiler.settings(request.good),
            self._compiler.settings(request.bad),
        )
        baseline = self._evaluator.check_baseline(
            Configuration(tuple(request.good)), Configuration(tuple(request.bad))
        )
        found = Findings(bad_reason=baseline.bad_reason, considered=len(space.units))
        guilty = self._find_flags(space, found)
        self._find_culprit(space, guilty, found)
        found.failed_builds = list(self._evaluator.failed_builds)
        return found

    def _find_culprit(self, space, guilty, found):
        """What the guilty flags break, and what mends it."""
        rest = [unit for unit in space.units if unit not in guilty]
        without = self._evaluator.begin(_configuration(space, rest))
        if any(unit.acts_on_instructions() for unit in guilty):
            self._find_places(_configuration(space, guilty), found)
        found.rest_is_good = without.result().is_bad is False
        # Where more is guilty, mending this does not make all good.
        flags = self._request.bad if found.rest_is_good else found.user_flags
        mending = self._evaluator.in_background(
            find_mending,
            self._evaluator,
            tuple(flags),
            guilty,
            found.places.functions,
            self._request.work_folder,
        )
        if all(unit.macro() for unit in guilty):
            found.step = PassStep(problem="macros are gone before any pass")
        else:
            self._find_step(_configuration(space, guilty), found)
        found.mending = mending.result()

    # Flags ------------------------------------------------------------------

    def _find_flags(self, space, found):
        if not space.units:
            raise UserError(
                "the compiler makes the same of the good and the bad flags"
            )
        self._progress.phase(f"searching {len(space.units)} flags")
        self._check_ends(space)

        guilty = minimize(
            space.units,
            self._evaluator.jobs,
            lambda candidates: self._evaluator.are_bad(
                [_configuration(space, c) for c in candidates]
            ),
        )
        guilty = self._without_leaders(space, guilty)
        found.flags = [self._describe_unit(unit) for unit in guilty]
        found.user_flags = space.write_for_user(guilty)
        found.user_flags_bad = self._are_user_flags_bad(space, guilty, found)
        return guilty

    def _without_leaders(self, space, guilty):
        """The company of a setting in its place, where that is bad alone."""
        if len(guilty) != 1:
            return guilty
        company = [[u] for u in space.units if guilty[0].brings(u)]
        verdicts = self._evaluator.are_bad(
            [_configuration(space, c) for c in company]
        )
        return next((c for c, bad in zip(company, verdicts) if bad), guilty)

    def _are_user_flags_bad(self, space, guilty, found):
        if self._is_same(found.user_flags, space.render(guilty)):
            return True
        user = Configuration(tuple(found.user_flags))
        return bool(self._evaluator.judge(user).is_bad)

    def _is_same(self, flags, others):
        """Whether the compiler makes the same of both, as far as settings go."""
        return self._compiler.settings(flags) == self._compiler.settings(others)

    def _check_ends(self, space):
        ends = (
            ("good", space.good_words, space.render([])),
            ("bad", space.bad_words, space.render(space.units)),
        )
        for name, words, rendered in ends:
            if self._is_same(words, rendered):
                continue
            verdict = self._evaluator.judge(Configuration(tuple(rendered)))
            if verdict.outcome != name:
                raise UserError(
                    f"the {name} flags, taken apart, are not {name} any more"
                    + (f": {verdict.reason}" if verdict.reason else "")
                )

    def _describe_unit(self, unit):
        if not unit.setting:
            return GuiltyFlag(unit)
        bad, name, value = self._request.bad, unit.setting, unit.value
        origin = self._compiler.origin(bad, name, value)
        overridden = self._compiler.overridden_word(bad, origin, name, value)
        return GuiltyFlag(unit, origin, overridden)

    # Places -----------------------------------------------------------------

    def _find_places(self, configuration, found):
        problem = self._compiler.scope_problem()
        if problem:
            found.places = PlaceSearch(problem=problem)
            return
        self._progress.phase("making parts of the program strict")
        found.places = find_places(
            self._evaluator,
            self._progress,
            configuration,
            self._request.work_folder.resolve(),
        )

    # Pass -------------------------------------------------------------------

    def _find_step(self, configuration, found):
        scope = found.places.scope()
        if scope is not None:
            configuration = configuration.with_scope(scope)
        functions = found.places.functions
        found.step = find_pass(
            self._evaluator, self._progress, configuration, found.places
        )
        step = found.step
        if step.configuration is None:
            return
        found.step_command = self._keep_command(step.configuration)
        words = self._compiler.disassembler()
        if not step.changes and functions and words:
            found.machine_code = machine_code_changes(
                self._evaluator,
                lambda program, function: disassemble(
                    self._runner, words, program, function
                ),
                step,
                functions,
            )

    def _keep_command(self, configuration):
        """The command that shows the step again; its scope file stays."""
        folder = self._request.work_folder.resolve()
        return self._builder.command_line(configuration, folder)
