# SPDX-License-Identifier: BSD-3-Clause
"""What each kernel makes of spheres: beside walls, beyond a periodic face, across ranks, in cells that are
no boxes and on meshes that do not resolve a direction, their volume is kept and in the right cells;
smoothing has its width on any mesh; and a packed bed whose spheres are cut by the faces between rows has
the pressure drop that follows from the kernel's shares, which are written out again here."""

import unittest

import numpy as np
from scipy.linalg import solve_banded

from cohesion_tests.coupling import held_layers
from cohesion_tests.coupling.cases import COUPLING, exchange_lines, make_periodic
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.held_layers import G, HEIGHT, MU, RHO, ROW, STEPS, SUPERFICIAL, blow, drop, rows
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

KERNELS = ("particleCentre", "dividedVolume", "sphereOverlap")
EDGES = np.linspace(0, HEIGHT, 11)
WIDTH = 0.015  # of the smoothing, on rows of 20 mm

# column/layers.lmp: of each layer the spheres of all columns
D, PER_CELL = 3.2e-3, 25
LAYERS = 3.3e-3 * (np.arange(60) + 0.5)
LAYERS = LAYERS[(LAYERS > 0.05) & (LAYERS < 0.14)]
VOLUME = np.pi / 6 * D**3


def below(t):
    """Share of a sphere below the height t [radii] from its centre."""
    t = np.clip(t, -1, 1)
    return 0.25 * (1 + t) ** 2 * (2 - t)


def divided_heights():
    """Heights of the 29 points [radii]: centre, and 14 points in each of two shells of 14/29 of the
    volume, as far out as their shell's mean distance."""
    heights = [0.0]
    for a, b in (((1 / 29) ** (1 / 3), (15 / 29) ** (1 / 3)), ((15 / 29) ** (1 / 3), 1)):
        r = 3 * (b**4 - a**4) / (4 * (b**3 - a**3))
        heights += [r, -r, 0, 0, 0, 0] + 4 * [r / np.sqrt(3)] + 4 * [-r / np.sqrt(3)]
    return np.array(heights)


def shares(kernel):
    """Share of each layer in each row, [layer, row]."""
    relative = (EDGES[None, :] - LAYERS[:, None]) / (D / 2)
    if kernel == "sphereOverlap":
        return np.diff(below(relative), axis=1)
    points = divided_heights() if kernel == "dividedVolume" else np.zeros(1)
    return np.diff((points[None, None, :] < relative[:, :, None]).mean(axis=2), axis=1)


def smooth(values, width, cell=ROW):
    """(1 - width^2/8 d2/dz2)^-4 on cells in a row, no flux through the ends; columns of `values`."""
    s, n = width**2 / 8 / cell**2, len(values)
    diagonal = np.full(n, 1 + 2 * s)
    diagonal[[0, -1]] = 1 + s
    bands = np.array([np.full(n, -s), diagonal, np.full(n, -s)])
    for _ in range(4):
        values = solve_banded((1, 1), bands, values)
    return values


def solid(column, name, kernel, places, diameter, cells=(3, 3, 10), periodic=False, width=None,
          ranks=1, spoil=None, volume=None):
    """Solid volume of each cell [m3], indexed [x, y, z], and the Exchange line, after two steps
    with spheres at `places`. spoil(case): changes to the mesh; volume: of the cells [m3], if it makes
    them differ, each column in x and y then being a block of the mesh."""
    case = column(name)
    if spoil:
        spoil(case)
    mesh = (case.folder / "system/blockMeshDict")
    text = mesh.read_text().replace("(3 3 10)", "({} {} {})".format(*cells))
    mesh.write_text(text)
    if periodic:
        make_periodic(case)
    commands = [f"create_atoms 1 single {x!r} {y!r} {z!r}" for x, y, z in places]
    (case.folder / "places").write_text("\n".join(commands) + "\n")
    case.set(COUPLING, "voidFraction", kernel)
    case.set(COUPLING, "minVoidFraction", 1e-3)
    if width:
        case.set(COUPLING, "smoothingWidth", width)
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/few.lmp"')
    for variable, value in (("places", "places"), ("diameter", diameter),
                            ("period", "p" if periodic else "f")):
        case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", value)
    case.set("system/controlDict", "endTime", 2e-4)
    case.set("system/controlDict", "writeInterval", 2e-4)
    case.set("system/controlDict", "writePrecision", 17)
    case.mesh()
    line = exchange_lines(case.solve(ranks=ranks))[-1]
    if ranks > 1:
        case.run("reconstructPar")
    eps = field(case, "0.0002", "voidFraction")
    if volume is not None:
        return (1 - eps).reshape(cells) * volume, line  # blockMesh counts block by block
    volume = 0.06 * 0.06 * 0.2 / np.prod(cells)
    return ((1 - eps) * volume).reshape(cells[::-1]).transpose(2, 1, 0), line


def divided_points():
    """The 29 points [radii] of divided_heights(), all three coordinates."""
    found = [np.zeros(3)]
    for a, b in (((1 / 29) ** (1 / 3), (15 / 29) ** (1 / 3)), ((15 / 29) ** (1 / 3), 1)):
        r = 3 * (b**4 - a**4) / (4 * (b**3 - a**3))
        found += [sign * r * axis for axis in np.eye(3) for sign in (1, -1)]
        found += [r / np.sqrt(3) * np.array([x, y, z]) for x in (1, -1) for y in (1, -1) for z in (1, -1)]
    return np.array(found)


# Two columns of cells that meet in an inclined plane: x = BORDER[0] at the bottom, BORDER[1] at the top.
BORDER = (0.02, 0.04)
INCLINED = """
vertices
(
    (0 0 0) (20 0 0) (20 60 0) (0 60 0) (0 0 200) (40 0 200) (40 60 200) (0 60 200)
    (60 0 0) (60 60 0) (60 0 200) (60 60 200)
);
blocks
(
    hex (0 1 2 3 4 5 6 7) (1 1 10) simpleGrading (1 1 1)
    hex (1 8 9 2 5 10 11 6) (1 1 10) simpleGrading (1 1 1)
);
boundary
(
    bottom  { type patch; faces ((0 3 2 1) (1 2 9 8)); }
    top     { type patch; faces ((4 5 6 7) (5 10 11 6)); }
    sides   { type wall;  faces ((0 1 5 4) (1 8 10 5) (8 9 11 10) (9 2 6 11) (2 3 7 6) (3 0 4 7)); }
);
"""


def incline(case):
    mesh = case.folder / "system/blockMeshDict"
    mesh.write_text(mesh.read_text().split("vertices")[0] + INCLINED)


def flat(case):
    """One cell thick in y, which the mesh then does not resolve."""
    mesh = case.folder / "system/blockMeshDict"
    text = mesh.read_text().replace(
        "    sides   { type wall;  faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }",
        "    sides   { type wall;  faces ((1 2 6 5) (3 0 4 7)); }\n"
        "    slices  { type empty; faces ((0 1 5 4) (2 3 7 6)); }")
    mesh.write_text(text)
    for file in (case.folder / "0.orig").iterdir():
        file.write_text(file.read_text().replace("    top ", "    slices { type empty; }\n    top "))


class VoidFractionKernels(CoupledTestCase):
    def check_packed_bed(self, kernel, width, form="A"):
        name = f"{kernel}-{width}-{form}"
        closure = CLOSURES["ergunWenYu"]
        settings = {"voidFraction": kernel, "drag": "ergunWenYu", "form": form}
        if width:
            settings["smoothingWidth"] = width
        case, continuity, log = blow(self.column, name, settings, script="layers")
        weight = shares(kernel)
        assert np.allclose(weight.sum(axis=1), 1)
        if width:
            weight = smooth(weight.T, width).T  # spread, then smooth: of each layer to each row
        eps = 1 - PER_CELL * VOLUME * weight.sum(axis=0) / ROW**3
        at_layer, slip = weight @ eps, weight @ (SUPERFICIAL / eps)
        b = np.array([VOLUME * closure(DOUBLE, e, u, D, RHO, MU) for e, u in zip(at_layer, slip)])
        if form == "B":
            b /= at_layer
        force = PER_CELL * (weight.T @ b) / ROW**3 * SUPERFICIAL / eps  # on the gas of a row [N/m3]
        # In form A the gas takes eps of the pressure gradient, in B all of it.
        steps = force / (eps if form == "A" else 1) * ROW
        # Smoothed, the end rows have some spheres. From middle to middle half their drag counts; and as the
        # gas is not equally fast there, convection, rho eps U (U_above - U_below)/2 with the central scheme
        # and U of the end rows at the ends, leaves (of form A; in B nothing, where the end rows are free)
        assert form == "A" or not width
        u = SUPERFICIAL / eps
        convection = RHO / 4 * (u[-2] * u[-1] + u[-1] ** 2 - u[0] * u[1] - u[0] ** 2)
        expected = (steps[:-1] + steps[1:]).sum() / 2 + RHO * G * 9 * ROW + convection

        for k, found in enumerate(rows(case, "0.002", "voidFraction")):
            # Written with 12 digits
            self.expect_near(f"{name}: void fraction of row {k}", found, eps[k], 1e-12)
        # As in packed_bed.py, of form A; form B has no 1/eps in the inertia and in the viscous stress, so
        # its errors are smaller.
        limit = held_layers.flux_limit(expected)
        solver = held_layers.drop_error(limit, steps, eps)
        self.expect_below(f"{name}: error of the flux [m/s]", continuity * HEIGHT / held_layers.DT, limit)
        self.expect_near(f"{name}: pressure drop [Pa]", drop(case, "0.002"), expected,
                         held_layers.viscous(eps) + solver)
        lines = exchange_lines(log)
        self.expect_equal(f"{name}: steps", len(lines), STEPS)
        self.expect_balance(name, lines)

    def test_places(self):
        """A sphere on a corner of cells, one half beyond a periodic face, one a tenth of its diameter
        beyond a wall."""
        d = 8e-3
        volume = np.pi / 6 * d**3
        places = [(0.02, 0.04, 0.06), (0.0, 0.03, 0.11), (0.03, 0.0032, 0.15)]
        # void fraction 1 - x is rounded to 1e-16: in a cell of 8e-6 m3 that is
        rounding = 2e-16 * 8e-6
        for ranks in (1, 2):
            found, line = solid(self.column, f"places-{ranks}", "sphereOverlap", places, d,
                                periodic=True, ranks=ranks)
            expected = np.zeros((3, 3, 10))
            expected[0:2, 1:3, 2:4] += volume / 8
            expected[0, 1, 5] += volume / 2
            expected[2, 1, 5] += volume / 2
            expected[1, 0, 7] += volume
            error = np.abs(found - expected).max()
            # Shares to 1e-14 of the sphere, by sphere_box_overlap_test.cpp
            self.expect_below(f"corner, periodic face and wall, {ranks} ranks: error of a cell [m3]", error,
                              1e-14 * volume + rounding)
            self.expect_below("error of the solid volume", line["volume"], 1e-12)

    def test_inclined(self):
        """Cells that are no boxes: a sphere that their border cuts, and one far from it."""
        d = 8e-3
        volume = np.pi / 6 * d**3
        middles = ROW * (np.arange(10) + 0.5)
        left = 0.06 * ROW * (BORDER[0] + (BORDER[1] - BORDER[0]) * middles / HEIGHT)
        cells = np.stack([left, 0.06 * 0.06 * ROW - left])[:, None, :]
        # In the middle of a row, where the border is at x = 0.031
        cut, whole = np.array((0.0309, 0.03, 0.11)), (0.05, 0.03, 0.05)
        slope = (BORDER[1] - BORDER[0]) / HEIGHT
        normal = np.array((1, 0, -slope)) / np.hypot(1, slope)
        distance = (np.array((BORDER[0], 0, 0)) - cut) @ normal / (d / 2)  # of the plane [radii]
        points = divided_points() @ normal
        assert np.abs(points - distance).min() > 1e-3
        shares_left = {"particleCentre": (float(distance > 0), 0.0),
                       "dividedVolume": ((points < distance).mean(), 0.0),
                       # By 500 points, which void_fraction_kernel_test.cpp finds within 3 % of the sphere
                       "sphereOverlap": (below(distance), 0.03)}
        for kernel, (share, tolerance) in shares_left.items():
            found, line = solid(self.column, f"inclined-{kernel}", kernel, [tuple(cut.tolist()), whole], d,
                                cells=(2, 1, 10), spoil=incline, volume=cells)
            expected = np.zeros((2, 1, 10))
            expected[:, 0, 5] = volume * np.array((share, 1 - share))
            expected[1, 0, 2] = volume
            # The volume of a cell is rounded to a few 1e-16, and so is 1 - x.
            self.expect_below(f"inclined cells, {kernel}: largest error of a cell / sphere",
                              np.abs(found - expected).max() / volume,
                              tolerance + 1e-14 + 1e-15 * cells.max() / volume)
            self.expect_below("error of the solid volume", line["volume"], 1e-12)
            self.expect_below("imbalance of the forces", line["imbalance"], 1e-12)

    def test_flat(self):
        """A mesh that does not resolve y: a sphere on the edge of four cells, one that the border between
        two rows cuts off its middle, and one nearer to the front than its radius."""
        d, t = 8e-3, 0.3
        volume = np.pi / 6 * d**3
        places = [(0.02, 0.03, 0.06), (0.03, 0.03, 0.12 - t * d / 2), (0.05, 0.001, 0.15)]
        points = divided_points()
        assert np.abs(points[:, 2] - t).min() > 1e-3
        for kernel, lower in (("sphereOverlap", below(t)), ("dividedVolume", (points[:, 2] < t).mean())):
            # On the edge the points of dividedVolume lie on faces, in both cells: shares by round-off
            some = places if kernel == "sphereOverlap" else places[1:]
            found, line = solid(self.column, f"flat-{kernel}", kernel, some, d, cells=(3, 1, 10), spoil=flat)
            expected = np.zeros((3, 1, 10))
            if some is places:
                expected[0:2, 0, 2:4] += volume / 4
            expected[1, 0, 5] += volume * lower
            expected[1, 0, 6] += volume * (1 - lower)
            expected[2, 0, 7] += volume
            # As in check_places(), with cells of 2.4e-5 m3
            self.expect_below(f"flat cells, {kernel}: largest error of a cell [m3]",
                              np.abs(found - expected).max(), 1e-14 * volume + 2e-16 * 2.4e-5)
            self.expect_below("error of the solid volume", line["volume"], 1e-12)
            self.expect_below("imbalance of the forces", line["imbalance"], 1e-12)

    def test_ranks(self):
        """The same field on 1 and 2 ranks, whose border at x = 0.02 m or 0.04 m many of the spheres cross,
        some of them on their way through a periodic face."""
        random = np.random.default_rng(4711)
        places = random.uniform((0, 0.006, 0.006), (0.06, 0.054, 0.194), size=(60, 3)).tolist()
        for kernel, width in [(kernel, None) for kernel in KERNELS] + [("particleCentre", WIDTH)]:
            fields = [solid(self.column, f"ranks-{kernel}-{width}-{ranks}", kernel, places, 0.012,
                            periodic=True, width=width, ranks=ranks) for ranks in (1, 2)]
            (one, line1), (two, line2) = fields
            # Sums of up to 60 shares in another order, and the rounding of 1 - x; what the linear solver
            # leaves of the smoothing, 1e-15 of the sum of sizes, is spread over 90 cells.
            self.expect_below(f"{kernel}, smoothed over {width}: 2 ranks against 1, largest cell",
                              np.abs(two - one).max() / 8e-6, 1e-14 if not width else 1e-13)
            for line in (line1, line2):
                self.expect_below("error of the solid volume", line["volume"], 1e-12)

    def test_width(self):
        """A sphere in the centre of a cell, smoothed: summed over the other two directions it has the
        profile of smooth(), whose second moment is the square of the width, on coarse and on fine cells."""
        width, d = 4e-3, 1e-3
        volume = np.pi / 6 * d**3
        for n in (15, 27):
            cell = 0.06 / n
            place = (0.03, 0.03, (int(0.1 / cell) + 0.5) * cell)
            found, _ = solid(self.column, f"width-{n}", "particleCentre", [place], d,
                             cells=(n, n, 3 * n + n // 3), width=width)
            # Each cell's 1 - x is rounded to 1e-16 of its volume, and so is each cell's share of that.
            rounding = 1.2e-16 * 0.06 * 0.06 * 0.2 / volume
            self.expect_near(f"{n} cells: volume / sphere", found.sum() / volume, 1, 1e-12 + rounding)
            for axis in (0, 2):
                peak = np.zeros(found.shape[axis])
                peak[int(place[axis] / cell)] = 1
                profile = found.sum(axis=tuple({0, 1, 2} - {axis})) / volume
                self.expect_below(f"{n} cells, axis {axis}: profile, largest difference",
                                  np.abs(profile - smooth(peak, width, cell)).max(), 1e-12 + rounding)
            # In a row so long that nothing reaches its ends
            peak = np.zeros(401)
            peak[200] = 1
            distance = cell * (np.arange(401) - 200)
            self.expect_near(f"{n} cells: standard deviation of the profile / width",
                             np.sqrt(smooth(peak, width, cell) @ distance**2) / width, 1, 1e-12)

    def test_packed_bed(self):
        for kernel in KERNELS:
            self.check_packed_bed(kernel, None)
        self.check_packed_bed("sphereOverlap", WIDTH)
        self.check_packed_bed("sphereOverlap", None, form="B")


if __name__ == "__main__":
    unittest.main()
