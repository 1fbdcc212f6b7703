# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Flags are taken apart as the driver reads them. The argument is the compiler.
"""

import shlex
import sys
import unittest

from tp_bisect.compiler import Compiler, find_compiler
from tp_bisect.errors import UserError
from tp_bisect.flags import FlagSpace, is_setting_word
from tp_bisect.processes import ProcessRunner

COMPILER = Compiler(sys.argv.pop(), ProcessRunner(), "/")

# Each umbrella, its parts, and orders that matter.
FLAG_SETS = [
    "-O2",
    "-O2 -ffast-math",
    "-Ofast",
    "-O3 -ffp-model=fast",
    "-O1 -ffp-model=aggressive",
    "-O2 -ffp-model=precise",
    "-Os -funsafe-math-optimizations",
    "-O2 -ffast-math -fno-finite-math-only",
    "-O2 -fno-finite-math-only -ffast-math",
    "-O2 -ffinite-math-only",
    "-O2 -ffast-math -fno-fast-math",
    "-O2 -fassociative-math",
    "-O2 -fassociative-math -fno-signed-zeros -fno-trapping-math",
    "-O2 -freciprocal-math -fapprox-func",
    "-O2 -fno-math-errno -fno-honor-nans",
    "-ffp-contract=off",
    "-O2 -ffast-math -ffp-contract=off",
    "-O2 -ffast-math -fhonor-infinities",
    "-O2 -mdaz-ftz",
]


def space(good, bad):
    good, bad = good.split(), bad.split()
    return FlagSpace(good, bad, COMPILER.settings(good), COMPILER.settings(bad))


class Expansion(unittest.TestCase):
    def test_rendered_flags_mean_the_same(self):
        for flags in FLAG_SETS:
            with self.subTest(flags=flags):
                ends = space("-O0", flags)
                for words, units in ((["-O0"], []), (flags.split(), ends.units)):
                    self.assertEqual(
                        COMPILER.settings(words),
                        COMPILER.settings(ends.render(units)),
                    )

    def test_fast_math_has_its_parts(self):
        names = {u.setting for u in space("-O2", "-O2 -ffast-math").units}
        for name in ("reciprocal", "reassociate", "no NaNs", "no infinities"):
            self.assertIn(name, names)
        self.assertNotIn("optimization level", names)

    def test_order_of_flags_counts(self):
        ordered = space(
            "-ffast-math -fno-finite-math-only", "-fno-finite-math-only -ffast-math"
        )
        names = {u.setting for u in ordered.units}
        self.assertIn("no infinities", names)
        self.assertNotIn("reciprocal", names)

    def test_lonely_associative_math_changes_nothing(self):
        self.assertEqual(space("-O2", "-O2 -fassociative-math").units, [])

    def test_companion_comes_with_its_leader(self):
        ends = space("-O2", "-O2 -ffast-math")
        leader = next(u for u in ends.units if u.setting == "reassociate")
        zeros = next(u for u in ends.units if u.setting == "no signed zeros")
        self.assertTrue(leader.brings(zeros))
        self.assertFalse(zeros.brings(leader))
        settings = COMPILER.settings(ends.render([leader]))
        self.assertTrue(settings["reassociate"] and settings["no signed zeros"])
        self.assertFalse(settings["reciprocal"])
        self.assertFalse(COMPILER.settings(ends.render([zeros]))["reassociate"])

    def test_users_words_turn_a_unit_on(self):
        ends = space("-O2", "-O2 -ffast-math")
        for unit in ends.units:
            with self.subTest(unit=unit.setting):
                settings = COMPILER.settings(ends.write_for_user([unit]))
                self.assertEqual(settings[unit.setting], unit.value)

    def test_words_behind_the_bad_ones_turn_it_off(self):
        bad = "-O2 -ffast-math"
        for unit in space("-O2", bad).units:
            with self.subTest(unit=unit.setting):
                self.assertTrue(unit.off_words())
                settings = COMPILER.settings(bad.split() + unit.off_words())
                self.assertEqual(settings[unit.setting], unit.good_value)

    def test_level_is_a_unit(self):
        (unit,) = space("-O0", "-O2").units
        self.assertEqual((unit.title(), unit.off_words()), ("-O2", []))

    def test_other_words(self):
        kept = ["-DA", "-mllvm", "-unroll-count=2"]
        added = ["-mllvm", "-inline-threshold=3"]
        good = ["-O2", *kept]
        ends = space(shlex.join(good), shlex.join([*good, "-DB=2", *added]))
        self.assertEqual(
            [u.words for u in ends.units], [("-DB=2",), tuple(added)]
        )
        words = ends.render(ends.units[1:])
        self.assertEqual(words[:5], kept + added)

    def test_left_out_word(self):
        ends = space("-O2 -fwrapv", "-O2")
        (unit,) = ends.units
        self.assertIn("-fwrapv", ends.render([]))
        self.assertNotIn("-fwrapv", ends.render([unit]))


class Driver(unittest.TestCase):
    def test_origin(self):
        flags = "-O2 -ffast-math -ffp-contract=off".split()
        self.assertEqual(COMPILER.origin(flags, "reciprocal", True), "-ffast-math")
        self.assertEqual(
            COMPILER.origin(flags, "contract", "off"), "-ffp-contract=off"
        )

    def test_overridden_word(self):
        flags = "-fno-finite-math-only -O2 -ffast-math".split()
        word = COMPILER.overridden_word(
            flags, "-ffast-math", "no infinities", True
        )
        self.assertEqual(word, "-fno-finite-math-only")
        flags = "-O2 -ffast-math".split()
        self.assertEqual(
            COMPILER.overridden_word(flags, "-ffast-math", "no infinities", True), ""
        )

    def test_unknown_flag(self):
        with self.assertRaisesRegex(UserError, "does not accept.*-ffast-maths"):
            COMPILER.settings(["-ffast-maths"])

    def test_compiler_in_a_command(self):
        path = find_compiler(f"cd x && CXX=y {COMPILER.path} {{flags}} a.cpp", "")
        self.assertEqual(path, COMPILER.path)
        with self.assertRaisesRegex(UserError, "--compiler"):
            find_compiler("make all", "")

    def test_setting_words(self):
        self.assertTrue(is_setting_word("-ftp-fp=fast"))
        self.assertFalse(is_setting_word("-fwrapv"))


if __name__ == "__main__":
    unittest.main()
