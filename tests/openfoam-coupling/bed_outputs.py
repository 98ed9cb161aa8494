# SPDX-License-Identifier: BSD-3-Clause
"""The function objects bedHeight, mixingIndex and particleMovement on spheres whose places are known at
any time: a lattice that flies up as it is, and one whose spheres fly to each other's places, drawn at
random; stopped and continued. And forceBudget on spheres that collide, against the particle engine's own
record of each wall's and the gas's forces. On 1 and 2 ranks."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import BED, CONTROL, COUPLING, append, make_periodic, use_script
from cohesion_tests.coupling.fields import table
from cohesion_tests.coupling.test_case import CoupledTestCase

BOX = np.array([0.06, 0.06, 0.2])
# From the bottom up to BED. Halfway to others' places, spheres crowd in the middle to eight times that.
D, SPACING, SITES = 2e-3, np.array([4e-3, 4e-3, 5e-3]), np.array([15, 15, 20])
BED = SPACING[2] * SITES[2]
T, GAS_STEP, STEP = 0.02, 1e-3, 1e-4
LAYERS = 10  # the rows of cells of the mesh
CELLS = np.array([3, 3, 4])  # of the mixing index: half the bed is two of them
INTERVAL = 0.008
LIMIT = 0.97  # of the surface: about half as much solid as in the lattice
# Digits of the tables: 12. The engine adds up 200 steps, each rounded by 1e-16 of the box.
DIGITS = 1e-11
FUNCTIONS = f"""
functions
{{
    height
    {{
        type bedHeight; libs (cohesionFunctionObjects); layers {LAYERS}; limit {LIMIT};
        restHeight {BED / 2}; writeControl timeStep; writeInterval 5; writePrecision 12;
    }}
    mixing
    {{
        type mixingIndex; libs (cohesionFunctionObjects); cells ({" ".join(map(str, CELLS))});
        writeControl timeStep; writeInterval 5; writePrecision 12;
    }}
    movement
    {{
        type particleMovement; libs (cohesionFunctionObjects); interval {INTERVAL}; writePrecision 12;
    }}
}}
"""


def lattice():
    steps = np.stack(np.meshgrid(*map(np.arange, SITES), indexing="ij"), axis=-1).reshape(-1, 3)
    return (steps + 0.5) * SPACING


def data_file(path, places, velocities, density):
    atoms = "\n".join(f"{i} 1 {D} {density!r} {x!r} {y!r} {z!r}"
                      for i, (x, y, z) in enumerate(places.tolist(), 1))
    moves = "\n".join(f"{i} {x!r} {y!r} {z!r} 0 0 0"
                      for i, (x, y, z) in enumerate(velocities.tolist(), 1))
    box = "\n".join(f"0 {length} {d}lo {d}hi" for length, d in zip(BOX, "xyz"))
    path.write_text(f"Spheres\n\n{len(places)} atoms\n1 atom types\n\n{box}\n\n"
                    f"Atoms\n\n{atoms}\n\nVelocities\n\n{moves}\n")


def make(column, name, script, places, velocities, density, entries, periodic=False):
    """The column with spheres, periodic in x or not; what is appended to a dictionary replaces what it says before."""
    case = column(name)
    use_script(case, script)
    data_file(case.folder / "data.spheres", places, velocities, density)
    append(case, COUPLING, "lammpsCoeffs { variables { data data.spheres; } }")
    append(case, CONTROL, "writePrecision 17;" + entries)
    if periodic:
        make_periodic(case)
    case.mesh()
    return case


def flight(column, name, velocities, end=T, periodic=False):
    """The spheres of lattice(), so heavy that nothing turns them."""
    case = make(column, name, "flight", lattice(), velocities, 1e12,
                f"deltaT {GAS_STEP}; endTime {end}; writeInterval {T / 2};" + FUNCTIONS, periodic)
    append(case, COUPLING, f"particleGravity any; dragFactor 1e-15; lammpsCoeffs {{ variables {{ dt {STEP};"
                           f" period {'p' if periodic else 'f'}; }} }}")
    return case


def at(rows, time):
    """The row of a table at a time, of which there is one."""
    found = rows[np.abs(rows[:, 0] - time) < GAS_STEP / 2]
    assert len(found) == 1, (time, rows[:, 0])
    return found[0, 1:]


def lacey(places, direction=2, layers=2, cells=CELLS):
    """Lacey's index by its definition, of spheres of which the first places were those of lattice()."""
    order = np.argsort(lattice()[:, direction], kind="stable")
    n = len(order)
    colour = np.empty(n, dtype=int)
    colour[order] = np.arange(n) * layers // n
    is_of = colour[:, None] == np.arange(layers)
    index = np.minimum((places / BOX * cells).astype(int), cells - 1)
    cell = np.ravel_multi_index(index.T, cells)
    inside = np.unique(cell)
    shares = np.array([is_of[cell == c].mean(axis=0) for c in inside])
    sizes = np.array([(cell == c).sum() for c in inside])
    p = is_of.mean(axis=0)
    variance = (sizes[:, None] / n * (shares - p) ** 2).sum()
    segregated = (p * (1 - p)).sum()
    random = segregated * (len(inside) - 1) / (n - 1)
    return (segregated - variance) / (segregated - random), random / segregated, len(inside)


def surface(bottom, top):
    """Where the void fraction, linear between the rows' middles, rises through LIMIT above a bed of
    whole rows of cells between bottom and top."""
    row = BOX[2] / LAYERS
    solid = np.pi / 6 * D**3 / SPACING.prod()
    return top - row / 2 + row * (LIMIT - (1 - solid)) / solid


class BedOutputs(CoupledTestCase):
    def check_height(self, what, row, places, expected_surface):
        mean = 2 * places[:, 2].mean()
        self.expect_near(f"{what}: mean [m]", row[0], mean, DIGITS * BOX[2])
        self.expect_near(f"{what}: expansion [1]", row[1], mean / (BED / 2), DIGITS * 4)
        if expected_surface:
            self.expect_near(f"{what}: surface [m]", row[2], expected_surface, DIGITS * BOX[2])
        self.expect_near(f"{what}: highest [m]", row[3], places[:, 2].max() + D / 2, DIGITS * BOX[2])

    def check_movement(self, what, row, way, seconds):
        self.expect_near(f"{what}: over [s]", row[0], seconds, DIGITS)
        self.expect_near(f"{what}: mean [m]", row[1], np.linalg.norm(way, axis=1).mean(), DIGITS * BOX[2])
        for d in range(3):
            self.expect_near(f"{what}: {'xyz'[d]} rms [m]", row[2 + d], np.sqrt((way[:, d] ** 2).mean()),
                             DIGITS * BOX[2])
        self.expect_equal(f"{what}: particles", row[5], float(len(way)))

    def rising(self, ranks):
        """All move up by one cell of the mixing index, and aside, a third of them in an interval through a
        periodic face: what was apart stays apart."""
        what = f"rising, {ranks} ranks"
        up = np.array([0.047, 0, BOX[2] / CELLS[2]])
        velocity = np.tile(up / T, (len(lattice()), 1))
        case = flight(self.column, f"rising-{ranks}", velocity, periodic=True)
        case.solve(ranks=ranks)
        heights, mixed = table(case, "height", "bedHeight"), table(case, "mixing", "mixingIndex")
        self.check_height(f"{what}, start", at(heights, 0), lattice(), surface(0, BED))
        # The void fraction is that of before the last step; at T it would be of rows cut by the lattice.
        self.check_height(f"{what}, end", at(heights, T), lattice() + up, None)
        for time in (0, T):
            index, cells, particles = at(mixed, time)
            # A sum of squares of some thousands that should leave 0, of 1
            self.expect_near(f"{what}: index at {time} s", index, 0, 1e-12)
            self.expect_equal(f"{what}: cells, particles at {time} s", (cells, particles),
                              (18.0, float(len(velocity))))
        movement = table(case, "movement", "particleMovement")
        self.expect_equal(f"{what}: intervals", len(movement), 2)
        for time in (INTERVAL, 2 * INTERVAL):
            self.check_movement(f"{what}, to {time} s", at(movement, time), velocity * INTERVAL, INTERVAL)
        tables = sorted(case.folder.glob("postProcessing/*/*/*"))
        case.run("cohesiveBedFoam", "-postProcess")
        self.expect_equal(f"{what}: function objects that say they lack the particles in postProcess",
                          case.log("cohesiveBedFoam").read_text().count("does nothing: it needs the particles"), 3)
        self.expect_equal(f"{what}: tables afterwards", sorted(case.folder.glob("postProcessing/*/*/*")), tables)

    def aside(self, ranks):
        """All move aside through a periodic face, coloured across it, so slowly that the particle engine, which
        takes them back every third of its steps, has some beyond it in the row of 0.002 s."""
        what = f"aside, {ranks} ranks"
        velocity = np.tile([1.05, 0, 0], (len(lattice()), 1))
        case = flight(self.column, f"aside-{ranks}", velocity, periodic=True)
        cells, colours = np.array([3, 3, 1]), 3
        append(case, CONTROL,
               "functions { across { type mixingIndex; libs (cohesionFunctionObjects); writePrecision 12;"
               f" cells (3 3 1); direction (1 0 0); layers {colours}; writeControl timeStep; writeInterval 1; }} }}")
        case.solve(ranks=ranks)
        rows = table(case, "across", "mixingIndex")
        self.expect_equal(f"{what}: rows", len(rows), round(T / GAS_STEP) + 1)
        for time, index, _, _ in rows:
            expected = lacey((lattice() + velocity * time) % BOX, 0, colours, cells)[0]
            self.expect_near(f"{what}: index at {time:g} s", index, expected, DIGITS)

    def dealt_out(self, ranks):
        """Each flies straight to another's place, drawn at random."""
        what = f"dealt out, {ranks} ranks"
        start = lattice()
        random = np.random.default_rng(20)
        end = start[random.permutation(len(start))]
        # Not on the faces of cells on the way
        end = end + random.uniform(-1e-4, 1e-4, end.shape)
        velocity = (end - start) / T
        case = flight(self.column, f"dealt-out-{ranks}", velocity)
        case.solve(ranks=ranks)
        mixed = table(case, "mixing", "mixingIndex")
        index, cells, _ = at(mixed, T)
        expected, at_random, inside = lacey(end)
        self.expect_near(f"{what}: index at the end", index, expected, DIGITS)
        self.expect_equal(f"{what}: cells at the end", cells, float(inside))
        # N S^2/S0^2 has about the distribution chi-squared of C - 1 degrees of freedom: S^2 spreads by
        # sqrt(2/(C - 1)) of SR^2. Asked for: four times that.
        spread = at_random / (1 - at_random) * np.sqrt(2 / (inside - 1))
        self.expect_near(f"{what}: index at the end, mixed at random", index, 1, 4 * spread)
        half = lacey(start + velocity * T / 2)[0]
        self.expect_near(f"{what}: index at half time", at(mixed, T / 2)[0], half, DIGITS)
        movement = table(case, "movement", "particleMovement")
        self.check_movement(what, at(movement, INTERVAL), velocity * INTERVAL, INTERVAL)
        heights = table(case, "height", "bedHeight")
        self.check_height(f"{what}, start", at(heights, 0), start, surface(0, BED))
        self.check_height(f"{what}, end", at(heights, T), end, None)
        return velocity

    def continued(self, ranks, velocity):
        """The same, stopped at half time in the midst of an interval."""
        what = f"continued, {ranks} ranks"
        case = flight(self.column, f"continued-{ranks}", velocity, end=T / 2)
        case.solve(ranks=ranks)
        # As if it had got further and been killed there
        places = case.folder / "postProcessing/movement/places"
        later = places / "0.016"
        later.write_text("# Time 0.016, 1 particles: number, x, y, z [m]\n1 0 0 0\n")
        (places / "notes").write_text("# Times of this run\n")
        append(case, CONTROL, f"startFrom latestTime; endTime {T};")
        case.finish(case.start(ranks=ranks))
        half = f"{T / 2:g}"
        index = lacey(lattice() + velocity * T)[0]
        self.expect_near(f"{what}: index", at(table(case, "mixing", "mixingIndex", half), T)[0], index, DIGITS)
        movement = table(case, "movement", "particleMovement", half)
        self.expect_equal(f"{what}: intervals", len(movement), 1)
        self.check_movement(what, at(movement, 2 * INTERVAL), velocity * INTERVAL, INTERVAL)
        self.expect_equal(f"{what}: places kept", sorted(f.name for f in places.iterdir()), ["0.016", "notes"])

    def budget(self, ranks):
        """Spheres that collide with each other and with walls, in gas; the walls' forces by their own record."""
        what = f"budget, {ranks} ranks"
        density, gas_step, step, row, end = 1000.0, 1e-4, 1e-5, 4e-3, 8e-3
        random = np.random.default_rng(7)
        places = (np.indices((6, 6, 8)).reshape(3, -1).T + 0.5) * BOX / (6, 6, 8)
        velocities = random.uniform(-2, 2, places.shape)
        case = make(self.column, f"budget-{ranks}", "walled", places, velocities, density,
                    f"deltaT {gas_step}; endTime {end}; writeInterval {end};"
                    "functions { forces { type forceBudget; libs (cohesionFunctionObjects);"
                    f" writeControl timeStep; writeInterval {round(row / gas_step)}; writePrecision 12; }} }}")
        case.solve(ranks=ranks)
        found = table(case, "forces", "forceBudget")
        record = np.loadtxt(case.folder / "forces.dat")
        walls, drag, pressure = record[:, 1:10].reshape(-1, 3, 3).sum(axis=1), record[:, 10:13], record[:, 13:]
        # Rounding of the momentum, of the table's 12 digits
        tolerance = 1e-11 * np.abs(record[:, 1:]).max()
        mass = np.pi / 6 * D**3 * density * len(places)
        for k, time in enumerate((row, end)):
            n = round(row / step)
            first, last = k * n, (k + 1) * n
            self.expect_true(f"{what}, to {time} s: the walls are hit", np.abs(walls[first:last + 1]).max() > 0)
            over, *columns = at(found, time)
            gravity, by_drag, by_pressure, others, gain = np.reshape(columns, (5, 3))
            self.expect_near(f"{what}: over [s]", over, row, DIGITS)
            # Half of the first and of the last step's forces, as velocity Verlet has them; what the fix
            # books for the gas is all of the last and none of the first.
            def mean(forces):
                return (forces[first:last + 1].sum(axis=0) - (forces[first] + forces[last]) / 2) / n
            late = (drag + pressure)[[first, last]]
            expected = mean(walls) + (late[0] - late[1]) / (2 * n)
            for d in range(3):
                where = f"{what}, to {time} s, {'xyz'[d]}"
                self.expect_near(f"{where}: gravity [N]", gravity[d], [0, 0, -9.81 * mass][d], 1e-11 * mass * 9.81)
                self.expect_near(f"{where}: drag [N]", by_drag[d], drag[first + 1:last + 1, d].mean(), tolerance)
                self.expect_near(f"{where}: pressure [N]", by_pressure[d],
                                 pressure[first + 1:last + 1, d].mean(), tolerance)
                self.expect_near(f"{where}: others, the walls [N]", others[d], expected[d], tolerance)
                parts = gravity + by_drag + by_pressure + others
                self.expect_near(f"{where}: gain [N]", gain[d], parts[d], tolerance)

    def test_rising(self):
        self.rising(1)

    def test_aside(self):
        self.aside(1)

    def test_dealt_out(self):
        velocity = self.dealt_out(1)
        self.dealt_out(2)
        self.continued(2, velocity)

    def test_budget(self):
        self.budget(2)


if __name__ == "__main__":
    unittest.main()
