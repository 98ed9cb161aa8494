# SPDX-License-Identifier: BSD-3-Clause
"""What cohesion-mapping calls equal, in LAMMPS: head-on escape velocities of gran/hamaker and
gran/squarewell under the lines that it prints."""
import math
import sys
import unittest

import numpy

from cohesion_tests import mapping as program
from cohesion_tests.lammps_scenes import couples
from cohesion_tests.test_cases import ScriptTestCase

POSITIONS = 4  # of the contact within the step


class Material:
    """Spheres and their contact; what they are to LAMMPS and to cohesion-mapping."""

    def __init__(self, radii, density, stiffness, restitution, ratio, cutoff=(4e-10, 1e-7)):
        self.radii, self.density = radii, density
        self.cut, self.out = cutoff
        self.mu = density * 4 / 3 * math.pi / sum(r**-3 for r in radii)
        self.w0 = math.sqrt(stiffness / self.mu)
        self.contact_time = math.hypot(math.pi, math.log(restitution)) / self.w0
        self.width = (ratio - 1) * sum(radii)
        self.words = ("--radius", *radii, "--density", density, "--stiffness", stiffness,
                      "--restitution", restitution, "--cutoff", *cutoff, "--ratio", ratio)

    def couple(self, number, gap, speed):
        return couples.couple(number, gap, (0.0, speed, 0.0), diameters=[2 * r for r in self.radii],
                              densities=[self.density] * 2)

    def parted(self, path, edge):
        """Which couples fly apart, from the last two of a run's snapshots: the place on the grid of a
        captured pair can be up to half a step beyond the edge, but not twice."""
        relative = path[-2:, :, 1] - path[-2:, :, 0]
        gaps = numpy.linalg.norm(relative[..., :3], axis=-1) - sum(self.radii)
        return (gaps > edge).all(axis=0) & (relative[-1, :, 4] > 0.0)


class ByDivision(unittest.TestCase):
    SPEEDS = 40
    MATERIALS = {
        "the thesis's bed": (Material((5e-4, 5e-4), 2650, 800, 0.9487, 1.01), 7.49e-19),
        "small, light, lossy": (Material((1e-4, 1e-4), 1500, 5e3, 0.7, 1.02), 1e-20),
        "unlike, stiff": (Material((5e-4, 2e-4), 2650, 1e5, 0.95, 1.005), 1e-18),
    }

    def escape_velocity(self, material, lines, start, edge, well_speed):
        """Bracket from LAMMPS alone, at a quarter of the contact time. Couples begin at the gap
        `start`; `edge`: gap beyond which they have parted; `well_speed`: what they gain on the way."""
        style, coefficients = lines
        dt = material.contact_time / 4
        low, high = 2e-4, 0.1
        while high / low - 1 > 5e-6:
            speeds = numpy.geomspace(low, high, self.SPEEDS)
            atoms = []
            for speed in speeds:
                for position in range(POSITIONS):
                    gap = start + speed * dt * position / POSITIONS
                    atoms += material.couple(len(atoms) // 2, gap, speed)
            # There, in and out again, and 1e-9 m away at sqrt(2e-6) of the speed, which is left of
            # one that is 1e-6 too fast; as long again for the last snapshots.
            way = (start - edge) / low + 2 * edge / well_speed + 1e-9 / (1.4e-3 * low)
            steps = int(way / dt) + 20
            path = couples.run(atoms, [coefficients], dt, 10 * (steps // 5), every=steps // 5,
                               style=style, skin=4e-4)[0]
            parted = material.parted(path, edge + 1e-9).reshape(self.SPEEDS, POSITIONS)
            self.assertTrue((parted.all(axis=1) == parted.any(axis=1)).all(), "depends on position")
            self.assertTrue((numpy.diff(parted[:, 0].astype(int)) >= 0).all(), "not one threshold")
            self.assertFalse(parted[0, 0] or not parted[-1, 0], f"none between {low} and {high}")
            first = int(parted[:, 0].argmax())
            low, high = speeds[first - 1], speeds[first]
        return low, high

    def test_equal_in_the_engine(self):
        for name, (material, constant) in self.MATERIALS.items():
            words = ("to-well", *material.words, "--hamaker", constant)
            row, = program.table(*words)
            (hamaker, hamaker_pair, well, well_pair), = program.script_lines(*words)
            well_speed = math.sqrt(2 * row["depth"] / material.mu)
            laws = {"gran/hamaker": ((hamaker, hamaker_pair), 1.01 * material.out, material.cut),
                    "gran/squarewell": ((well, well_pair), material.width + 1e-8, material.width)}
            for law, (lines, start, edge) in laws.items():
                low, high = self.escape_velocity(material, lines, start, edge, well_speed)
                print(f"{name}, {law}: {low:.8g} to {high:.8g} m/s, cohesion-mapping "
                      f"{row['hamaker_mean']:.8g} m/s", file=sys.stderr)
                # The bracket; nine digits of the coefficients; the rounding of the gap in a box of
                # 0.25 m, 3e-17 m at each of some ten steps of a contact and of the edge.
                tolerance = 5e-6 + 1e-8 + 10 * material.w0 * 3e-17 / low
                self.assertLess(tolerance, 1e-5)
                self.assertLess(abs(math.sqrt(low * high) / row["hamaker_mean"] - 1), tolerance)


class PrintedLines(ScriptTestCase):
    HEAD = """plugin load ${plugin}
units si
atom_style sphere
newton off
comm_modify vel yes
boundary p p f
region box block 0 0.01 0 0.01 0 0.01
create_box 1 box
create_atoms 1 single 0.005 0.005 0.004
set group all diameter 1e-3 density 2650
timestep 1e-6
"""
    RUN = "fix move all nve/sphere\nrun 2\n"

    def test_are_what_lammps_takes(self):
        material, constant = ByDivision.MATERIALS["the thesis's bed"]
        sphere = ("--radius", 5e-4, *material.words[3:])
        for kind in ((), ("--form", "exact", "--asperity", 1e-8), ("--roughness", 5e-9, 5e-7),
                     ("--hamaker-scheme", "sampled", "--well-scheme", "sampled", "--step", 9e-6)):
            words = ("to-well", *sphere, *kind, "--hamaker", constant)
            hamaker, hamaker_pair, well, well_pair = program.script_lines(*words)[0]
            for style, pair in ((hamaker, hamaker_pair), (well, well_pair)):
                self.goes(f"{self.HEAD}pair_style {style}\npair_coeff {pair}\n{self.RUN}")
            for wall in program.script_lines(*words, "--wall")[0]:
                law = wall.split("wall/")[1].split()[0]
                self.goes(f"{self.HEAD}pair_style {law}\npair_coeff * * stiffness 800\n"
                          f"fix {wall}\n{self.RUN}")


class SampledMean(unittest.TestCase):
    def test_share_that_sticks_at_the_step_of_the_thesis(self):
        # The same mean from another grid of speeds and positions. Each couple is stuck or not: the
        # standard error of the share is at most 1/(2 n) of the range that n^2 couples cover, here
        # twice the exact velocity; three of them, and those of the mean of cohesion-mapping.
        n, dt = 28, 2.25e-5
        material, constant = ByDivision.MATERIALS["the thesis's bed"]
        exact, = program.table("to-well", *material.words, "--hamaker", constant)
        scheme = ("--hamaker-scheme", "sampled", "--step", dt)
        words = ("to-well", *material.words, *scheme, "--hamaker", constant)
        row, = program.table(*words)
        style, coefficients = program.script_lines(*words)[0][:2]
        most, atoms = 2 * exact["hamaker_mean"], []
        for i in range(n):
            for k in range(n):
                speed = most * (i + 0.5) / n
                position = ((k + 0.5) / n + 0.7548776662 * i) % 1
                atoms += material.couple(len(atoms) // 2, material.out + speed * dt * (1 + position),
                                         speed)
        path = couples.run(atoms, [coefficients], dt, 400, every=200, style=style, skin=4e-4)[0]
        stuck = 1 - material.parted(path, material.out).mean()
        error = math.hypot(2 / (2 * n), 1e-3)
        print(f"sampled at {dt} s: mean {most * stuck:.4g} m/s, cohesion-mapping "
              f"{row['hamaker_mean']:.4g} m/s, exact {exact['hamaker_mean']:.4g} m/s", file=sys.stderr)
        self.assertLess(abs(most * stuck - row["hamaker_mean"]) / exact["hamaker_mean"], 3 * error)
        self.assertGreater(abs(row["hamaker_mean"] / exact["hamaker_mean"] - 1), 4 * error)


if __name__ == "__main__":
    unittest.main()
