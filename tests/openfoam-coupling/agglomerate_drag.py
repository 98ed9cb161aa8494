# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through agglomerates that keep their places: the pressure drop, and the force on each of their spheres, are
those of the law on paper, in both forms, on 1 and 2 ranks; a packed bed, and what is bound to its
own image, are as without the law. And agglomerates that move: what the gas lost is what the particles felt, they are
found as they are then, and when a run is continued."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import (CONTROL, COUPLING, ENGINE, ENGINES, append, edit, exchange_lines,
                                           make_periodic, script_file, use_script)
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.held_layers import (CELL, DT, G, HEIGHT, MU, RHO, ROW, STEPS, SUPERFICIAL, blow, drop,
                                                drop_error, flux_limit, viscous)
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.agglomerate_drag import gyration, on_sphere, total
from cohesion_tests.theory.closure_formulas import CLOSURES

RADIUS, SPACING = 2.495e-3, 5e-3  # gaps of 10 um
VOLUME = 4 / 3 * np.pi * RADIUS**3
SLOW = 0.05  # superficial [m/s], Re = 17: by inertia the drag of a pair would be nearly that of two
LAW = {"agglomerateDrag": "equivalentSphere", "particleGravity": "any"}
END = f"{STEPS * DT:g}"
COUNT = (r"bound (\S+) of (\S+), with less drag (\S+), factor (\S+) in the mean of the bound, least (\S+),"
         r" bound to their own image (\S+)")


def grid(*numbers_along):
    """Places of spheres that touch, about the origin [m]."""
    along = [SPACING * (np.arange(n) - (n - 1) / 2) for n in numbers_along]
    return np.stack(np.meshgrid(*along, indexing="ij"), -1).reshape(-1, 3)


def in_columns(agglomerate, heights, off=(0, 0)):
    """The agglomerate in each column of cells at each height: [agglomerate, sphere, 3]."""
    middles = [[x + off[0], y + off[1], z] for x in (0.01, 0.03, 0.05) for y in (0.01, 0.03, 0.05) for z in heights]
    return np.array(middles)[:, None, :] + agglomerate


class Scene:
    """Agglomerates, [places of the spheres], in a column whose rows have the same in each cell."""

    def __init__(self, *groups):
        self.places = np.concatenate([group.reshape(-1, 3) for group in groups])
        self.number = np.concatenate([np.full(group.shape[0] * group.shape[1], group.shape[1]) for group in groups])
        self.gyration = np.concatenate([np.full(group.shape[0] * group.shape[1], gyration(group[0]))
                                        for group in groups])
        self.row = (self.places[:, 2] / ROW).astype(int)
        self.eps = 1 - np.bincount(self.row, minlength=10) / 9 * VOLUME / CELL

    def forces(self, closure):
        """On each sphere, the pressure of the spheres like it included [N]."""
        return np.array([on_sphere(closure, self.eps[k], SLOW, RADIUS, n, r, RHO, MU)
                         for k, n, r in zip(self.row, self.number, self.gyration)])

    def factors(self, closure):
        return self.forces(closure) / np.array([total(closure, self.eps[k], SLOW, RADIUS, RHO, MU)
                                                for k in self.row])

    def forces_here(self, closure, form):
        """The same among those that there are: in form A the drag, eps of it, and the pressure of all [N]."""
        forces = self.forces(closure)
        if form == "B":
            return forces
        return self.eps[self.row] * forces + VOLUME * (self.drops(closure) / ROW)[self.row]

    def drops(self, closure):
        """Fall of pressure over each row, without the weight of the gas [Pa]."""
        return np.bincount(self.row, self.forces(closure), 10) / 9 / CELL * ROW


# A pair across each face between rows, so that it is on two ranks where z is cut; three equal rows.
PAIRS = Scene(in_columns(grid(1, 1, 2), (0.06, 0.08, 0.10, 0.12)))
# Eight in a cube in the middle of each cell of three rows, and a single one beside it.
CUBES = Scene(in_columns(grid(2, 2, 2), (0.07, 0.09, 0.11)), in_columns(grid(1, 1, 1) - 7.4e-3, (0.07, 0.09, 0.11)))
# All are one.
BED = Scene((grid(12, 12, 12) + [0.03, 0.03, 0.09])[None])
# Through the whole width of the column
ROW_ACROSS = Scene(*[(grid(12, 1, 1) + [0.03, 0.01 + 0.02 * k, 0.09])[None] for k in range(3)])


class Agglomerates(CoupledTestCase):
    def blow(self, name, scene, settings, ranks=1, periodic=False):
        def column(folder):
            case = self.column(folder)
            (case.folder / "places").write_text("".join(
                "create_atoms 1 single {!r} {!r} {!r} units box\n".format(*place) for place in scene.places.tolist()))
            case.set(COUPLING, f"{ENGINE}Coeffs/variables/places", "places")
            case.set(COUPLING, f"{ENGINE}Coeffs/variables/across", "p" if periodic else "f")
            if periodic:
                make_periodic(case)
            return case

        return blow(column, name, settings, SLOW, ranks, "agglomerates")

    def check(self, name, scene, closure="beetstra", ranks=1, **settings):
        case, continuity, log = self.blow(name, scene, {"drag": closure, **LAW, **settings}, ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        steps = scene.drops(CLOSURES[closure])
        weight = RHO * G * 9 * ROW
        limit = flux_limit(steps.sum() + weight)
        self.expect_below(f"{name}: error of the flux by the solver's log [m/s]", continuity * HEIGHT / DT, limit)
        # Those are for SUPERFICIAL: the first goes with the speed, the other with the drop over it.
        slower = SLOW / SUPERFICIAL
        off = slower * viscous(scene.eps) + drop_error(limit, steps / slower, scene.eps)
        self.expect_near(f"{name}: pressure drop [Pa]", drop(case, END), steps.sum() + weight, off)
        own = np.bincount(scene.row, scene.forces(CLOSURES[closure]) / scene.factors(CLOSURES[closure]), 10)
        self.expect_below(f"{name}: that limit over what the law takes off the drop [1]",
                          off / (own.sum() / 9 / CELL * ROW - steps.sum()), 0.03)
        self.check_forces(name, case, scene, scene.forces_here(CLOSURES[closure], settings.get("form", "A")), off)
        self.expect_balance(name, exchange_lines(log))
        self.check_counts(name, scene, CLOSURES[closure], log)

    def check_forces(self, name, case, scene, forces, off):
        """In the middle of three equal rows, where the pressure falls evenly: on each sphere, and in sum."""
        cloud = case.folder / END / "lagrangian/particles"
        order = np.argsort(numbers(cloud / "id", 1)[:, 0])
        force = numbers(cloud / "gasForce", 3)[order, 2]
        inside = scene.row == 4
        expected = forces + VOLUME * RHO * G
        self.expect_below(f"{name}: largest error of a force [N]", np.abs(force - expected)[inside].max(),
                          VOLUME * off / ROW)
        self.expect_near(f"{name}: force on all of the row [N]", force[inside].sum(), expected[inside].sum(),
                         inside.sum() * VOLUME * off / ROW)

    def check_counts(self, name, scene, closure, log):
        """The line of the last step, and that of all."""
        factors = scene.factors(closure)[scene.number > 1]
        found = re.findall(COUNT, log)
        self.expect_equal(f"{name}: lines", len(found), STEPS + 1)
        for line, times in ((found[-2], 1), (found[-1], STEPS)):
            values = np.array(line, float)
            self.expect_equal(f"{name}: numbers", values[[0, 1, 2, 5]].tolist(),
                              [times * len(factors), times * len(scene.number), times * (factors < 1).sum(), 0])
        # Six digits
        self.expect_near(f"{name}: mean factor", float(found[-2][3]), factors.mean(), 1e-6)
        self.expect_near(f"{name}: least factor", float(found[-2][4]), factors.min(), 1e-6)
        self.expect_below(f"{name}: it is a law that acts", factors.max(), 0.95)

    @unittest.skipIf(ENGINE != ENGINES[0], "closures know no engine")
    def test_closures(self):
        # Each closure by its name: packed_bed.py; the law with each: tests/src/drag. Here one that has the slip in an
        # exponent, and one with a force instead of the drag.
        for closure in ("diFelice", "tang"):
            self.check(f"closure_{closure}", CUBES, closure)

    def test_ranks(self):
        for ranks, name, scene in ((1, "pairs", PAIRS), (2, "pairs", PAIRS), (2, "cubes", CUBES)):
            self.check(f"{name}_{ranks}", scene, ranks=ranks)

    def test_form_B_factor_and_response(self):
        self.check("form_B", CUBES, form="B")
        self.check("free", CUBES, response="free")

    def unchanged(self, name, scene, image, periodic=False):
        found = []
        for law in ("none", "equivalentSphere"):
            _, _, log = self.blow(f"{name}_{law}", scene, {"drag": "beetstra", **LAW, "agglomerateDrag": law},
                                  periodic=periodic)
            found.append((log, exchange_lines(log)))
        (without, lines), (log, with_law) = found
        self.expect_equal(f"{name}: what gas and particles exchange", with_law, lines)
        self.expect_equal(f"{name}: steps", len(lines), STEPS)
        n = str(len(scene.number))
        self.expect_equal(f"{name}: counts", re.findall(COUNT, log)[0], (n, n, "0", "1", "1", n if image else "0"))
        for words in ("Agglomerates:", "agglomerateDrag equivalentSphere:", "Drag of agglomerates"):
            self.expect_equal(f"{name}: '{words}' without, and with the law", [words in without, words in log],
                              [False, True])

    def test_a_packed_bed_is_unchanged(self):
        self.unchanged("bed", BED, image=False)

    def test_bound_to_its_own_image_is_unchanged_and_counted(self):
        self.unchanged("image", ROW_ACROSS, image=True, periodic=True)

    def test_two_fixes_are_refused(self):
        case = self.column("two")
        use_script(case, "cohesive")
        edit(case, script_file("cohesive"), "fix gas ",
             "fix one all agglomerates 10\nfix two all agglomerates 1\nfix gas ")
        self.start(case)
        self.refused("two fixes agglomerates", case, "has two fixes agglomerates, one and two", "keep one")

    def start(self, case):
        """Of spheres that attract each other, thrown at each other."""
        append(case, COUPLING, "agglomerateDrag equivalentSphere;")
        case.set(COUPLING, f"{ENGINE}Coeffs/variables/A", 1e-15)
        case.mesh()

    def test_agglomerates_that_move(self):
        """With a fix that looks in each step, and one that would look later than the run is long."""
        found = {}
        for every in (1, 100000):
            case = self.column(f"moving_{every}")
            use_script(case, "cohesive")
            edit(case, script_file("cohesive"), "fix gas ", f"fix sets all agglomerates {every}\nfix gas ")
            self.start(case)
            log = case.solve(ranks=2)
            self.expect_balance(f"every {every}", exchange_lines(log))
            found[every] = re.findall(r"Exchange: .*imbalance|" + COUNT, log)
            bound = [line[0] for line in re.findall(COUNT, log)]
            self.expect_true(f"more and more are bound, {bound}", 0 <= float(bound[0]) < 100 < float(bound[-2]))
        self.expect_equal("found when they are asked for, and in each step", found[100000], found[1])

    @unittest.skipIf(ENGINE != ENGINES[0], "how scripts continue is tested with both engines in restart.py")
    def test_continued(self):
        """A run that is continued in the middle has the agglomerates of one that was not stopped."""
        found = {}
        for stops in ((0.01,), (0.005, 0.01)):
            case = self.column(f"continued_{len(stops)}")
            use_script(case, "sticking")
            case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
            append(case, CONTROL, "startFrom latestTime; writeInterval 0.005; writePrecision 17;")
            self.start(case)
            log = ""
            for end in stops:
                case.set(CONTROL, "endTime", end)
                log += case.solve()
            found[len(stops)] = ([line[0] for line in re.findall(r"(Agglomerates: bound .*)()", log)],
                                 np.array([line["drag"] for line in exchange_lines(log)]))
        (counts, drag), (continued, again) = found[1], found[2]
        self.expect_equal("steps", len(drag), 100)
        self.expect_equal("agglomerates of all steps", continued, counts)
        # Nothing is lost of the particles; what the solver of p leaves, 1e-13, may grow by collisions in 50 steps. One
        # sphere of 1000 whose factor is another, by 0.1 or so, makes 1e-4 of the drag.
        off = np.abs(again - drag).max() / np.abs(drag).max()
        self.expect_below("difference of the drag, over the drag", off, 1e-6)


if __name__ == "__main__":
    unittest.main()
