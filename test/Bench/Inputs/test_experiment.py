# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Figures of runs, and what the experiment finds wrong."""

import unittest

from experiment.configurations import Kernel, all_configurations
from experiment.errors import BenchError
from experiment.measures import figures
from experiment.results import problems
from experiment.table import in_units
from experiment_results import CACHED, make_runs, results_of
from statistics_of_runs import make_statistics


class Figures(unittest.TestCase):
    def test_of_the_baseline(self):
        found = figures(make_statistics(1000, cached=False), 112)
        self.assertIsNone(found["cache"])
        self.assertEqual(found["nodes_per_ray"], 3)
        self.assertEqual(found["nodes_read_per_ray"], 3)
        self.assertEqual(found["triangles_read_per_ray"], 2)
        self.assertAlmostEqual(found["bytes_per_second"],
                               (30 * 112 + 20 * 36) / 1e-6, places=0)
        self.assertEqual(found["threads"], 4)
        self.assertEqual(found["shares"]["memory"], 0.3)
        self.assertEqual(found["worst_unit_conflict"],
                         {"opcode": "mul_s", "share": 0.02})

    def test_shares_are_complete(self):
        shares = figures(make_statistics(1000, cached=False), 112)["shares"]
        self.assertAlmostEqual(sum(shares.values()), 1)

    def test_of_a_cached_run(self):
        found = figures(make_statistics(1000, cached=True), 56)
        self.assertEqual(found["nodes_read_per_ray"], 0.3)
        self.assertAlmostEqual(found["bytes_per_second"],
                               (3 * 56 + 2 * 36) / 1e-6, places=0)
        self.assertEqual(found["cache"]["deletions_per_ray"], 0.2)
        self.assertEqual(found["cache"]["hit_rate"], 0.8)
        self.assertEqual(found["cache"]["slots_freed"], 3.5)

    def test_without_a_ray_profile(self):
        statistics = make_statistics(1000, cached=False)
        del statistics["ray_profile"]
        with self.assertRaisesRegex(BenchError, "lack 'ray_profile'"):
            figures(statistics, 112)


class Configurations(unittest.TestCase):
    def test_the_reports_experiment(self):
        found = all_configurations(["a"], [CACHED], [2, 4, 8, 16, 32],
                                   [100, 300])
        self.assertEqual(len(found), len(set(found)))
        self.assertEqual(len(found), 2 * (1 + 5) + 1)
        self.assertEqual([(c.local_store, c.latency) for c in found
                          if c.kernel == Kernel()],
                         [(32, 100), (32, 300), (2, 300)])


class Problems(unittest.TestCase):
    def setUp(self):
        self.runs = make_runs()

    def run_of(self, kernel, local_store):
        return next(run for c, run in self.runs.items()
                    if (c.scene, c.kernel, c.local_store, c.latency)
                    == ("near", kernel, local_store, 300))

    def found(self):
        return problems(results_of(self.runs))

    def test_none(self):
        self.assertEqual(self.found(), [])

    def test_other_image(self):
        self.run_of(CACHED, 2).image_digest = "other"
        self.assertEqual(self.found(),
                         ["near, HighestBranch, FullSlots, 2 KiB, latency 300: "
                          "not the baseline's image"])

    def test_image_of_other_latency(self):
        for run in (self.run_of(Kernel(), 2), self.run_of(Kernel(), 8),
                    self.run_of(CACHED, 2), self.run_of(CACHED, 8)):
            run.image_digest = "other"
        self.assertEqual(self.found(),
                         ["near: the image depends on the latency"])

    def test_baseline_in_a_small_local_store(self):
        self.run_of(Kernel(), 2).statistics["run"]["cycles"] += 1
        self.assertEqual(self.found(),
                         ["near, baseline, 2 KiB, latency 300: the baseline "
                          "takes 3001 cycles, 3000 with 8 KiB"])


class Rows(unittest.TestCase):
    def rows(self, is_short):
        other = Kernel("KeepTop", "QuantizedSlots")
        results = results_of(make_runs([CACHED, other]))
        return [(run["kernel"], run["local_store"])
                for run in results.rows(is_short)
                if (run["scene"], run["latency"]) == ("near", 300)]

    def test_of_the_whole_table(self):
        self.assertEqual(self.rows(is_short=False),
                         [("baseline", 8), ("HighestBranch, FullSlots", 2),
                          ("HighestBranch, FullSlots", 8),
                          ("KeepTop, QuantizedSlots", 2),
                          ("KeepTop, QuantizedSlots", 8)])

    def test_of_a_short_table(self):
        self.assertEqual(self.rows(is_short=True),
                         [("baseline", 8), ("HighestBranch, FullSlots", 2),
                          ("HighestBranch, FullSlots", 8),
                          ("KeepTop, QuantizedSlots", 8)])


class Units(unittest.TestCase):
    def test_three_digits(self):
        for value, text in ((2.2539e9, "2.25 G"), (999.6e6, "1 G"),
                            (120326, "120 k"), (3.5, "3.5"), (0, "0")):
            self.assertEqual(in_units(value), text)


if __name__ == "__main__":
    unittest.main()
