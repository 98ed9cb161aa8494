# SPDX-License-Identifier: BSD-3-Clause
"""Cases that run and are hardly meant: each is warned of once, with the value and what would be right, and the like that
is meant is not."""

import unittest

from cohesion_tests.coupling.cases import COUPLING, append, edit, make_periodic
from cohesion_tests.coupling.dictionaries import FIELD
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.refusals import assert_says

DIAMETER, CELL = 16e-3, 20e-3  # [m]
VOID = 1 - 3.141592653589793 / 6 * (DIAMETER / CELL) ** 3
BLOCKS = "system/blockMeshDict"
INLET = "type superficialVelocity; superficialVelocity (0 0 0);"


class CaseWarnings(CoupledTestCase):
    def spheres(self, name, rows=(0,), inlet=INLET, settings="", control="endTime 2e-4; writeInterval 2e-4;",
                diameter=DIAMETER, **files):
        """The log of the column with a sphere held in the middle of each cell of some rows. `files`: more start fields."""
        case = self.column(name)
        (case.folder / "places").write_text("".join(
            f"create_atoms 1 single {(i + 0.5) * CELL} {(j + 0.5) * CELL} {(k + 0.5) * CELL}\n"
            for i in range(3) for j in range(3) for k in rows))
        append(case, COUPLING, 'lammpsCoeffs { script "$FOAM_CASE/few.lmp"; variables { places places; period f;'
                               f' diameter {diameter}; }} }} {settings}')
        append(case, "system/controlDict", control)
        edit(case, "0.orig/U", INLET, inlet)
        for file, text in files.items():
            (case.folder / "0.orig" / file).write_text(text)
        case.mesh()
        return case.solve()

    def warned(self, what, log, *parts):
        with self.subTest(what):
            assert_says(self, log, *parts)
            self.assertEqual(log.count(parts[0]), 1, parts[0])

    def quiet(self, what, log, *parts):
        for part in parts:
            self.expect_equal(f"{what}: warnings", log.count(part), 0)

    def test_smoothing_wider_than_the_bed(self):
        """Two layers of spheres 20 mm apart: as high as an even layer of that variance, with that of the spheres,
        sqrt(20^2 12/4 + 16^2) = 38.16 mm."""
        log = self.spheres("wide", rows=(0, 1), settings="smoothingWidth 0.15;")
        self.warned("four heights", log, "smoothingWidth = 0.15 m", "the bed is about 0.038157", "most of its resistance",
                    "at most 0.00190788 m", "couplingProperties")
        log = self.spheres("half", rows=(0, 1), settings="smoothingWidth 0.01;")
        self.warned("a quarter", log, "smoothingWidth = 0.01 m", "a share of 0.26207")
        quiet = "smoothingWidth ="
        self.quiet("a twentieth", self.spheres("narrow", rows=(0, 1), settings="smoothingWidth 1.9e-3;"), quiet)
        self.quiet("no surface", self.spheres("full", rows=range(10), settings="smoothingWidth 0.05;"), quiet)

    def test_suspension_in_small_cells(self):
        """Ten layers of nine spheres, 3 % of the volume, in cells of 2.5 diameters; in the mean of the squares of their
        heights they are as high as sqrt(10^2 - 1 + 0.4^2) cells."""
        said = "the particles begin as a suspension"
        d = 0.4 * CELL
        height = CELL * (99 + 0.4**2)**0.5
        share = 90 * 3.141592653589793 / 6 * d**3 / (9 * CELL**2 * height)
        log = self.spheres("suspension", rows=range(10), diameter=d)
        self.warned("in 2.5 diameters", log, said, f"{share:.6g} of the layer of {height:.6g} m", "have 2.5 particle diameters",
                    "cells of six diameters, 0.048 m", "smoothingWidth 0.024;")
        smoothed = self.spheres("smoothed", rows=range(10), diameter=d, settings="smoothingWidth 0.024;")
        self.quiet("smoothed", smoothed, said)
        self.quiet("hardly any solid", self.spheres("thin", rows=range(10), diameter=CELL / 6), said)
        self.quiet("a bed", self.spheres("bed", rows=range(10)), said)
        self.quiet("a few", self.spheres("single", rows=(5,), diameter=d), said)

    def test_bed_at_the_narrow_end_of_a_vessel(self):
        """Four layers of 16 spheres of 4 mm, 4.5 mm apart, fill a quarter of the lowest 18 mm of a vessel that widens
        from 20 mm to 60 mm; of as much of its mean cross-section they would fill 7 %."""
        pitch, first = 4.5e-3, 23.25e-3
        places = "".join(f"create_atoms 1 single {first + i * pitch} {first + j * pitch} {(k + 0.5) * pitch}\n"
                         for i in range(4) for j in range(4) for k in range(4))
        log = self.edited("narrow-end", (BLOCKS, "(0 0 0) (60 0 0) (60 60 0) (0 60 0)",
                                         "(20 20 0) (40 20 0) (40 40 0) (20 40 0)"), ("places", "", places),
                          (COUPLING, "dt      1e-5;", "dt 1e-5; places places; period f; diameter 4e-3;"),
                          (COUPLING, "particles.lmp", "few.lmp"))
        self.quiet("a bed", log, "the particles begin as a suspension")

    def test_velocity_in_the_plane_of_its_patch(self):
        said = "lies in the plane of the patch"
        for name, inlet in (("superficial", "type superficialVelocity; superficialVelocity (0.3 0 0);"),
                            ("fixed", "type fixedValue; value uniform (0.3 0 0);")):
            log = self.spheres(name, rows=(5,), inlet=inlet)
            self.warned(name, log, said, "patch bottom: the velocity in the file U, (0.3 0 0) m/s",
                        "a component along (0 0 1)", "one of type wall")
            self.expect_true(f"{name}: before the particle script", log.index(said) < log.index("Particle engine lammps"))
        self.quiet("inclined", self.spheres("inclined", rows=(5,), inlet="type fixedValue; value uniform (0.3 0 0.01);"),
                   said)
        self.quiet("none", self.spheres("none", rows=(5,)), said)

    def test_velocity_between_the_particles(self):
        said = "m/s between the particles"
        given = "type fixedValue; value uniform (0 0 0.5);"
        log = self.spheres("between", inlet=given)
        # Six digits are printed.
        self.warned("under a bed", log, said, "patch bottom: gas enters with the velocity (0 0 0.5)",
                    f"the void fraction there is {VOID:.6g}", f"its superficial velocity is (0 0 {0.5 * VOID:.6g}) m/s",
                    "'type superficialVelocity; superficialVelocity (0 0 0.5);'")
        self.expect_true("before the first step", log.index(said) < log.index("\nTime = "))
        self.quiet("no particles at it", self.spheres("above", rows=(3,), inlet=given), said)
        self.quiet("superficial", self.spheres("meant", inlet=given.replace("fixedValue; value uniform",
                                                                            "superficialVelocity; superficialVelocity")),
                   said)

    def test_fields_that_nothing_reads(self):
        said = "nothing reads the fields"
        field = FIELD.format("volScalarField", "T", "[0 0 0 1 0 0 0]", "uniform 300",
                             "".join(f"    {p} {{ type zeroGradient; }}\n" for p in ("bottom", "top", "sides")))
        log = self.spheres("temperature", T=field)
        self.warned("a temperature", log, said, f"{said} T in ", "one temperature")
        self.expect_true("before the particle script", log.index(said) < log.index("Particle engine lammps"))
        self.quiet("none", self.spheres("no-temperature"), said)
        averaged = self.spheres("read", T=field, control="endTime 2e-4; writeInterval 2e-4; functions { carried {"
                                " type scalarTransport; libs (solverFunctionObjects); field T; enabled false; } }")
        self.quiet("one that a function object reads", averaged, said)

    def test_gas_that_crosses_many_cells(self):
        """7 m/s in steps of 20 ms through cells of 20 mm, beside spheres that hardly resist."""
        said = "the Courant number of the gas is"
        fast = {"rows": (9,), "settings": "dragFactor 1e-9;", "inlet": INLET.replace("(0 0 0)", "(0 0 7)")}
        log = self.spheres("fast", control="deltaT 0.02; endTime 0.08; writeInterval 0.08;", **fast)
        self.warned("seven cells", log, said, "adjustTimeStep yes; maxCo 1;", "controlDict")
        log = self.spheres("adjusted", control="deltaT 2e-3; endTime 8e-3; writeInterval 8e-3; adjustTimeStep yes;", **fast)
        self.quiet("adjusted", log, said)
        log = self.spheres("slow", control="deltaT 2e-3; endTime 8e-3; writeInterval 8e-3;", **fast)
        self.quiet("0.7 cells", log, said)

    def test_growth_in_a_fixed_bed(self):
        """The gas step is 315 times m/b with the factor 1e18, a third of it with 1e15."""
        said = "in a fixed bed its velocity would grow by a factor of"
        log = self.spheres("free", settings="response free; dragFactor 1e18;")
        self.warned("response free", log, said, "'response held;'", "couplingProperties")
        self.quiet("response held", self.spheres("explicit", settings="response held; dragFactor 1e18;"), said)
        self.quiet("short steps", self.spheres("short", settings="response free; dragFactor 1e15;"), said)

    def edited(self, name, *edits, periodic=False, control="endTime 1e-4;"):
        """The log of a step of the column with texts of its files replaced: (file, old, new)."""
        case = self.column(name)
        append(case, "system/controlDict", control)
        if periodic:
            make_periodic(case)
        for file, old, new in edits:
            if old:
                edit(case, file, old, new)
            else:
                (case.folder / file).write_text(new)
        case.mesh()
        return case.solve()

    def test_particles_without_contacts(self):
        said = "particles do not touch, and fall through each other"
        contacts = ("particles.lmp", "pair_style   gran/hooke/history 100 NULL 0 NULL 0 0\npair_coeff   * *\n", "")
        log = self.edited("contactless", contacts)
        self.warned("no pair style", log, said, "particles.lmp has no pair_style", "for particles that never meet, write 'pair_style none'",
                    "couplingProperties")
        self.expect_true("before the particle script", log.index(said) < log.index("Particle engine lammps"))
        self.quiet("a pair style", self.edited("contacts"), said)
        none = self.edited("none-meant", (*contacts[:2], "pair_style none\ncomm_modify cutoff 1e-3\n"))
        self.quiet("none, as the script says", none, said)
        included = self.edited("included", (*contacts[:2], "include contacts.lmp\n"), ("contacts.lmp", "", contacts[1]))
        self.quiet("in a file that is included", included, said)

    def test_variables_that_the_script_does_not_use(self):
        said = "does not use the variable"
        log = self.edited("unused", (COUPLING, "dt      1e-5;", "dt 1e-5; plugins none;"))
        self.warned("one", log, said, "'plugins' (the nearest that it uses is 'plugin')", "couplingProperties")
        self.expect_true("before the particle script", log.index(said) < log.index("Particle engine lammps"))
        self.quiet("none", self.edited("used"), said)
        used = self.edited("condition", (COUPLING, "dt      1e-5;", "dt 1e-5; A 0; extra no;"),
                           ("particles.lmp", "units ", 'if "$A > 0" then "print ${extra}"\nunits '))
        self.quiet("in a condition and in quotes", used, said)
        shared = self.edited("shared", (COUPLING, "dt      1e-5;", '#include "shared"'),
                             ("constant/shared", "", "dt 1e-5; width 0.06;"))
        self.quiet("in a file that is included", shared, said)

    def test_periodic_box_or_mesh(self):
        said = "in direction x the box of the particle script is"
        box = ("particles.lmp", "boundary     f f f", "boundary     p f f")
        self.warned("the box", self.edited("box", box), f"{said} periodic, and the mesh is not",
                    "Take 'f' for x in the command boundary", "or cyclic patches")
        self.warned("the mesh", self.edited("cyclic", periodic=True), f"{said} not periodic, and the mesh is periodic",
                    "Take 'p' for x in the command boundary", "couplingProperties")
        self.quiet("both", self.edited("both", box, periodic=True), said)
        self.quiet("none", self.edited("closed"), said)

    def test_cross_section_that_changes(self):
        """The top of the column in squares of another side [mm]: the mean cross-section is (60^2 + 60 side + side^2)/3."""
        def observed(name, side, kind):
            top = (BLOCKS, "(0 0 200) (60 0 200) (60 60 200) (0 60 200)",
                   f"(0 0 200) ({side} 0 200) ({side} {side} 200) (0 {side} 200)")
            return self.edited(name, top, control=f"endTime 1e-4; functions {{ observed {{ {kind}"
                               " libs (cohesionFunctionObjects); writeControl timeStep; } }")

        said = "observed: the cross-section of the mesh"
        drop, height = "type bedPressureDrop;", "type bedHeight; layers 10;"
        self.warned("a drop, 3 %", observed("drop", 62, drop), f"{said} varies along direction (0 0 1)", "0.003844 m2",
                    "the mean cross-section, 0.00372133 m2", "controlDict")
        self.quiet("a drop, in a column", observed("drop-column", 60, drop), said)
        self.warned("a height, 10 %", observed("cone", 66, height), f"{said} changes along direction (0 0 1)",
                    "0.003972 m2", "use 'surface'", "the lowest point of the mesh, at 0 m", "controlDict")
        self.quiet("a height, 3 %", observed("height", 62, height), said)

    def test_entries_that_nothing_reads(self):
        observed = "functions {{ observed {{ libs (cohesionFunctionObjects); {} writeControl timeStep; }} }}"
        unknown = "unknown entry"
        functions = {
            "limitt": ("limit", "type bedHeight; layers 10; limitt 0.5;"),
            "inlet": ("inlets", "type bedPressureDrop; inlet (bottom);"),
            "directions": ("direction", "type mixingIndex; cells (3 3 10); directions (0 0 1);"),
            "intervals": ("interval", "type particleMovement; interval 1e-4; intervals 1;"),
            "writeIntervall": ("writeInterval", "type forceBudget; writeIntervall 3;"),
            "timestart": ("timeStart", "type particleFields; timestart 3;"),
        }
        for entry, (right, text) in functions.items():
            log = self.edited(f"function-{entry}", control="endTime 1e-4; " + observed.format(text))
            self.warned(entry, log, f"unknown entry '{entry}' (the nearest known one is '{right}'): nothing reads it",
                        "observed")
        edits = {
            "shar": ("share", "0.orig/U", "superficialVelocity (0 0 0);", "superficialVelocity (0 0 0); shar 0.5;"),
            "densty": ("density", "constant/transportProperties", "rho  ", "densty idealGas; rho  "),
            "nCorrector": ("nCorrectors", "system/fvSolution", "nCorrectors ", "nCorrector 3; nCorrectors "),
            "adjustTimestep": ("adjustTimeStep", "system/controlDict", "deltaT ", "adjustTimestep yes; deltaT "),
        }
        for entry, (right, *what) in edits.items():
            log = self.edited(f"entry-{entry}", what)
            self.warned(entry, log, f"unknown entry '{entry}' (the nearest known one is '{right}')")
            self.expect_true(f"{entry}: before the particle script", log.index(unknown) < log.index("Particle engine"))
        known = "superficialVelocity sine; frequency 1; amplitude 0; scale (0 0 0); level (0 0 0); share 1;"
        log = self.edited("known", ("0.orig/U", "superficialVelocity (0 0 0);", known), control="endTime 1e-4; maxDi 1; "
                          + observed.format("type bedHeight; layers 10; limit 0.5; timeStart 0; log no; enabled yes;"))
        self.quiet("all that is known", log, unknown)


if __name__ == "__main__":
    unittest.main()
