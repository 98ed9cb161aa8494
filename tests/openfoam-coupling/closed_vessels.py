# SPDX-License-Identifier: BSD-3-Clause
"""Gas of constant density in vessels that nothing leaves, and in ducts that are periodic, with fixedFluxPressure at all
walls: p needs a reference, and what comes in must go out.

- Closed boxes of water and of air, and ducts periodic along x, in which spheres fall: the same flow as with
  zeroGradient. A box of fluid at rest: its weight by the pressure.
- A duct that a source drives, or meanVelocityForce: the profile between two plates.
- A cavity whose lid moves, with one sphere and with many that follow: Ghia, Ghia and Shin (1982), Re 100."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, edit, make_periodic, script_file, use_script
from cohesion_tests.coupling.dictionaries import FILE
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.test_case import CoupledTestCase

G = 9.81
FLUX = "{ type fixedFluxPressure; value uniform 0; }"
STILL = "{ type fixedValue; value uniform (0 0 0); }"


def write_patches(case, name, patches):
    """Gives a field of the case other patches."""
    path = case.folder / "0.orig" / name
    text = path.read_text().split("boundaryField")[0]
    path.write_text(text + "boundaryField\n{\n" + "".join(f"    {p} {row}\n" for p, row in patches.items()) + "}\n")


def close(case, flux=FLUX, velocity=STILL, **others):
    """Walls at all patches but `others`, for which each field has the same row."""
    patches = ("bottom", "top", "sides")
    for name, row in (("U", velocity), ("p", flux), ("voidFraction", "{ type zeroGradient; }")):
        write_patches(case, name, {**dict.fromkeys(patches, row), **others})
    append(case, "system/fvSolution", "PIMPLE { pRefCell 0; pRefValue 0; }")


class ClosedVessels(CoupledTestCase):
    def box(self, name, liquid, flux=FLUX, ranks=1, periodic=False):
        """3500 spheres that fall and collide in the closed column, 20 steps; periodic: along x, a duct."""
        case = self.column(name)
        use_script(case, "swarm")
        ends = {}
        if periodic:
            make_periodic(case)
            ends = dict.fromkeys(("left", "right"), "{ type cyclic; }")
            edit(case, script_file("swarm"), "boundary     f f f", "boundary     p f f")
            edit(case, script_file("swarm"), "fix walls_x", "#")
        close(case, flux, **ends)
        append(case, COUPLING, "voidFraction sphereOverlap; minVoidFraction 0.1;")
        if liquid:
            append(case, "constant/transportProperties", "rho 1000; nu 1e-6;")
            edit(case, script_file("swarm"), "density 1000", "density 2000")
        append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-13; } }')
        append(case, "system/controlDict", "endTime 2e-3; writeInterval 2e-3; writePrecision 17;")
        case.mesh()
        log = case.solve(ranks=ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        return case, log

    def test_boxes(self):
        self.flow_is_that_of_zero_gradient((True, "water"), (False, "air"))

    def test_duct_of_spheres(self):
        self.flow_is_that_of_zero_gradient((True, "water-duct"), (False, "air-duct"), periodic=True)

    def flow_is_that_of_zero_gradient(self, *fluids, periodic=False):
        for liquid, name in fluids:
            case, _ = self.box(name, liquid, periodic=periodic)
            reference, _ = self.box(f"{name}-zero-gradient", liquid, "{ type zeroGradient; }", periodic=periodic)
            found = {"U": case}
            # On two ranks a closed vessel and a duct: equations, and no fluids, are shared among them.
            if liquid != periodic:
                found["U on two ranks"], _ = self.box(f"{name}-shared", liquid, ranks=2, periodic=periodic)
            u = field(reference, "0.002", "U")
            # Solvers leave 1e-13 of the pressure's residual in a step; swarms of 20 steps do not make chaos of that.
            self.expect_true(f"{name}: it moves", np.abs(u).max() > 1e-3)
            for what, case in found.items():
                self.expect_below(f"{name}: {what} against zeroGradient, over the largest",
                                  np.abs(field(case, "0.002", "U") - u).max() / np.abs(u).max(), 1e-8)

    def test_fluid_at_rest(self):
        """One sphere of 0.1 mm at rest in it does next to nothing: p is that of the fluid's weight, 1e-9 of it being that
        of the sphere, and the velocities are what the solver leaves."""
        case = self.column("rest")
        close(case)
        append(case, "constant/transportProperties", "rho 1000; nu 1e-6;")
        append(case, COUPLING, "dragFactor 1e-6;")
        append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-13; } }')
        append(case, "system/controlDict", "endTime 1e-3; writeInterval 1e-3; writePrecision 17;")
        case.mesh()
        case.solve()
        p = field(case, "0.001", "p").reshape(10, 9)
        self.expect_near("p at the top less that at the bottom [m2/s2]", (p[-1] - p[0]).mean(), -G * 0.18, 1e-6 * G)
        self.expect_below("largest velocity [m/s]", np.abs(field(case, "0.001", "U")).max(), 1e-6 * G * 1e-3)

    def duct(self, name, source):
        """Between plates 0.2 m apart, periodic along x, slip at the others: velocities of the rows of cells."""
        nu, dt, steps = 0.1, 0.02, 100
        case = self.column(name)
        make_periodic(case)
        cyclic = "{ type cyclic; }"
        close(case, left=cyclic, right=cyclic)
        edit(case, "0.orig/U", f"sides {STILL}", "sides { type slip; }")
        (case.folder / "places").write_text("create_atoms 1 single 0.031 0.029 0.101\n")
        append(case, COUPLING, 'dragFactor 1e-15; lammpsCoeffs { script "$FOAM_CASE/few.lmp"; variables {'
                               f' places places; period p; diameter 1e-3; dt {dt}; }} }}')
        append(case, "constant/transportProperties", f"rho 1; nu {nu};")
        append(case, "system/controlDict",
               f"deltaT {dt}; endTime {dt * steps}; writeControl timeStep; writeInterval {steps}; writePrecision 17;")
        append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-13; } }')
        (case.folder / "constant/fvOptions").write_text(FILE.format("dictionary", "fvOptions") + source)
        case.mesh()
        case.solve()
        return field(case, f"{dt * steps:g}", "U").reshape(10, 9, 3)[:, :, 0].mean(axis=1), nu

    @staticmethod
    def profile():
        """Over the force and the viscosity: z (H - z)/2 of the plates, and h^2/8 more in cells of height h, whose wall
        shear is that from half a cell."""
        h = 0.02
        z = (np.arange(10) + 0.5) * h
        return z * (0.2 - z) / 2 + h**2 / 8

    def test_driven_duct(self):
        # 100 steps that each leave 1/(1 + pi^2 nu dt/H^2) = 0.67 of what is not steady: nothing.
        force = 2.0
        found, nu = self.duct("source", "push { type vectorSemiImplicitSource; selectionMode all; volumeMode specific;"
                                        f" injectionRateSuSp {{ U (({force} 0 0) 0); }} }}")
        right = force / nu * self.profile()
        self.expect_below("profile of a source, largest error over the largest velocity",
                          np.abs(found - right).max() / right.max(), 1e-6)
        mean = 0.3
        found, _ = self.duct("mean", "push { type meanVelocityForce; selectionMode all; fields (U);"
                                     f" Ubar ({mean} 0 0); relaxation 0.02; }}")
        right = mean * self.profile() / self.profile().mean()
        self.expect_below("profile of meanVelocityForce, largest error over the largest velocity",
                          np.abs(found - right).max() / right.max(), 1e-3)


# Ghia, Ghia and Shin (1982), tables I and II, Re 100: places and velocities along the lid on the vertical through the
# middle, and across it on the horizontal one
ALONG = np.array([(0.0547, -0.03717), (0.0703, -0.04775), (0.1016, -0.06434), (0.1719, -0.10150), (0.2813, -0.15662),
                  (0.4531, -0.21090), (0.5, -0.20581), (0.6172, -0.13641), (0.7344, 0.00332), (0.8516, 0.23151),
                  (0.9531, 0.68717)]).T
ACROSS = np.array([(0.0625, 0.09233), (0.0938, 0.12317), (0.1563, 0.16077), (0.2266, 0.17507), (0.2344, 0.17527),
                   (0.5, 0.05454), (0.8047, -0.24533), (0.8594, -0.22445), (0.9063, -0.16914), (0.9453, -0.10313)]).T


class Cavity(CoupledTestCase):
    def velocities(self, name, cells, spacing, drag):
        """At Ghia's places, in the steady flow."""
        dt, end = 0.05, 15
        case = self.column(name)
        block = case.folder / "system/blockMeshDict"
        block.write_text(block.read_text().split("// A column")[0] + f"""
scale 1;
vertices ((0 0 0) (1 0 0) (1 0.1 0) (0 0.1 0) (0 0 1) (1 0 1) (1 0.1 1) (0 0.1 1));
blocks ( hex (0 1 2 3 4 5 6 7) ({cells} 1 {cells}) simpleGrading (1 1 1) );
boundary
(
    bottom {{ type wall; faces ((0 3 2 1)); }}
    top    {{ type wall; faces ((4 5 6 7)); }}
    sides  {{ type wall; faces ((0 4 7 3) (1 2 6 5)); }}
    planes {{ type empty; faces ((0 1 5 4) (3 7 6 2)); }}
);
""")
        close(case, planes="{ type empty; }")
        edit(case, "0.orig/U", f"top {STILL}", "top { type fixedValue; value uniform (1 0 0); }")
        append(case, COUPLING, f'drag wenYu; dragFactor {drag}; lammpsCoeffs {{ script "$FOAM_CASE/cavity.lmp";'
                               f' variables {{ spacing {spacing}; dt {dt / 5}; }} }}')
        append(case, "constant/g", "value (0 0 0);")
        append(case, "constant/transportProperties", "rho 1; nu 0.01;")
        append(case, "system/fvSchemes", "divSchemes { div(voidFractionPhi,U) Gauss linear; }")
        append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-8; } "U.*" { tolerance 1e-8; } }')
        append(case, "system/controlDict",
               f"deltaT {dt}; endTime {end}; writeControl runTime; writeInterval {end};")
        case.mesh()
        case.solve()
        u = field(case, str(end), "U").reshape(cells, cells, 3)
        middle = u[:, cells // 2 - 1:cells // 2 + 1, 0].mean(axis=1)
        across = u[cells // 2 - 1:cells // 2 + 1, :, 2].mean(axis=0)
        places = np.concatenate([[0], (np.arange(cells) + 0.5) / cells, [1]])
        return np.concatenate([np.interp(ALONG[0], places, [0, *middle, 1]),
                               np.interp(ACROSS[0], places, [0, *across, 0])])

    def test_lid(self):
        ghia = np.concatenate([ALONG[1], ACROSS[1]])
        coarse = self.velocities("coarse", 16, 1, 1e-15)
        fine = self.velocities("fine", 32, 1, 1e-15)
        # Of second order, so that a third of what halving the cells changes is left; what interpolates between cells
        # and Ghia's own error of 1e-3 beside it.
        limit = np.abs(fine - coarse).max() / 2 + 1e-3
        self.expect_below("a third of the change from 16 to 32 cells, and Ghia's digits", limit, 0.02)
        self.expect_below("largest error of 32 cells against Ghia, over the lid's velocity",
                          np.abs(fine - ghia).max(), limit)
        # 256 spheres that follow are 1.3e-3 of the volume, of the fluid's density: they change the velocities by a
        # few times that at most.
        followed = self.velocities("spheres", 32, 0.0625, 1)
        self.expect_below("the same with spheres that follow", np.abs(followed - ghia).max(), limit + 0.01)
        self.expect_true("the spheres are felt", np.abs(followed - fine).max() > 0)


if __name__ == "__main__":
    unittest.main()
