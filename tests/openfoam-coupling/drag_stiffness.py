# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through spheres that are free to move, in a periodic box: both come to the same velocity. By
the coupled solver, for drag from negligible to so stiff that gas and particles would be done in a
millionth of their step; against the scheme written out again, to round-off. How far that is off the exact
solution, for many more cases: stability_table.py; waves of free particles that drag makes: free_waves.py."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import append, exchange_lines
from cohesion_tests.coupling.fields import cells
from cohesion_tests.coupling.free_spheres import DT, RE, RHO, STEPS, SUB_STEPS, U0, Setting, exact, run, solve, times
from cohesion_tests.coupling.test_case import CoupledTestCase

SAID_BY = 2  # steps: the warning of viscous waves is given in the first


def scheme(s):
    """The same by the scheme: gas implicit in the drag of the particles' velocity at its step's start, or
    in what takes them to it when they are free to follow; then the particles' sub-steps, velocity Verlet
    with the mean drag of a sub-step; what they felt and the gas was not charged with, in the next step."""
    u, v, force, deferred = U0, 0.0, 0.0, 0.0
    dt, x = DT / SUB_STEPS, s.b * DT / SUB_STEPS / s.mass
    mean = -np.expm1(-x) / x
    charged = -np.expm1(-SUB_STEPS * x) / (SUB_STEPS * x) if s.free else 1.0
    k = s.stiffness * charged
    per_gas = s.loading / s.mass  # gas velocity by an impulse on each particle
    history = []
    for _ in range(STEPS):
        u = (u + k * v - deferred * per_gas) / (1 + k)
        deferred = -s.b * charged * (u - v) * DT
        for _ in range(SUB_STEPS):
            v += 0.5 * dt * force / s.mass
            force = s.b * mean * (u - v)
            v += 0.5 * dt * force / s.mass
            deferred += force * dt
        history.append((u, v))
    return np.array(history).T


def error_of_first_step(s):
    """Of the particles' velocity, as a share of the slip, if their sub-steps were exact."""
    x = s.b * DT / s.mass
    gain = -np.expm1(-x * (1 + s.loading)) / (1 + s.loading)
    follow = -np.expm1(-x)
    return abs(gain - follow / (1 + (s.loading * follow if s.free else s.stiffness)))


def largest_root(kappa, viscous, engine_steps):
    """In size, of the steps of viscous_waves.h, over shares C in steps of 1/32."""
    w = 0.5 * (1 - 1 / engine_steps)

    def of(seen):
        k, n = kappa * seen, viscous * (1 - seen)
        now, before = 1 + n, 1 - n * seen / 3
        return np.abs(np.roots([1, k * w * now - 1, k * ((1 - w) * now - w * before), -k * (1 - w) * before])).max()
    return max(of(i / 32) for i in range(1, 33))


class DragStiffness(CoupledTestCase):
    def check(self, number, s):
        found, log = run(self.column, str(number), s)
        lines = exchange_lines(log)
        # Each step is a few roundings of u, v and the deferred impulse, which is up to `stiffness` times as
        # large as u, and divided by 1 + stiffness when it is charged. The drag's inertial part: RE.
        tolerance = 1e-13 * STEPS + RE
        for what, values, expected in zip(("gas", "particles"), found, scheme(s)):
            self.expect_below(f"{s}: {what}: largest difference from the scheme", np.abs(values - expected).max(),
                              tolerance)
        self.expect_true(f"{s}: the slip falls from step to step",
                         bool(np.all(np.diff(np.append(U0, found[0] - found[1])) <= 1e-12)))
        # The gas is charged with `stiffness` times a difference of velocities that are rounded to 1e-16.
        momentum = s.eps * RHO * U0 * s.box**3
        self.expect_below(f"{s}: imbalance of the momentum of a step / momentum of the gas",
                          max(x["imbalance"] * abs(x["drag"][2]) for x in lines) * DT / momentum,
                          1e-15 * (100 + s.stiffness))
        late = s.b * DT / s.mass > 1 and error_of_first_step(s) > 0.05
        self.expect_equal(f"{s}: times that it warns of the gas step", log.count("the gas step is"), int(late))
        if s.free and s.b * DT / s.mass > 100:
            self.expect_below(f"{s}: share of the slip by which the particles are late at the end",
                              abs(found[1] - exact(s)[1])[-1], tolerance)

    def check_said(self, log, s):
        """What the warning of viscous waves says, by the roots: of cells that are alike, kappa, M of three directions,
        the growth, and a deltaT that is a whole number of the particles' steps in which nothing grows."""
        numbers_of = r"grow by a factor of (\S+) in a gas step.*kappa = \S.* = (\S+), M = .* = (\S+), (\d+) steps"
        factor, kappa, viscous, steps = map(float, re.search(numbers_of, log).groups())
        # Six digits are printed; kappa has the overlaps' round-off.
        self.expect_near("kappa that is said", kappa, (1 - s.eps) / s.eps / s.ratio, 1e-5 * kappa)
        self.expect_near("M that is said", viscous, 12 * s.mu / RHO * DT / s.h**2, 1e-5 * viscous)
        self.expect_equal("steps of the particles", steps, SUB_STEPS)
        # The growth is to 1e-6, and goes with no more than the first power of kappa and M.
        self.expect_near("growth that is said", factor, largest_root(kappa, viscous, steps), 3e-5 * factor)
        cure = re.search(r"a deltaT of (\S+) s in (\d+) steps of the particles, of (\S+) s each", log)
        if cure:
            longest, steps, particles = map(float, cure.groups())
            self.expect_near("deltaT / whole steps", longest / particles, steps, 1e-9)
        else:
            longest, steps = map(float, re.search(r"a deltaT of (\S+) s, (\d+) steps of the particles as",
                                                  log).groups())
            self.expect_near("deltaT / steps as they are", longest / (DT / SUB_STEPS), steps, 1e-9)
        share = longest / DT
        self.expect_below("growth in the deltaT that is said", largest_root(kappa, viscous * share, steps), 1 + 2e-6)
        if cure:  # three digits, and what was looked for to 1e-3
            self.expect_true("and it is the longest", largest_root(kappa, viscous * share * 1.015, steps) > 1 + 2e-6)

    def test_viscous_waves(self):
        """Free spheres, 16 cells high, in gas so viscous that nu dt/h^2 is 6: light ones move in waves that grow from
        round-off, ten times heavier ones do not, and in form B none; it is said when they do (viscous_waves.h). How
        fast they grow goes with where the lattice's planes are between the faces, so only that they grow is asked
        for."""
        grown = None
        for ratio, form, grow in ((1.0, "A", True), (10.0, "A", False), (1.0, "B", False)):
            s = Setting(1e-2, ratio=ratio, kernel="sphereOverlap", reynolds=0.01, form=form)
            s.high, s.height = 16, 16 * s.h
            what = f"form {form}, density ratio {ratio:g}"
            case, log = solve(self.column, f"viscous-{form}-{ratio:g}", s)
            middle, end = (np.abs(cells(case, time, "p")).max() for time in (times()[STEPS // 2 - 1], times()[-1]))
            if grow:
                a_step = largest_root((1 - s.eps) / s.eps / s.ratio, 12 * s.mu / RHO * DT / s.h**2, SUB_STEPS)
                grown = a_step**(STEPS - STEPS // 2)
            # Halfway, in powers, from what does not grow, the round-off of two moments, to the fastest wave.
            self.expect_equal(f"{what}: the pressure of waves grows", bool(end > np.sqrt(grown) * middle), grow)
            self.expect_equal(f"{what}: times that it is said", log.count("waves of particles that are free"),
                              int(grow))
            if grow:
                self.check_said(log, s)
                append(case, "system/controlDict", f"endTime {SAID_BY * DT!r};")
                self.check_said(case.solve("-overwrite", ranks=2), s)
        # Where fewer of the particles' steps do, where these must be shorter, and where nothing does
        for ratio, reynolds in ((1.0, 0.06), (0.4, 0.1), (0.25, 0.1)):
            s = Setting(1e-2, ratio=ratio, kernel="sphereOverlap", reynolds=reynolds, steps=SAID_BY)
            _, log = solve(self.column, f"said-{ratio:g}", s)
            if ratio == 0.25:
                self.expect_true("kappa above 2: says that no deltaT does",
                                 "no deltaT does: somewhere kappa is 2" in log)
            else:
                self.check_said(log, s)
                self.expect_equal(f"density ratio {ratio:g}: steps as they are",
                                  "steps of the particles as they" in log, ratio == 1.0)

    def test_against_the_scheme(self):
        settings = [Setting(1e-6), Setting(1.0), Setting(1e6), Setting(1e6, ratio=1), Setting(1e9, ratio=1),
                    Setting(1e6, eps=0.3, cfl=5), Setting(1.0, eps=0.999, cell=8),
                    Setting(1.0, eps=0.9999, cell=17.4), Setting(1e6, ratio=1, free=True),
                    Setting(1.0, eps=0.9999, cell=17.4, free=True)]
        for number, s in enumerate(settings):
            self.check(number, s)


if __name__ == "__main__":
    unittest.main()
