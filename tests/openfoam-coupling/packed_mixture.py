# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through spheres of two sizes that are held where they are, of a ratio of four and of two, by the laws for
mixtures: the pressure drop, and the force on each size, are those of the law as it is printed, in both forms, with both
engines, on 1 and 2 ranks. Asked is 0.1 %; the limits here are what the solver leaves."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import ENGINE, ENGINES, exchange_lines
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.held_layers import (CELL, DT, G, HEIGHT, MU, RHO, ROW, SUPERFICIAL, blow, drop, drop_error,
                                                flux_limit, viscous)
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE
from cohesion_tests.theory.size_mixture import forces

FREE, FOUR, TWO = [], [(8**3, 2e-3), (2**3, 8e-3)], [(5**3, 2e-3), (4**3, 4e-3)]
# Two free ones at both ends, for convection to have no part in the pressure drop.
ROWS = [FREE, FREE, FOUR, FOUR, FOUR, TWO, TWO, TWO, FREE, FREE]
END = "0.002"


def solid(row):
    return sum(number * np.pi / 6 * d**3 for number, d in row) / CELL


def on_spheres(row, law, closure, parcel=1):
    """The force on a sphere of each kind in a row [N], without that of the gas's weight; of parcels on all the grains of
    one."""
    if not row:
        return np.array([])
    per_volume = [(number * parcel**3 / CELL, d / parcel) for number, d in row]
    return parcel**3 * forces(law, closure, 1 - solid(row), SUPERFICIAL, per_volume, RHO, MU)


def drops(law, closure, parcel=1):
    """Fall of pressure over each row [Pa], without that of the gas's weight."""
    return np.array([sum(n * force for (n, _), force in zip(row, on_spheres(row, law, closure, parcel)))
                     for row in ROWS]) / CELL * ROW


class PackedMixture(CoupledTestCase):
    def check(self, name, law, closure="beetstra", ranks=1, **settings):
        found = {"drag": closure, "dragMixture": law, **settings}
        case, continuity, log = blow(self.column, name, found, ranks=ranks, script="mixed")
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        eps = np.array([1 - solid(row) for row in ROWS])
        parcel = settings.get("coarseGraining", 1)
        steps = drops(law, CLOSURES[closure], parcel)
        weight = RHO * G * 9 * ROW
        limit = flux_limit(steps.sum() + weight)
        self.expect_below(f"{name}: error of the flux by the solver's log [m/s]", continuity * HEIGHT / DT, limit)
        off = viscous(eps) + drop_error(limit, steps, eps)
        self.expect_near(f"{name}: pressure drop [Pa]", drop(case, END), steps.sum() + weight, off)
        self.expect_below(f"{name}: that limit over the drop [1]", off / steps.sum(), 1e-3)
        self.check_forces(name, case, [on_spheres(row, law, CLOSURES[closure], parcel) for row in ROWS], off)
        self.expect_below(f"{name}: imbalance of momentum [1]", exchange_lines(log)[-1]["imbalance"], 1e-12)

    def check_forces(self, name, case, expected, off):
        """In the middle of three equal rows, where the pressure falls evenly."""
        cloud = case.folder / END / "lagrangian/particles"
        height = numbers(cloud / "positions", 4)[:, 2]
        kinds = numbers(cloud / "type", 1)[:, 0]
        force = numbers(cloud / "gasForce", 3)[:, 2]
        for row in (3, 6):
            inside = (height > row * ROW) & (height < (row + 1) * ROW)
            first = 1 if row == 3 else 3
            for k, (number, d) in enumerate(ROWS[row]):
                of_kind = force[inside & (kinds == first + k)]
                self.expect_equal(f"{name}, row {row}: spheres of {d:g} m", len(of_kind), 9 * number)
                volume = np.pi / 6 * d**3
                self.expect_near(f"{name}, row {row}: force on spheres of {d:g} m [N]", of_kind.mean(),
                                 expected[row][k] + volume * RHO * G, volume * off / ROW)
                # Their cells are alike but for what solvers leave of the flux.
                self.expect_below(f"{name}, row {row}: spread of the forces over them", np.ptp(of_kind) / of_kind.mean(),
                                  1e-6)

    @unittest.skipIf(ENGINE != ENGINES[0], "closures know no engine")
    def test_closures(self):
        # Each closure by its name: packed_bed.py; the laws with each: tests/src/drag. Here one that has the slip in an
        # exponent, and one with a force instead of the drag.
        for closure in ("diFelice", "tang"):
            self.check(closure, "vanDerHoef", closure)

    def test_both_laws_in_both_forms(self):
        for law in ("carmanKozeny", "vanDerHoef"):
            for form in "AB":
                self.check(f"{law}_{form}", law, form=form)

    def test_ranks(self):
        self.check("ranks", "vanDerHoef", ranks=2)

    def test_parcels(self):
        """Spheres that stand for grains feel the drag of these; so do those of a mixture."""
        self.check("parcels", "vanDerHoef", coarseGraining=1.5)
        self.check("parcels_ergun", "carmanKozeny", "ergunWenYu", coarseGraining=2)

    def test_free_response(self):
        self.check("free", "vanDerHoef", response="free")

    def test_without_a_law_each_is_as_among_its_own(self):
        """Which is another pressure drop."""
        closure = CLOSURES["beetstra"]
        case, _, _ = blow(self.column, "own", {"drag": "beetstra"}, script="mixed")
        own = sum(number / CELL * np.pi / 6 * d**3 * slip / (1 - solid(row)) * ROW
                  * closure(DOUBLE, 1 - solid(row), slip, d, RHO, MU)
                  for row in ROWS if row for slip in [SUPERFICIAL / (1 - solid(row))] for number, d in row)
        self.expect_near("pressure drop [Pa]", drop(case, END), own + RHO * G * 9 * ROW, 1e-3 * own)
        mixed = drops("carmanKozeny", closure).sum()
        self.expect_true(f"{own:g} Pa is another than {mixed:g}", own > 1.1 * mixed)


if __name__ == "__main__":
    unittest.main()
