# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What two sets of flags differ in, taken apart into primitive settings.

What flags mean is asked of the compiler's driver (`-###`), so that umbrella
flags, their order and the driver's own rules count as they do in a build.
"""

import difflib
import shlex
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Setting:
    """A primitive setting of the floating-point arithmetic or the optimizer.

    `cc1` is the argument of the compiler proper that turns it on; a trailing
    `=` means that it has a value, None that its absence turns it on; `macro`
    is all that there is of it if that is a macro. `render`
    turns it on alone, without the company that the driver wants, and
    `off_render` off, where all of `off_if` would bring it; `words` is
    what a user writes and `off_words` what undoes it. `pragma` undoes it in a
    block. `company` are settings that the driver wants with it.
    """

    name: str
    cc1: str
    render: str
    words: str
    off_words: str
    meaning: str
    off_render: str = ""
    off_if: tuple = ()
    pragma: str = ""
    company: tuple = ()
    macro: str = ""


# First what is seen before the code: a search takes the first that suffices.
SETTINGS = [
    Setting(
        "macro __FINITE_MATH_ONLY__",
        "-ffinite-math-only",
        "-U__FINITE_MATH_ONLY__ -D__FINITE_MATH_ONLY__=1",
        "-ffinite-math-only",
        "-fno-finite-math-only",
        "the macro __FINITE_MATH_ONLY__ is 1",
        off_render="-U__FINITE_MATH_ONLY__ -D__FINITE_MATH_ONLY__=0",
        off_if=("no infinities", "no NaNs"),
        macro="__FINITE_MATH_ONLY__",
    ),
    Setting(
        "macro __FAST_MATH__",
        "-ffast-math",
        "-D__FAST_MATH__=1",
        "-ffast-math",
        "-fno-fast-math",
        "the macro __FAST_MATH__ is defined",
        macro="__FAST_MATH__",
    ),
    Setting(
        "reciprocal",
        "-freciprocal-math",
        "-freciprocal-math",
        "-freciprocal-math",
        "-fno-reciprocal-math",
        "x/y may become x*(1/y)",
        pragma="#pragma clang fp reciprocal(off)",
    ),
    Setting(
        "reassociate",
        "-mreassociate",
        "-Xclang -mreassociate",
        "-fassociative-math -fno-signed-zeros -fno-trapping-math",
        "-fno-associative-math",
        "sums and products may be regrouped",
        pragma="#pragma clang fp reassociate(off)",
        company=("no signed zeros",),
    ),
    Setting(
        "contract",
        "-ffp-contract=",
        "-ffp-contract=",
        "-ffp-contract=",
        "-ffp-contract=",
        "a*b+c may be rounded once",
        pragma="#pragma clang fp contract(off)",
    ),
    Setting(
        "no infinities",
        "-menable-no-infs",
        "-Xclang -menable-no-infs",
        "-fno-honor-infinities",
        "-fhonor-infinities",
        "no value is infinite",
    ),
    Setting(
        "no NaNs",
        "-menable-no-nans",
        "-Xclang -menable-no-nans",
        "-fno-honor-nans",
        "-fhonor-nans",
        "no value is NaN",
    ),
    Setting(
        "no signed zeros",
        "-fno-signed-zeros",
        "-fno-signed-zeros",
        "-fno-signed-zeros",
        "-fsigned-zeros",
        "the sign of a zero does not matter",
    ),
    Setting(
        "approximate functions",
        "-fapprox-func",
        "-fapprox-func",
        "-fapprox-func",
        "-fno-approx-func",
        "math functions may be approximated",
    ),
    Setting(
        "no math errno",
        None,
        "-fno-math-errno",
        "-fno-math-errno",
        "-fmath-errno",
        "math functions do not set errno",
        off_render="-fmath-errno",
    ),
    Setting(
        "flush denormals",
        "crtfastmath.o",
        "-mdaz-ftz",
        "-mdaz-ftz",
        "-mno-daz-ftz",
        "start-up code makes the processor flush denormals to zero",
        off_render="-mno-daz-ftz",
    ),
    Setting(
        "rounding mode",
        "-frounding-math",
        "-frounding-math",
        "-frounding-math",
        "-fno-rounding-math",
        "the rounding mode may change",
    ),
    Setting(
        "exceptions",
        "-ffp-exception-behavior=",
        "-ffp-exception-behavior=",
        "-ffp-exception-behavior=",
        "-ffp-exception-behavior=",
        "how floating-point exceptions count",
    ),
    Setting(
        "complex arithmetic",
        "-complex-range=",
        "-fcomplex-arithmetic=",
        "-fcomplex-arithmetic=",
        "-fcomplex-arithmetic=",
        "how complex numbers are multiplied and divided",
    ),
    Setting(
        "optimization level",
        "-O",
        "-O",
        "-O",
        "-O",
        "which optimizations run",
    ),
]
_BY_NAME = {setting.name: setting for setting in SETTINGS}
# Making instructions strict does not undo these.
_BESIDE_INSTRUCTIONS = [
    "optimization level",
    "flush denormals",
    *(setting.name for setting in SETTINGS if setting.macro),
]
_ERRNO = "-fmath-errno"
# What a value means that the compiler proper is not told.
_IMPLIED_VALUES = {
    "-ffp-contract=": "on",
    "-ffp-exception-behavior=": "maytrap",
    "-complex-range=": "full",
    "-O": "0",
}
# Words that only settings come of.
_SETTING_WORDS = (
    "-ffast-math -fno-fast-math -funsafe-math-optimizations "
    "-fno-unsafe-math-optimizations -fassociative-math -fno-associative-math "
    "-freciprocal-math -fno-reciprocal-math -fsigned-zeros -fno-signed-zeros "
    "-ftrapping-math -fno-trapping-math -ffinite-math-only "
    "-fno-finite-math-only -fhonor-nans -fno-honor-nans -fhonor-infinities "
    "-fno-honor-infinities -fapprox-func -fno-approx-func -fmath-errno "
    "-fno-math-errno -frounding-math -fno-rounding-math -mdaz-ftz "
    "-mno-daz-ftz"
).split()
_SETTING_PREFIXES = (
    "-O",
    "-ffp-contract=",
    "-ffp-model=",
    "-ffp-exception-behavior=",
    "-fcomplex-arithmetic=",
    "-ftp-fp=",
)
_WORDS_WITH_VALUE = (
    "-Xclang -mllvm -include -isystem -iquote -idirafter -I -D -U -L -x "
    "-target -arch -Xlinker -Xassembler -Xpreprocessor"
).split()


def is_setting_word(word):
    """Whether a flag is one that settings are made of."""
    return word in _SETTING_WORDS or word.startswith(_SETTING_PREFIXES)


def read_settings(cc1_words):
    """The settings, by name, that the compiler proper gets."""
    found = {}
    for setting in SETTINGS:
        if setting.cc1 is None:
            found[setting.name] = _ERRNO not in cc1_words
        elif setting.cc1 in _IMPLIED_VALUES:
            found[setting.name] = _value(setting.cc1, cc1_words)
        else:
            found[setting.name] = _is_on(setting, cc1_words)
    return found


def _is_on(setting, words):
    for word in reversed(words):
        if setting.macro and word.startswith(setting.macro + "="):
            return not word.endswith("=0")
    return any(word.endswith(setting.cc1) for word in words)


def _value(prefix, words):
    values = [w[len(prefix) :] for w in words if w.startswith(prefix)]
    value = values[-1] if values else _IMPLIED_VALUES[prefix]
    if prefix == "-O":
        return {"fast": "3", "": "1"}.get(value, value)
    return value


def render_settings(settings):
    """Flags that give exactly these settings, whatever the defaults are."""
    words = []
    for setting in SETTINGS:
        value = settings[setting.name]
        if isinstance(value, str):
            if value != _IMPLIED_VALUES[setting.cc1] or setting.name in (
                "contract",
                "optimization level",
            ):
                words.append(setting.render + value)
        elif value:
            words += setting.render.split()
        elif all(settings[name] for name in setting.off_if):
            words += setting.off_render.split()
    return words


@dataclass(frozen=True)
class Unit:
    """Something in which bad flags differ from good ones.

    A setting, by name, with its value; or a change to the other words.
    """

    setting: str = ""
    value: object = None
    good_value: object = None
    words: tuple = ()
    place: int = 0

    def _text(self, words, value):
        return words + value if isinstance(value, str) else words

    def user_words(self):
        """What a user writes for it."""
        if not self.setting:
            return list(self.words)
        return self._text(_BY_NAME[self.setting].words, self.value).split()

    def off_words(self):
        """What a user writes behind the bad flags to be without it."""
        if not self.setting or self.setting == "optimization level":
            return []
        words = _BY_NAME[self.setting].off_words
        return self._text(words, self.good_value).split()

    def brings(self, other):
        """Whether it is never without the other unit."""
        return bool(
            self.setting and other.setting in _BY_NAME[self.setting].company
        )

    def meaning(self):
        """What it permits."""
        return _BY_NAME[self.setting].meaning if self.setting else "a flag"

    def acts_on_instructions(self):
        """Whether it matters to some floating-point instructions or others."""
        return bool(self.setting) and self.setting not in _BESIDE_INSTRUCTIONS

    def macro(self):
        """The macro that is all there is of it; mostly empty."""
        return _BY_NAME[self.setting].macro if self.setting else ""

    def pragma(self):
        """What turns it off in a block; empty if nothing does."""
        return _BY_NAME[self.setting].pragma if self.setting else ""

    def title(self):
        """Its flag as the report's heading names it."""
        if not self.setting:
            return shlex.join(self.words) or "(a flag that is left out)"
        return self._text(_BY_NAME[self.setting].words.split()[0], self.value)


@dataclass
class FlagSpace:
    """All sets of flags between the good ones and the bad ones."""

    good_words: list
    bad_words: list
    good_settings: dict
    bad_settings: dict
    units: list = field(init=False)

    def __post_init__(self):
        self._pieces = _diff_words(
            _group([w for w in self.good_words if not is_setting_word(w)]),
            _group([w for w in self.bad_words if not is_setting_word(w)]),
        )
        self.units = [
            Unit(s.name, self.bad_settings[s.name], self.good_settings[s.name])
            for s in SETTINGS
            if self.bad_settings[s.name] != self.good_settings[s.name]
        ]
        self.units += [
            Unit(words=tuple(_flatten(bad)), place=place)
            for place, (good, bad) in enumerate(self._pieces)
            if good != bad
        ]

    def render(self, units):
        """The good flags with the differences `units` turned to bad."""
        settings = dict(self.good_settings)
        changed_places = set()
        for unit in units:
            if unit.setting:
                settings[unit.setting] = unit.value
                for other in _BY_NAME[unit.setting].company:
                    settings[other] = self.bad_settings[other]
            else:
                changed_places.add(unit.place)
        words = []
        for place, (good, bad) in enumerate(self._pieces):
            words += _flatten(bad if place in changed_places else good)
        return words + render_settings(settings)

    def write_for_user(self, units):
        """The good flags and behind them the units as a user writes them."""
        words = list(self.good_words)
        for unit in units:
            words += [w for w in unit.user_words() if w not in words]
        return words


def _group(words):
    """Words that belong together, such as `-mllvm` and its option."""
    groups = []
    for word in words:
        if groups and _is_open(groups[-1]):
            groups[-1] += (word,)
        else:
            groups.append((word,))
    return groups


def _is_open(group):
    if group[0] == "-Xclang":
        # Of `-Xclang -mllvm -Xclang x` all belong together.
        return len(group) < 2 or (
            len(group) < 4 and group[1] in ("-mllvm", "-target-feature", "-load")
        )
    return len(group) == 1 and group[0] in _WORDS_WITH_VALUE


def _diff_words(good, bad):
    """Pairs of groups of words, equal where nothing changed."""
    pieces = []
    matcher = difflib.SequenceMatcher(None, good, bad, autojunk=False)
    for kind, g0, g1, b0, b1 in matcher.get_opcodes():
        if kind == "equal":
            pieces.append((good[g0:g1], bad[b0:b1]))
        elif kind == "insert":
            pieces += [([], [group]) for group in bad[b0:b1]]
        elif kind == "delete":
            pieces += [([group], []) for group in good[g0:g1]]
        else:
            pieces.append((good[g0:g1], bad[b0:b1]))
    return pieces


def _flatten(groups):
    return [word for group in groups for word in group]
