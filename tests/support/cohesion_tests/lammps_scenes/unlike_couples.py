# SPDX-License-Identifier: BSD-3-Clause
"""Couples of unlike spheres in which the tallies of energy and momentum are kept step by step."""
import math

import numpy

from cohesion_tests.lammps_scenes import couples
from cohesion_tests.theory.pair_motion import CONTACT_TIME as T_C
from cohesion_tests.theory.pair_motion import CUT, Pair
from cohesion_tests.thermo import thermo_columns


class Box:
    """40 couples of unlike spheres followed step by step; unless `apart`, some are overlapped from
    the start. Tallies close at grid points; momentum at n+1/2, where the grid has positions
    x + v' dt/2 and velocities v' = v + f dt/(2 m)."""
    DIAMETERS, DENSITIES = numpy.array((1e-3, 0.6e-3)), numpy.array((2650.0, 5300.0))
    MASSES = math.pi / 6 * DENSITIES * DIAMETERS**3
    INERTIAS = 0.1 * MASSES * DIAMETERS**2
    MU = MASSES.prod() / MASSES.sum()
    SPEED, TURN = 0.03, 30.0  # [m/s], [1/s]; TURN d/2 = SPEED/2
    A = 7.49e-19

    def __init__(self, friction, division, head_on=False, apart=False, rolling=0.0):
        random = numpy.random.default_rng(4711)
        atoms = []
        for number in range(40):
            normal, sideways, *spins = random.normal(size=(4, 3))
            normal /= numpy.linalg.norm(normal)
            # Up to 70 degrees off the line of centres: all couples part.
            sideways = numpy.cross(normal, sideways)
            angle = 0.0 if head_on else math.radians(70.0) * random.random()
            velocity = self.SPEED * (math.cos(angle) * normal
                                     + math.sin(angle) / numpy.linalg.norm(sideways) * sideways)
            spins = [spin * (self.TURN / numpy.linalg.norm(spin)) for spin in spins]
            gap = -1e-7 if number % 4 == 0 else 2e-7 * random.random() + CUT
            gap += 1e-6 if apart else 0.0
            atoms += couples.couple(number, gap, velocity, normal, columns=10, spins=spins,
                                    diameters=self.DIAMETERS, densities=self.DENSITIES)
        dt = T_C / division
        words = Pair(self.A).words(friction=friction, rolling_friction=rolling)
        path, output = couples.run(atoms, ["* * " + words], dt, 10 * division, every=1,
                                   size=(0.03, 0.02, 0.004))
        # Forces of step 0, too, are those of the half step that follows.
        self.v = path[..., 3:6] + 0.5 * dt * path[..., 9:12] / self.MASSES[:, None]
        self.spin = self.INERTIAS[:, None] * path[..., 6:9] + 0.5 * dt * path[..., 12:15]
        self.places = path[..., 0:3]
        self.x = self.places + 0.5 * dt * self.v
        self.thermo = thermo_columns(output)
        self.tally = {k: self.thermo[f"c_tally[{k}]"] for k in range(1, 14)}
        self.energy = self.tally[1][0] + self.tally[2][0]
        self.centre = numpy.array([atom["x"] for atom in atoms]).reshape(-1, 2, 3).mean(
            axis=1, keepdims=True)
        # A gap is rounded by 3e-18 m in each step, at random; springs pull with 3e-2 N at most. And
        # a rounding of the sum itself.
        self.rounding = math.sqrt(40 * 10 * division) * 3e-18 * 3e-2 + 100 * 2.0**-53 * self.energy
