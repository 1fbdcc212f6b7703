# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds out whether configurations are good or bad, several at a time."""

import hashlib
import json
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from enum import Enum

from tp_bisect.errors import NothingToFind, UserError
from tp_bisect.oracle import SKIP_STATUS

_SHOWN_LINES = 20


class Outcome(str, Enum):
    """What a configuration is."""

    GOOD = "good"
    BAD = "bad"
    UNRESOLVED = "unresolved"


@dataclass(frozen=True)
class Verdict:
    """An outcome and why."""

    outcome: Outcome
    reason: str = ""

    @property
    def is_bad(self):
        """True or False; None if it could not be judged."""
        if self.outcome is Outcome.UNRESOLVED:
            return None
        return self.outcome is Outcome.BAD


@dataclass(frozen=True)
class Baseline:
    """What was found of the good and the bad build."""

    bad_reason: str


class Evaluator:
    """Builds, tests and remembers."""

    def __init__(self, request, builder, oracle, state, progress):
        self._request = request
        self._builder = builder
        self._oracle = oracle
        self._state = state
        self._progress = progress
        self._pool = ThreadPoolExecutor(max_workers=request.jobs)
        self._background = ThreadPoolExecutor(max_workers=1)
        self._futures = {}
        self._by_program = {}
        self._lock = threading.Lock()
        self.failed_builds = []

    @property
    def jobs(self):
        """How many configurations are judged at a time."""
        return self._request.jobs

    def close(self):
        """Waits for nothing more."""
        for pool in (self._pool, self._background):
            pool.shutdown(wait=True, cancel_futures=True)

    def in_background(self, function, *arguments):
        """Begins a part of the search whose result is wanted later; it shares
        the builds that run at a time. Gives a future."""
        return self._background.submit(function, *arguments)

    # The two ends of the search ------------------------------------------

    def check_baseline(self, good, bad):
        """Sees to it that good is good and bad is bad, each time."""
        builds = list(self._pool.map(self._build, (good, bad)))
        try:
            return self._check_built(*builds)
        finally:
            self._discard(*builds)

    def _check_built(self, good, bad):
        for name, build in (("good", good), ("bad", bad)):
            if build.finished.status or build.finished.timed_out:
                raise UserError(
                    f"the build with the {name} flags failed "
                    f"({build.finished.describe_status()}):\n"
                    + _shown_output(build.finished)
                )
        self._oracle.reference = self._first_good(good)
        good_complaints = [self._oracle.complaint(self._oracle.reference)]
        good_complaints += self._complaints(good, self._request.repeat - 1)
        bad_complaints = self._complaints(bad, self._request.repeat)
        self._refuse_chance("good", good_complaints)
        if good_complaints[0]:
            raise UserError(
                "the test fails for the good build, too: "
                f"{good_complaints[0]}; good flags have to be good"
            )
        self._refuse_chance("bad", bad_complaints)
        if not bad_complaints[0]:
            raise NothingToFind(
                "the test finds nothing wrong with the bad build; there is "
                "nothing to find"
            )
        fingerprint = self._fingerprint(good, bad)
        if fingerprint and self._state.open(fingerprint):
            self._progress.phase("going on from an earlier search")
        return Baseline(bad_complaints[0])

    def _first_good(self, build):
        seen = self._oracle.observe(build)
        self._progress.count(tests=1)
        missing = seen.missing_file()
        if missing:
            raise UserError(
                f"the test of the good build ({seen.finished.describe_status()}) "
                f"does not write '{missing}'" + _indented(seen.finished.stderr)
            )
        if seen.finished.timed_out:
            raise UserError(
                f"the test of the good build does not end in "
                f"{self._request.test_timeout} s; see --test-timeout"
            )
        return seen

    def _complaints(self, build, count):
        complaints = []
        for _ in range(count):
            complaints.append(self._oracle.complaint(self._oracle.observe(build)))
            self._progress.count(tests=1)
        return complaints

    def _refuse_chance(self, name, complaints):
        if len({bool(c) for c in complaints}) > 1:
            raise UserError(
                f"the test is not deterministic: of {len(complaints)} runs of "
                f"the {name} build {sum(map(bool, complaints))} failed; fix its "
                "seed, its threads or its inputs first"
            )

    def _fingerprint(self, good, bad):
        r = self._request
        hashes = [good.output_hash(), bad.output_hash()]
        if None in hashes:
            return None
        parts = [r.build, r.test, r.compare_output, r.compare_image]
        parts += [r.compare_memory, r.tolerance, r.flags_variable, hashes]
        return hashlib.sha256(json.dumps(parts).encode()).hexdigest()

    # Single configurations -----------------------------------------------

    def judge(self, configuration):
        """The verdict on one configuration."""
        return self.judge_all([configuration])[0]

    def judge_all(self, configurations):
        """The verdicts on several."""
        futures = [self.begin(configuration) for configuration in configurations]
        return [future.result() for future in futures]

    def begin(self, configuration):
        """Begins to judge it, unless that is done; gives a future."""
        key = configuration.key()
        with self._lock:
            if key not in self._futures:
                self._futures[key] = self._pool.submit(self._judge, configuration)
            return self._futures[key]

    def are_bad(self, configurations):
        """For each whether it is bad; None if that cannot be said."""
        return [verdict.is_bad for verdict in self.judge_all(configurations)]

    def build_log(self, configuration):
        """What a build of it prints; None if it fails."""
        build = self._build(configuration)
        self._discard(build)
        if build.finished.status or build.finished.timed_out:
            self.failed_builds.append(_shown_output(build.finished))
            return None
        return (build.finished.stderr + build.finished.stdout).decode(
            errors="replace"
        )

    def with_program(self, configuration, use):
        """Builds it and hands the program to `use`; None if there is none."""
        build = self._build(configuration)
        try:
            return use(build.output) if build.output.is_file() else None
        finally:
            self._discard(build)

    def _judge(self, configuration):
        key = configuration.key()
        stored = self._state.get(key)
        if stored:
            self._progress.count(reused=1)
            return Verdict(Outcome(stored["outcome"]), stored["reason"])
        build = self._build(configuration)
        try:
            verdict = self._judge_built(build)
        finally:
            self._discard(build)
        # What could not be judged may work the next time.
        if verdict.is_bad is not None:
            self._state.put(key, asdict(verdict))
        return verdict

    def _judge_built(self, build):
        if build.finished.status or build.finished.timed_out:
            text = _shown_output(build.finished)
            self.failed_builds.append(text)
            return Verdict(Outcome.UNRESOLVED, "the build failed:\n" + text)
        program = build.output_hash()
        with self._lock:
            known = self._by_program.get(program)
        if program and known:
            return known
        seen = self._oracle.observe(build)
        self._progress.count(tests=1)
        if not self._oracle.compares and seen.finished.status == SKIP_STATUS:
            verdict = Verdict(Outcome.UNRESOLVED, "the test said: skip")
        else:
            complaint = self._oracle.complaint(seen)
            outcome = Outcome.BAD if complaint else Outcome.GOOD
            verdict = Verdict(outcome, complaint or "")
        with self._lock:
            self._by_program[program] = verdict
        return verdict

    def _build(self, configuration):
        build = self._builder.build(configuration)
        self._progress.count(builds=1)
        return build

    def _discard(self, *builds):
        for build in builds:
            build.discard()


def _indented(text):
    lines = text.decode(errors="replace").splitlines()[-_SHOWN_LINES:]
    return "".join(f"\n  {line}" for line in lines)


def _shown_output(finished):
    return _indented(finished.stdout + finished.stderr).lstrip("\n")
