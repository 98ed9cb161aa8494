# SPDX-License-Identifier: BSD-3-Clause
"""A cohesive pile on a cohesive wall does the same on one and on two ranks."""

import unittest

from cohesion_tests.liggghts import Run

STEPS = 3000


def by_start(run):
    """Rows of the last frame, keyed by where the particle started in um: ids depend on ranks."""
    first, last = run.frames("end.txt")
    return {tuple(round(1e6 * c) for c in first[i][:3]): (first[i], last[i]) for i in first}


class Ranks(unittest.TestCase):
    def test_two_ranks_equal_one(self):
        one = by_start(Run("in.cluster", ranks=1, steps=STEPS))
        two = by_start(Run("in.cluster", ranks=2, steps=STEPS))
        self.assertEqual(len(one), 216)
        self.assertEqual(one.keys(), two.keys())
        crossed = sum(start[0] * end[0] < 0 for start, end in one.values())
        self.assertGreater(crossed, 0, "no particle changes its rank in this script")
        # Sums in another order round differently: half an epsilon of a coordinate of 5 mm in each of
        # 3000 steps is 2e-15 m, which a collision may amplify by diameter over overlap, about 1e3.
        # A contact or a cohesive pair lost at the border shifts a particle by 1e-7 m and more.
        for start in one:
            for mine, other in zip(one[start][1][:3], two[start][1][:3]):
                self.assertAlmostEqual(mine, other, delta=2e-12)

    def test_preloaded_it_is_the_same_to_the_last_bit(self):
        launcher, preload = (Run("in.cluster", how, ranks=2, steps=200) for how in ("launcher", "preload"))
        self.assertIn("2 by 1 by 1 MPI processor grid", preload.output)
        self.assertEqual(preload.frames("end.txt"), launcher.frames("end.txt"))


if __name__ == "__main__":
    unittest.main()
