# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through three layers of spheres that are held where they are, free rows of cells below
and above, with every drag closure: in every row eps U is the superficial velocity, and the pressure
drop is what the closure, written out again in closure_formulas.py, gives at each row's
void fraction and slip. The same in both forms of the model."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import drag_report, edit, script_file
from cohesion_tests.coupling.held_layers import (DT, G, HEIGHT, MU, RHO, ROW, ROWS, STEPS, SUPERFICIAL, blow, drag, drop,
                                                drop_error, flux_limit, rows, solid, viscous)
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES
from cohesion_tests.theory.closure_page import Range
from cohesion_tests.theory.filtered_drag import share


class PackedBed(CoupledTestCase):
    def check(self, name, settings, closure, column=None, moved=0.0):
        """The bed with `settings` of the drag in couplingProperties, against `closure`; `column`: makes the case; `moved`:
        relative error of the drag, as spheres of its mass would begin to move within a step."""
        case, continuity, log = blow(column or self.column, name, settings)
        early, late = "0.001", "0.002"
        eps = np.array([1 - solid(row) for row in ROWS])
        # eps grad p = -drag - eps rho g - transport of momentum
        steps = np.array([drag(row, closure) for row in ROWS]) / eps * ROW
        # From the middle of the lowest row to that of the highest there are nine rows of weight.
        expected = steps.sum() + RHO * G * 9 * ROW

        # Numbers are written with 12 digits.
        for k, found in enumerate(rows(case, late, "voidFraction")):
            self.expect_near(f"{name}: void fraction of row {k}", found, eps[k], 1e-12)

        limit = flux_limit(expected)
        self.expect_below(f"{name}: error of the flux by the solver's log [m/s]", continuity * HEIGHT / DT, limit)
        velocity = rows(case, late, "U")[:, 2]
        for k in range(len(ROWS)):
            self.expect_near(f"{name}: eps U of row {k}, eps {eps[k]:.3f} [m/s]", eps[k] * velocity[k], SUPERFICIAL,
                             limit)

        solver = drop_error(limit, steps, eps)
        self.expect_near(f"{name}: steady: pressure drop [Pa] at half time", drop(case, early), drop(case, late),
                         2 * solver)
        self.expect_near(f"{name}: pressure drop [Pa]", drop(case, late), expected,
                         viscous(eps) + solver + moved * expected)

        # Void fractions of the rows are 0.425 to 0.887. One evaluation for each sphere and step.
        inside = Range(settings["drag"])
        spheres, outside = (9 * sum(row[0] for row in of) for of in (
            ROWS, [r for r in ROWS if r[0] and (1 - solid(r), RHO * SUPERFICIAL * r[1] / MU) not in inside]))
        self.expect_equal(f"{name}: evaluations and how many were outside", drag_report(log),
                          (STEPS * spheres, STEPS * outside))
        self.expect_equal(f"{name}: warnings", log.count("particles are outside"), int(outside > 0))

    def test_every_closure(self):
        for name, closure in CLOSURES.items():
            self.check(name, {"drag": name}, closure)

    def test_form_B(self):
        self.check("form_B", {"drag": "diFelice", "form": "B"}, CLOSURES["diFelice"])

    def test_parcels(self):
        def of_grains(ctx, eps, slip, d, *gas):
            """Per volume of solid, which grains and parcels have alike."""
            return CLOSURES["ergunWenYu"](ctx, eps, slip, d / 2, *gas)

        self.check("parcels", {"drag": "ergunWenYu", "coarseGraining": 2}, of_grains)

    def test_filter(self):
        """In cells of 20 mm, of spheres of 1e5 kg/m3, for which L is some 160 mm, and the factor 0.9. Within a step
        they would come to no more than b dt/m of the slip, half of it in the mean: 5000 kg/(m3 s) over 1e5 kg/m3."""
        density = 1e5

        def light(name):
            case = self.column(name)
            edit(case, script_file("packed"), "density 1e12", f"density {density!r}")
            return case

        def filtered(ctx, eps, slip, d, rho, mu):
            return CLOSURES["beetstra"](ctx, eps, slip, d, rho, mu) * share(1 - eps, ROW, d, density, rho, mu, G)

        self.check("filter", {"drag": "beetstra", "dragFilter": "radlSundaresan"}, filtered, column=light,
                   moved=5000 / density * DT)

    def test_factor_and_exponent(self):
        def halved(*where):
            return 0.5 * CLOSURES["ergunWenYu"](*where, n="9.6")

        self.check("factor_and_exponent", {"drag": "ergunWenYu", "dragFactor": 0.5, "dragExponent": 9.6}, halved)


if __name__ == "__main__":
    unittest.main()
