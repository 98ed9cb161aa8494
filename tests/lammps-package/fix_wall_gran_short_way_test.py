# SPDX-License-Identifier: BSD-3-Clause
"""Particles far from the walls are not asked in each step: against the same scene with a new list of neighbours
in each step, in which all of them are."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine, refusals
from cohesion_tests.refusals import assert_refused
from cohesion_tests.test_cases import FolderTestCase

R, DENSITY = 5e-4, 2500.0
MASS = 4 / 3 * math.pi * R**3 * DENSITY
DT = 1e-5
STIFFNESS = MASS * (math.pi / (2 * DT))**2  # a contact lasts two steps
SMALL, SOFT = 0.1 * R, 0.1**3 * STIFFNESS  # the same for small ones
ASKED = {"far ones left out": "neigh_modify delay 1000000", "all asked": "neigh_modify every 1 delay 0 check no"}


def script(lists, walls, commands, style="sphere", ranks=1):
    """Particles of data.spheres that meet nothing but walls."""
    return f"""
plugin load ${{plugin}}
units si
processors {ranks} 1 1
atom_style {style}
newton off
boundary p p f
comm_modify vel yes
read_data data.spheres
pair_style zero 1e-3
pair_coeff * *
neighbor 5e-3 bin
{lists}
fix w all wall/gran/{walls}
{commands}
"""


class ShortWay(FolderTestCase):
    def runs(self, heights, speeds, fix, more, radii=None, z=0.04, steps=120):
        """Particles that meet nothing but the walls; of each kind of ASKED code, output and, of each step, z and
        its velocity."""
        radii = radii or [R] * len(heights)
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": 2 * r, "density": DENSITY, "x": (0.01 + 0.02 * k, 0.01, height),
             "v": (0.0, 0.0, speed)} for k, (r, height, speed) in enumerate(zip(radii, heights, speeds))],
            [(0.0, 0.02 * len(heights)), (0.0, 0.02), (0.0, z)], 1)
        found = {}
        for name, lists in ASKED.items():
            code, output = engine.run_text(script(lists, fix, f"""
{more}
fix move all nve/sphere
timestep {DT!r}
dump out all custom 1 out.txt id z vz
dump_modify out format float %.17g
thermo_style custom step
thermo {steps}
run {steps}
""", style="sphere 1"), self.folder)
            built = [line.split()[-1] for line in output.splitlines() if "Neighbor list builds" in line]
            if code == 0:
                self.assertEqual(int(built[0]), steps if "check no" in lists else 0)
            found[name] = code, output, numpy.array(engine.dumps(self.folder, "out.txt"))
        return found

    def same(self, *scene, **options):
        ways = []
        for code, output, way in self.runs(*scene, **options).values():
            self.assertEqual(code, 0, output[-2000:])
            ways.append(way)
        numpy.testing.assert_array_equal(*ways)
        return ways[0]

    def test_fast_particles_and_a_moving_wall(self):
        """Up to 0.9 of a radius in a step, nearly twice the radius away at its begin: places of the first
        meeting spread over a step."""
        speed = 0.8 * R / DT
        heights = [0.02 + k / 8 * speed * DT for k in range(8)]
        way = self.same(heights, [-speed] * 8,
                        f"hamaker stiffness {STIFFNESS} zplane 0.005 0.035 wiggle z 2e-4 {100 * DT}", "")
        # Each meets both walls.
        self.assertTrue((way[:, :, 2].max(axis=0) > 0).all())
        self.assertGreater((numpy.diff(numpy.sign(way[:, :, 2]), axis=0) != 0).sum(), 2 * 8 - 1)

    def test_wells_wider_than_particles(self):
        """The edge is at three radii: two of them, the reach of contacts, are not enough."""
        speed, depth = 0.1 * R / DT, 0.5 * MASS * (0.1 * R / DT)**2
        heights = [0.005 + k / 8 * speed * DT for k in range(8)]
        way = self.same(heights, [-speed] * 8,
                        f"squarewell stiffness {STIFFNESS} well {depth} 3 zplane 0 NULL", "", steps=100)
        # Faster in the well, and back.
        self.assertGreater(abs(way[:, :, 2]).max() / speed, 1.2)

    def test_particles_that_grow(self):
        """To three times the radius that they had when the list was made: those at rest meet the wall."""
        way = self.same([2.5 * R] * 2, [0.0, 0.0], f"hamaker stiffness {STIFFNESS} zplane 0 NULL",
                        f"variable size equal {2 * R}*(1+step/50)\nfix grow all adapt 1 atom diameter v_size mass no",
                        steps=100)
        self.assertGreater(way[-1, :, 2].min(), 0.0)

    def test_particles_that_others_carry_along(self):
        """One flies up; that the centre of mass stays where it is, all are put down, and those at rest meet the
        floor."""
        speed = 0.05 * R / DT
        way = self.same([10 * R, 5 * R, 5 * R], [speed, 0.0, 0.0], f"hamaker stiffness {STIFFNESS} zplane 0 NULL",
                        "fix stay all recenter INIT INIT INIT shift all", steps=400)
        self.assertGreater(way[-1, 1:, 2].min(), 0.0)

    def test_a_box_that_carries_particles_along(self):
        """Rescaled in each step, in the end to 0.32 radii above the floor: they have no velocity of their own
        until they meet it."""
        way = self.same([0.004] * 2, [0.0, 0.0], f"hamaker stiffness {STIFFNESS} zplane 0 NULL",
                        "fix press all deform 1 z scale 1.24 remap x", steps=400)
        self.assertGreater(way[-1, :, 2].min(), 0.0)

    def stops(self, *scene, **options):
        errors = []
        for code, output, way in self.runs(*scene, **options).values():
            assert_refused(self, code, output, "radii in one step")
            errors.append((refusals.errors(output), len(way)))
        self.assertEqual(*errors)

    def test_small_ones_that_become_too_fast_far_away(self):
        self.stops([0.02, 0.03], [0.0, 0.0], f"hamaker stiffness {SOFT} zplane 0 NULL",
                   f"fix g all gravity {0.1 * SMALL / DT**2} vector 0 0 -1", radii=[SMALL, R])

    def test_walls_that_become_too_fast_for_small_ones_far_away(self):
        """Up to 0.3 large radii in a step."""
        period = 100 * DT
        amplitude = 0.3 * R / DT * period / (2 * math.pi)
        self.stops([0.02, 0.03], [0.0, 0.0],
                   f"hamaker stiffness {SOFT} zplane 0 NULL wiggle z {amplitude} {period}", "",
                   radii=[SMALL, R])

    def too_fast(self, spheres, commands, lists, ranks=1):
        """A floor; large spheres and a small one far above it, of which the small one becomes too fast."""
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": 2 * r, "density": DENSITY, "x": (x, 0.01, 0.02), "v": (v, 0.0, 0.0)}
            for r, x, v in spheres], [(0.0, 0.04), (0.0, 0.02), (0.0, 0.04)], 1)
        code, output = engine.run_text(
            script(lists, f"hamaker stiffness {SOFT} zplane 0 NULL",
                   f"fix move all nve/sphere\ntimestep {DT!r}\n{commands}", ranks=ranks), self.folder, ranks=ranks)
        assert_refused(self, code, output, "radii in one step", begun=True)

    def test_a_small_one_that_comes_from_another_rank(self):
        """It falls after it has come to a rank that had large ones only; the large ones are never too fast."""
        self.too_fast([(R, 0.01, 0.0), (SMALL, 0.0201, -0.05 * R / DT)],
                      f"variable g equal (step>50)*{0.1 * SMALL / DT**2}\nfix g all gravity v_g vector 0 0 -1\nrun 110",
                      ASKED["all asked"], ranks=2)

    def test_a_small_one_that_comes_between_two_runs(self):
        self.too_fast([(R, 0.01, 0.0)],
                      f"run 5\ncreate_atoms 1 single 0.02 0.01 0.02 units box\nset atom 2 diameter {2 * SMALL} "
                      f"density {DENSITY}\nset atom 2 vz {-1.2 * SMALL / DT}\nrun 20", ASKED["far ones left out"])

    def test_a_flow_that_is_too_fast_for_a_still_wall(self):
        """A particle that moves with the mean flow of a sheared box, 1.5 radii in a step, towards a wall."""
        height, speed = 0.01, 1.5 * R / DT
        engine.write_spheres(self.folder, [{"type": 1, "diameter": 2 * R, "density": DENSITY,
                                            "x": (0.02, 0.01 + height, 0.01), "v": (speed, 0.0, 0.0)}],
                             [(0.0, 0.1), (0.0, 0.02 + height), (0.0, 0.02)], 1, tilt=(0.0, 0.0, 0.0))
        code, output = engine.run_text(f"""
plugin load ${{plugin}}
units si
atom_style sphere
newton off
boundary f p p
comm_modify vel yes
read_data data.spheres
pair_style zero 1e-3
pair_coeff * *
neighbor 5e-3 bin
fix w all wall/gran/hamaker stiffness {STIFFNESS} xplane NULL 0.09
fix d all deform 1 xy erate {speed / (0.5 * height)} remap v flip no
fix move all nve/sphere
timestep {DT!r}
run 20
""", self.folder)
        self.assertEqual(code, 1, output[-2000:])
        self.assertIn("radii in one step", output)


if __name__ == "__main__":
    unittest.main()
