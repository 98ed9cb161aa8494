# SPDX-License-Identifier: BSD-3-Clause
"""fix agglomerates with the overlay hamaker: bound are pairs of types that attract each other, within H_out, against a
search over all pairs."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.agglomerate_search import BOX, RANGE, Search, constructed, in_box

SCRIPT = """
plugin load ${plugin}
units lj
atom_style sphere
newton off
boundary p p p
comm_modify vel yes
neighbor 0.3 bin
read_data data.spheres
pair_style hybrid/overlay gran/hooke/history 800 NULL 1 NULL 0 0 hamaker cutoff 1e-3 %(range)s
pair_coeff * * gran/hooke/history
pair_coeff * * hamaker hamaker %(constant)s
%(more)s
fix set all agglomerates 1
fix move all nve/sphere
timestep 0.001
dump out all custom 1 out.txt id f_set[1] f_set[2]
run 0
"""


class Overlay(ScriptTestCase):
    def sets(self, x, constant="1e-12", more="", types=None, ranks=1):
        """Of each particle: the set that it is in, and how many are."""
        types = [1] * len(x) if types is None else types
        engine.write_spheres(self.folder, [{"type": t, "diameter": 1.0, "density": 1.0, "x": a}
                                           for a, t in zip(x, types)], [(0.0, side) for side in BOX], max(types),
                             tilt=(0.0, 0.0, 0.0))
        self.goes(SCRIPT % dict(range=RANGE, constant=constant, more=more), ranks=ranks)
        return engine.dump(self.folder, "out.txt")[:, 1:]

    def test_constructed(self):
        x = in_box(constructed(), 0.0)
        expected = Search(x, 0.0).of_each()
        self.assertGreater(expected[:, 1].max(), 5)
        for ranks in (1, 2):
            numpy.testing.assert_array_equal(self.sets(x, ranks=ranks), expected)

    def test_what_does_not_attract_or_is_not_moved_is_not_bound(self):
        x = numpy.array([[1.0, 1.0, 1.0], [2.1, 1.0, 1.0], [5.0, 1.0, 1.0], [6.1, 1.0, 1.0]])
        alone = [[0.0, 1.0]] * 2
        numpy.testing.assert_array_equal(self.sets(x, constant="0"), alone + alone)
        of_second = self.sets(x, more="pair_coeff 1 1 hamaker hamaker 0\npair_coeff 1 2 hamaker hamaker 0", types=[1, 1, 2, 2])
        numpy.testing.assert_array_equal(of_second, alone + [[3.0, 2.0]] * 2)
        held = self.sets(x, more="group still id 1 2\nfix still still freeze")
        numpy.testing.assert_array_equal(held, alone + [[3.0, 2.0]] * 2)


if __name__ == "__main__":
    unittest.main()
