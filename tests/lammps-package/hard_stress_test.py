# SPDX-License-Identifier: BSD-3-Clause
"""compute hard/stress: one impact in closed form, and many against the virial that the pair style hands
to the engine."""
import math
import re
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.refusals import assert_refused
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.thermo import thermo_columns

COMPUTES = ["compute stress all hard/stress", "compute pair all pressure NULL pair"]
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


def outputs(columns):
    """in.hard_square_well with more columns in its thermo output."""
    text = (engine.script_file("in.hard_square_well")).read_text()
    return re.sub(r"(thermo_style .*)", r"\1 " + columns, text)


def totals(table):
    """Array (lines, kinds, components)."""
    return numpy.array([[table[f"c_stress[{row}][{k}]"] for k in range(1, 7)]
                        for row in range(1, 5)]).transpose(2, 0, 1)


class Stress(FolderTestCase):
    def run_with_stress(self, pair, dt, steps, dimension, ranks=1, skin=1.0, more=(),
                        boundary="p p p"):
        hard.script(self.folder, pair, "", dimension, [*COMPUTES, *more])
        columns = " ".join(f"c_stress[{row}][{k}]" for row in range(1, 5) for k in range(1, 7))
        code, output = engine.run_text(outputs(columns + " c_pair[*]"), self.folder, ranks=ranks,
                                       dt=float(dt), steps=steps, every=1, dimension=dimension,
                                       boundary=boundary, skin=float(skin), start="data", keep=0)
        self.assertEqual(code, 0, output[-3000:])
        return thermo_columns(output)

    def test_oblique_impact(self):
        """Relative velocity u along x: J = (1 + e)/2 u k_x along k, and mu J along the sliding velocity,
        which mu J B1 = 0.76 cannot stop (1.6). Round-off of a path of 100 steps."""
        e, mu, u = 0.8, 0.1, 2.0
        k = numpy.array([0.6, 0.8 * math.cos(0.3), 0.8 * math.sin(0.3)])
        velocity = numpy.array([u, 0.0, 0.0])
        slide = velocity - u * k[0] * k
        normal = (1 + e) / 2 * u * k[0]
        impulse = normal * (k + mu * slide / numpy.linalg.norm(slide))
        # At contact the middle of both is that of the box; 0.2512 before:
        middle, away = numpy.full(3, 5.0), k / 2 + 0.2512 * velocity / 2
        engine.write_spheres(self.folder, [hard.atom(middle - away, velocity / 2),
                                           hard.atom(middle + away, -velocity / 2)],
                             3 * [(0.0, 10.0)], 1)
        table = self.run_with_stress([f"* * restitution {e} friction {mu}"], 0.005, 100, 3)
        expected = numpy.array([k[a] * impulse[b] for a, b in PAIRS])
        self.assertLess(abs(totals(table)[-1, 0] - expected).max(), 1e-13)
        self.assertEqual(abs(totals(table)[-1, 1:]).max(), 0.0)
        self.assertEqual(abs(totals(table)[0]).max(), 0.0)

    def many(self, dimension, fraction, ranks, friction=0.0, more=(), boundary="p p p"):
        gas = Gas(300, fraction, dimension, (0.4, 0.6))
        gas.write(self.folder, gas.spin())
        dt, steps = 0.05, 100
        table = self.run_with_stress([f"* * restitution 0.9 friction {friction} well 0.3 1.1"], dt,
                                     steps, dimension, ranks, more=[m.format(gas.length) for m in more],
                                     boundary=boundary)
        stress = totals(table)
        events = sum(hard.counts(table).values())[-1]
        self.assertGreater(events, 1000)
        self.assertTrue((numpy.array(list(hard.counts(table).values()))[:, -1] > 20).all())
        # Sums of terms of up to 10 in two orders: round-off 2e-15 each, at worst all one way; 17
        # digits are printed.
        room = 2e-14 * events
        volume = gas.length**dimension
        virial = numpy.array([table[f"c_pair[{k}]"] for k in range(1, 7)]).T
        taken = [0, 1, 3] if dimension == 2 else list(range(6))
        steps_apart = numpy.diff(stress.sum(axis=1), axis=0)
        self.assertLess(abs(steps_apart - volume * dt * virial[1:])[:, taken].max(), room)
        self.assertGreater(abs(steps_apart[:, taken]).max(axis=0).min(), 0.1)
        # By kind: friction is across R and adds nothing to the trace.
        for row in range(4):
            trace = stress[-1, row, :3].sum()
            self.assertLess(abs(trace - table[f"c_events[{13 + row}]"][-1]), room)
        if dimension == 2:
            self.assertEqual(abs(stress[:, :, [2, 4, 5]]).max(), 0.0)

    def test_spheres(self):
        self.many(3, 0.3, 1)

    def test_spheres_with_friction_two_ranks(self):
        self.many(3, 0.3, 2, friction=0.3)

    def test_discs(self):
        self.many(2, 0.4, 2)

    def test_walls_are_left_out(self):
        self.many(2, 0.4, 1, boundary="p f p",
                  more=["fix sides all wall/hard/squarewell restitution 1 yplane 0 {:.17g}"])


class Input(unittest.TestCase):
    def test_wrong_words(self):
        head = "plugin load ${plugin}\natom_style sphere\nregion r block 0 9 0 9 0 9\ncreate_box 1 r\n"
        with engine.temporary_folder() as folder:
            for words, expected in (("all hard/stress block 3", "takes no further arguments"),
                                    ("one hard/stress", "must be 'all'")):
                code, output = engine.run_text(f"{head}group one type 1\ncompute s {words}\n", folder)
                assert_refused(self, code, output, expected)


if __name__ == "__main__":
    unittest.main()
