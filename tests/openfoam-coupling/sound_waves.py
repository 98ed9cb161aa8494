# SPDX-License-Identifier: BSD-3-Clause
"""Sound in an ideal gas that carries free spheres along by stiff drag, in form B: the gas is the spring, the spheres are
the mass, and a gas step that takes these to keep their velocity lets them be late. How fast waves grow, or die out, by the
solver and by the eigenvalues of a step (docs/openfoam-coupling/stability.md)."""

import unittest

import numpy as np

from cohesion_tests.coupling.fields import cells
from cohesion_tests.coupling.free_spheres import DT, RHO, SUB_STEPS
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.coupling.waves import CELL, solve

HIGH, COLUMNS = 64, 4  # cells along the box; columns along the edge of a cell
FIRST, LAST = 6, 40  # steps that are looked at
EPS, RATIO, X = 0.5, 1000.0, 7.4  # void fraction, ratio of the densities, x = b dt/m
OMEGA = 0.2  # phase of the longest wave in a gas step, if drag were rigid


def step_matrix(omega, free, seen, displaced):
    """What a gas step makes of h, Q, G and d: velocity of the particles at its start, what is deferred, the pressure's
    force on the mixture over the particles' mass, and their mean velocity in the step. `seen`: what is left of a wave
    from faces to cells or back; `displaced`: what the cells see of what particles displace."""
    n, decay = 1 - EPS, np.exp(-X)
    mean = (1 - decay) / (SUB_STEPS * (1 - np.exp(-X / SUB_STEPS)))
    charge = 1 - decay if free else X
    columns = []
    for h, deferred, force, d in np.eye(4):
        # force' = charge u - seen (charge h - Q), and by continuity force' = force - omega^2 (eps u + n d)
        u = (seen * (charge * h - deferred) + force - omega**2 * n * displaced * d) / (charge + omega**2 * EPS)
        v = seen * u
        after = v + decay * (h - v)
        columns.append([after, after - h - charge * (v - h), force - omega**2 * (EPS * u + n * displaced * d),
                        v + mean * (h - v)])
    return np.array(columns).T


def root(*step):
    """The largest eigenvalue"""
    values = np.linalg.eigvals(step_matrix(*step))
    return values[np.argmax(np.abs(values))]


def found_root(amplitudes):
    """Of the linear recurrence of third order, a pair that swings and one that dies out, which fits them best."""
    last = [amplitudes[2 - k:len(amplitudes) - 1 - k] for k in range(3)]
    left = np.array([np.concatenate([a.real, a.imag]) for a in last]).T
    right = np.concatenate([amplitudes[3:].real, amplitudes[3:].imag])
    roots = np.roots([1, *-np.linalg.lstsq(left, right, rcond=None)[0]])
    return roots[np.argmax(np.abs(roots))]


class SoundWaves(CoupledTestCase):
    def check(self, free):
        """Spheres that a face cuts, and they alone, have the mean of two cells (free_waves.py): of the smoothing from faces
        to cells and back, 1 - cos(kh/2) of a wave each way, 2 (9/70) d/h (1 - cos kh) more or less, somewhere between not
        at all and in all of a step. The law leaves out the gas's own mass, 1e-3 of that of the particles."""
        number = 2 * np.pi / (HIGH * CELL)
        pressure = (OMEGA / (number * DT)) ** 2 * EPS * (1 - EPS) * RATIO * RHO
        gas = (f"density idealGas; idealGas {{ pressure {pressure!r}; temperature 300;"
               f" molWeight {RHO / pressure * 8314.46261815324 * 300!r}; }}")
        stiffness = X * (1 - EPS) * RATIO / EPS
        case, log, x = solve(self.column, f"sound{'-free' * free}", (EPS, RATIO, 0.01, SUB_STEPS, stiffness), (1, HIGH),
                             COLUMNS**3, LAST, "B", free, 1e-9, COLUMNS, 1, gas)
        self.expect_near("x", x, X, 1e-5 * X)
        along = np.array([np.fft.rfft(cells(case, f"{n * DT:.8g}", "p")) for n in range(FIRST, LAST + 1)])
        d = (6 * (1 - EPS) / np.pi) ** (1 / 3) / COLUMNS
        for wave in (1, 2):
            half = np.pi * wave / HIGH
            omega = OMEGA * wave * np.sin(half) / half
            cut = 1 - 2 * 9 / 70 * d * (1 - np.cos(2 * half))
            seen = np.cos(half)
            law = root(omega, free, seen, seen)
            room = abs(law - root(omega, free, seen * cut, seen * cut))
            found = found_root(along[:, wave])
            what = f"wave {wave} to the box{', response free' * free}"
            self.expect_near(f"{what}: growth in a step", abs(found), abs(law), room + 1 / RATIO)
            self.expect_near(f"{what}: phase", abs(np.angle(found)), abs(np.angle(law)), room + 1 / RATIO)
            self.expect_equal(f"{what}: grows", abs(found) > 1, not free)

    def test_held_particles_are_late_and_waves_grow(self):
        self.check(free=False)

    def test_free_response_lets_them_die_out(self):
        self.check(free=True)


if __name__ == "__main__":
    unittest.main()
