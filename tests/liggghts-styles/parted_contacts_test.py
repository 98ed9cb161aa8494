# SPDX-License-Identifier: BSD-3-Clause
"""Under fix deform/shear a contact that ends loses its friction spring, whenever lists of neighbours are made."""

import unittest

import numpy

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.sheared_scene import LAWS, SMALL, sheared, three_in_a_row


class PartedContacts(unittest.TestCase):
    STEPS, DT = 1200, 1e-6

    def path(self, law, skin, extra=""):
        """Also how many lists were made."""
        models, properties = LAWS[law]
        run = Run(sheared(three_in_a_row(), models, properties, rate=1e-3, dt=self.DT, steps=self.STEPS, every=5,
                          skin=skin, extra=extra))
        found = numpy.array([[frame[n] for n in (1, 2, 3)] for frame in run.frames("out.txt")])
        self.assertEqual("keeps its friction" in run.output, "contact_distance_factor" in extra)
        return found, int(run.output.split("Neighbor list builds =")[1].split()[0])

    def apart(self, law, extra=""):
        """Of two skins, one of which makes lists while the first two are apart: distance and difference of speed."""
        (path, none), (other, many) = (self.path(law, skin, extra) for skin in (3e-4, 4e-6))
        self.assertEqual(none, 0)
        self.assertGreater(many, 10)
        touch = numpy.linalg.norm(path[:, 1, :3] - path[:, 0, :3], axis=1) < 2 * SMALL
        self.assertEqual(numpy.diff(touch.astype(int)).tolist().count(1), 2, "they touch twice")
        off = numpy.abs(path - other)
        return off[..., :3].max(), off[..., 3:].max()

    def test_path_does_not_depend_on_the_skin(self):
        # A place below 1/64 m is rounded by 2^-60 m in each of 1200 steps, 1e-15 m; a collision makes a difference some
        # ten times larger, and of it a velocity w0 = 1e5 1/s times as large.
        for law in ("spring", "hertz"):
            with self.subTest(law):
                place, velocity = self.apart(law)
                self.assertLess(place, 1e-13)
                self.assertLess(velocity, 1e-8)

    def test_it_would_where_the_engine_does_not_look_at_gaps(self):
        """What the fix asks for is taken back: the scene above is one that shows it."""
        for law in ("spring", "hertz"):
            with self.subTest(law):
                place, velocity = self.apart(law, "neigh_modify contact_distance_factor 1.0\n")
                self.assertGreater(place, 1e-9)
                self.assertGreater(velocity, 1e-6)


if __name__ == "__main__":
    unittest.main()
