# SPDX-License-Identifier: BSD-3-Clause
"""Waves of free spheres that drag carries along (src/drag/pressure_waves.h), in both forms of the model: how fast they
grow, or die out, by the solver and by the eigenvalues of a step, written out again; their warnings; and a layer
of spheres in which nothing may grow."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.coupling.fields import cells
from cohesion_tests.coupling.free_spheres import DT, RHO, SUB_STEPS, U0, Setting, solve as solve_setting, times
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.coupling.waves import CELL, solve

HIGH, COLUMNS = 16, 8  # cells along the box; columns along the edge of a cell
FIRST, LAST = 10, 16  # steps between which the growth is measured


def step_matrix(x, eps, engine_steps, free, form, seen=1.0):
    """What a gas step makes of h, d, g and Q/x, where cells see the share `seen` of what particles displace."""
    n, decay, phi = 1 - eps, np.exp(-x), -np.expm1(-x) / x
    mean = -np.expm1(-x) / (engine_steps * -np.expm1(-x / engine_steps))
    coefficient = phi if free else 1.0
    columns = []
    for h, d, g_last, deferred in np.eye(4):
        u = -n / eps * seen * d
        before = 0 if free else (1 - phi) * g_last
        g = -n * (coefficient * (u - h) + deferred - before) / (eps + n * (1 - phi)) if form == "A" else 0.0
        v = u - g
        after = v + decay * (h - v)
        columns.append([after, v + mean * (h - v), g,
                        (after - h) / x + g - coefficient * (u - h) - (1 - phi) * g + before])
    return np.array(columns).T


def roots(*step):
    """Sizes of the eigenvalues, the largest first"""
    return np.sort(np.abs(np.linalg.eigvals(step_matrix(*step))))[::-1]


def sliced(d):
    """Share of a face between two rows of cells that spheres of the diameter d cover, over the share of the solid: the
    columns stand COLUMNS^2 to a spacing."""
    spacing = CELL / COLUMNS
    z = (np.arange(COLUMNS**2) / COLUMNS**2 + 0.5) % 1 * spacing
    z = np.minimum(z, spacing - z)
    covered = np.pi * np.maximum(d**2 / 4 - z**2, 0) + np.pi * np.maximum(d**2 / 4 - (spacing - z) ** 2, 0)
    return covered.mean() * spacing / (np.pi / 6 * d**3)


class FreeWaves(CoupledTestCase):
    def check_growth(self, eps, stiffness, form, free, grows):
        """A wave along the box has the factor cos^2(pi i/HIGH) for what cells see of it. Spheres that a face cuts, and
        they alone, have the mean of two cells: spread and gathered, the share of a cell in its neighbour's is a = (d/h)
        int w (1 - w), w = 3 t^2 - 2 t^3 the part of a sphere beyond a plane: 9/70 d/h. So the cells' 1 is 1 - 2 a (1 -
        cos kh) somewhere between not at all and in all of a step."""
        what = f"eps {eps}, stiffness {stiffness:g}, form {form}{', response free' * free}"
        name = re.sub("[^a-zA-Z0-9]+", "-", what)
        case, log, x = solve(self.column, name, (eps, 1000.0, 0.01, SUB_STEPS, stiffness), (1, HIGH), COLUMNS**3, LAST,
                             form, free, 1e-9 if grows else 1e-6, COLUMNS, 2)
        waves = []
        for n in (FIRST, LAST):
            along = cells(case, f"{n * DT:.8g}", "U")
            waves.append(np.abs(np.fft.rfft(along)))
        d = CELL / COLUMNS * (6 * (1 - eps) / np.pi) ** (1 / 3)
        for wave in (1, 2):
            seen = np.cos(np.pi * wave / HIGH) ** 2
            cut = 1 - 2 * 9 / 70 * d / CELL * (1 - np.cos(2 * np.pi * wave / HIGH))
            largest, second = roots(x, eps, SUB_STEPS, free, form, seen)[:2]
            # Of the wave of the second root there is (second/largest)^FIRST left.
            tolerance = (abs(largest - roots(x, eps, SUB_STEPS, free, form, seen * cut * sliced(d))[0])
                         + largest * (second / largest) ** FIRST)
            self.expect_near(f"{what}: growth of the wave {wave} to the box", (waves[1][wave] / waves[0][wave])
                             ** (1 / (LAST - FIRST)), largest, tolerance)
        self.check_said(what, log, roots(x, eps, SUB_STEPS, free, form)[0], eps, x)

    def check_said(self, what, log, growth, eps, x):
        """The warning, where all cells are alike"""
        self.expect_equal(f"{what}: times that it warns of waves", log.count("would swing against the gas"),
                          int(growth > 1))
        if growth > 1:
            said = re.search(r"displace and grow by a factor of (\S+) in a gas step, fastest at the particle at"
                             r" \(.*?\): void fraction (\S+), x = b deltaT/m = (\S+)\. ", log)
            if not said:
                return self.expect_true(f"{what}: the warning has growth, place, void fraction and x", False)
            # The growth is to 1e-6; kernels make the void fraction to 1e-14 of spheres; the factor of drag has its
            # digits.
            of_each = zip(("growth", "void fraction", "x"), map(float, said.groups()), (growth, eps, x))
            for of, found, expected in of_each:
                self.expect_near(f"{what}: {of} that is said", found, expected, 3e-6 * expected)

    def test_layer(self):
        """Free spheres in a layer, so stiff that they hand all of the pressure on to the gas within a step: charged a
        step late it would grow by 1.61 a step in form A. It dies out, as in form B."""
        for form, free in (("A", False), ("A", True), ("B", False)):
            s = Setting(1e9, kernel="sphereOverlap", layer=True, reynolds=100.0, form=form, free=free)
            what = f"layer, form {form}{', response free' * free}"
            case, log = solve_setting(self.column, f"layer-{form}{'-free' * free}", s)
            early, late = (np.abs(cells(case, time, "p")).max() for time in (times()[3], times()[-1]))
            # What is steady stays. A wave that dies out has been smaller than now by the condition of the eigenvectors
            # of its step at most; of held response in form A, which dies out last. In 16 steps 1.61 makes 2000.
            _, vectors = np.linalg.eig(step_matrix(s.b * DT / s.mass, s.eps, SUB_STEPS, False, "A"))
            limit = np.linalg.cond(vectors)
            self.expect_below(f"{what}: pressure at the end over that of the fourth step", late / early, limit)
            self.expect_equal(f"{what}: times that it warns of waves", log.count("would swing against the gas"), 0)
            if form == "A":
                # The gas is charged with `stiffness` times a difference of velocities that are rounded to 1e-16.
                momentum = s.eps * RHO * U0 * s.box**2 * s.height
                self.expect_below(f"{what}: imbalance of the momentum of a step / momentum of the gas",
                                  max(x["imbalance"] * (abs(x["drag"][2]) + abs(x["pressure"][2]))
                                      for x in exchange_lines(log)) * DT / momentum, 1e-15 * (100 + s.stiffness))

    def test_growth(self):
        for eps, stiffness, form, free, grows in ((0.45, 1e9, "A", False, True), (0.65, 1e9, "A", False, False),
                                                  (0.45, 1e4, "A", False, True), (0.3, 1e9, "B", False, True),
                                                  (0.4, 1e9, "B", False, False), (0.3, 1e9, "A", True, True)):
            self.check_growth(eps, stiffness, form, free, grows)


if __name__ == "__main__":
    unittest.main()
