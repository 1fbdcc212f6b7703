# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The searches find what they are to find, with few tests."""

import itertools
import unittest

from tp_bisect.delta import first_bad_step, minimize


class CountingTest:
    """A test that is bad where all of some items are there."""

    def __init__(self, guilty):
        self.guilty = set(guilty)
        self.count = 0

    def __call__(self, candidates):
        self.count += len(candidates)
        return [self.guilty <= set(candidate) for candidate in candidates]


class Minimize(unittest.TestCase):
    def test_every_pair_of_eight(self):
        for guilty in itertools.combinations(range(8), 2):
            found = minimize(range(8), 2, CountingTest(guilty))
            self.assertEqual(sorted(found), list(guilty))

    def test_one_of_many_takes_a_logarithm(self):
        for place in range(0, 1000, 37):
            test = CountingTest([place])
            self.assertEqual(minimize(range(1000), 2, test), [place])
            self.assertLess(test.count, 20)

    def test_all_are_needed(self):
        self.assertEqual(minimize("abc", 3, CountingTest("abc")), list("abc"))

    def test_nothing_is_left_that_is_not_needed(self):
        # Bad where there are 1 and 5, or 3: not monotonous in how it ends.
        def judge_all(candidates):
            return [{1, 5} <= set(c) or 3 in c for c in candidates]

        found = minimize(range(8), 1, judge_all)
        self.assertTrue(judge_all([found])[0])
        for item in found:
            self.assertFalse(judge_all([[i for i in found if i != item]])[0])

    def test_single_item_needs_no_test(self):
        test = CountingTest("a")
        self.assertEqual(minimize("a", 2, test), ["a"])
        self.assertLessEqual(test.count, 1)


class FirstBadStep(unittest.TestCase):
    def test_every_place(self):
        for ways in (1, 2, 3, 8):
            for bad in range(1, 41):
                found = first_bad_step(
                    0, 40, ways, lambda steps: [s >= bad for s in steps]
                )
                self.assertEqual(found, (bad, bad - 1))

    def test_likely_step_is_found_soon(self):
        likely = range(500, 30000, 300)
        for bad in (*likely, 1, 499, 501, 30000):
            tests = []

            def judge_all(steps):
                tests.extend(steps)
                return [s >= bad for s in steps]

            found = first_bad_step(
                0, 30000, 2, judge_all, lambda s: 100000 if s in likely else 1
            )
            self.assertEqual(found, (bad, bad - 1))
            if bad in likely:
                self.assertLess(len(tests), 14)

    def test_steps_that_cannot_be_judged(self):
        def judge_all(steps):
            return [None if 10 <= s <= 14 else s >= 12 for s in steps]

        self.assertEqual(first_bad_step(0, 40, 2, judge_all), (15, 9))


if __name__ == "__main__":
    unittest.main()
