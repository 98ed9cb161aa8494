# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-translate: numbers of contacts against formulas written out again, warnings, and errors with their line."""
import csv
import itertools
import math
import re
import tempfile
import unittest
from pathlib import Path
from statistics import NormalDist

from cohesion_tests import SOURCE
from cohesion_tests.csv_program import CsvProgram

program = CsvProgram("COHESION_TRANSLATE")
#: Grains of 1 mm on a plate, both of E = 2e7 Pa, nu = 0.22.
SCRIPT = """# own case
units si
variable R index 5e-4
fix E all property/global youngsModulus peratomtype 2e7 2e7
fix nu all property/global poissonsRatio peratomtype 0.22 0.22
fix e all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
fix k all property/global cohesionEnergyDensity peratomtypepair 2 2e5 1e5 &
    1e5 0
pair_style gran model hertz tangential history cohesion sjkr  # of pairs
fix plate all wall/gran model hertz tangential history cohesion sjkr primitive type 2 zplane 0
fix p1 all particletemplate/sphere 1 atom_type 1 density constant 2500 radius constant ${R}
fix gravity all gravity 9.81 vector 0 0 -1
timestep 1e-6
"""
RADIUS, DENSITY, MODULUS, GRAVITY = 5e-4, 2500, 2e7 / (2 * (1 - 0.22**2)), 9.81
MASS = DENSITY * 4 / 3 * math.pi * RADIUS**3


def sjkr_force(density, reduced, modulus=MODULUS):
    return 2 / 3 * math.pi**3 * reduced**2 * density**3 / modulus**2


def hertz_time(mass, reduced, speed):
    """Johnson, Contact mechanics, eq. 11.24."""
    deepest = (15 * mass * speed**2 / (16 * MODULUS * math.sqrt(reduced)))**0.4
    return 2.94327 * deepest / speed, deepest


class Translated(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def call(self, script, *words):
        (self.folder / "in.case").write_text(script)
        return program.call(self.folder / "in.case", *words)

    def contacts(self, script, *words):
        """{contact: {name: (smallest, median)}}, warnings."""
        code, output, error = self.call(script, "--csv", *words)
        self.assertEqual(code, 0, error)
        found = {}
        for row in csv.DictReader(output.splitlines()):
            found.setdefault(row["contact"], {})[row["name"]] = float(row["smallest"]), float(row["median"])
        return found, error

    def near(self, value, expected, within=1e-5):
        self.assertAlmostEqual(value / expected, 1, delta=within)

    def changed(self, *pairs):
        script = SCRIPT
        for old, new in pairs:
            self.assertIn(old, script)
            script = script.replace(old, new)
        return script


class Numbers(Translated):
    def test_spheres_and_plate(self):
        found, error = self.contacts(SCRIPT)
        self.assertEqual(list(found), ["1-1", "1-plate"])
        for name, k, reduced, mass in (("1-1", 2e5, RADIUS / 2, MASS / 2), ("1-plate", 1e5, RADIUS, MASS)):
            force, (time, deepest) = sjkr_force(k, reduced), hertz_time(mass, reduced, 1)
            for size in (0, 1):
                of = {quantity: values[size] for quantity, values in found[name].items()}
                self.near(of["strength"], k)
                self.near(of["pull_off"], force)
                self.near(of["bond_number"], force / (MASS * GRAVITY))
                self.near(of["contact_time"], time)
                self.near(of["steps_per_contact"], time / 1e-6)
                self.near(of["overlap"], deepest / (2 * RADIUS))
        self.assertEqual(error, "")

    def test_sjkr2_doubles_the_area_between_spheres_only(self):
        one, _ = self.contacts(SCRIPT)
        two, _ = self.contacts(SCRIPT.replace("sjkr", "sjkr2"))
        self.near(two["1-1"]["pull_off"][0], 8 * one["1-1"]["pull_off"][0])
        self.near(two["1-plate"]["pull_off"][0], one["1-plate"]["pull_off"][0])

    def test_escape_velocity_scales_with_the_well(self):
        """The well is b x^2/10 with x = (b/c)^2: five powers of k in the energy."""
        one, _ = self.contacts(SCRIPT)
        two, _ = self.contacts(self.changed(("2 2e5", "2 1e5")))
        self.near(one["1-1"]["escape_velocity"][0] / two["1-1"]["escape_velocity"][0], 2**2.5, 1e-4)

    def test_unlike_materials(self):
        script = self.changed(("peratomtype 2e7 2e7", "peratomtype 2e7 4e7"), ("0.22 0.22", "0.22 0.3"))
        found, _ = self.contacts(script)
        modulus = 1 / ((1 - 0.22**2) / 2e7 + (1 - 0.3**2) / 4e7)
        self.near(found["1-plate"]["pull_off"][0], sjkr_force(1e5, RADIUS, modulus))

    def test_smallest_and_median_by_mass(self):
        template = "all particletemplate/sphere 1 atom_type 1 density constant"
        script = SCRIPT + f"""fix p2 {template} 2500 radius uniform 1e-3 2e-3
fix p3 {template} 1000 radius gaussian number 3e-3 5e-4
fix d all particledistribution/discrete 1 3 p1 0.3 p2 0.5 p3 0.2
"""
        found, _ = self.contacts(script)
        self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, RADIUS / 2))
        self.near(found["1-1"]["pull_off"][1], sjkr_force(2e5, 1.5e-3 / 2))
        # 2e-3 less three deviations.
        narrow, _ = self.contacts(self.changed(("constant ${R}", "gaussian number 2e-3 5e-4")))
        self.near(narrow["1-1"]["pull_off"][0], sjkr_force(2e5, 5e-4 / 2))
        by_number = script.replace("discrete 1 3", "discrete/numberbased 1 3")
        # p3, the heaviest, has 0.2 * 1000 * 3.25^3 = 6866 of 0.3 * 2500/8 + 0.5 * 2500 * 1.5^3 + 6866 = 11178;
        # its median is 3e-3 + 3 * 25e-8/3e-3.
        self.near(self.contacts(by_number)[0]["1-1"]["pull_off"][1], sjkr_force(2e5, 3.25e-3 / 2))

    def test_medians_by_mass_are_those_of_samples(self):
        """Numbers of quantiles, each weighted with its mass; gaussian: cut off at three deviations."""
        count = 20001
        quantiles = [(k + 0.5) / count for k in range(count)]
        normal = NormalDist(3e-3, 4e-4)
        low, high = normal.cdf(1.8e-3), normal.cdf(4.2e-3)
        for words, radii, within in (
                ("uniform number 1e-3 2e-3", [1e-3 * (1 + q) for q in quantiles], 1e-3),
                ("uniform mass 1e-3 2e-3", [1e-3 / math.sqrt(1 - 0.75 * q) for q in quantiles], 1e-3),
                ("uniform 1e-3 2e-3", [1e-3 / math.sqrt(1 - 0.75 * q) for q in quantiles], 1e-3),
                ("gaussian 3e-3 4e-4", [normal.inv_cdf(low + q * (high - low)) for q in quantiles], 0.01),
                ("gaussian number 3e-3 4e-4", [normal.inv_cdf(low + q * (high - low)) for q in quantiles], 0.01)):
            half = sum(r**3 for r in radii) / 2
            median = next(r for r, mass in zip(radii, itertools.accumulate(r**3 for r in radii)) if mass >= half)
            found, _ = self.contacts(self.changed(("constant ${R}", words)))
            self.near(found["1-1"]["pull_off"][1], sjkr_force(2e5, median / 2), 2 * within)
            self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, round(min(radii), 5) / 2))

    def test_speed_of_the_script(self):
        insertion = "fix i all insert/pack seed 1 distributiontemplate d vel constant 0 3 -4 region r\n"
        for script, words, speed in ((SCRIPT + insertion, (), 5), (SCRIPT + insertion, ("--speed", 0.1), 0.1)):
            found, _ = self.contacts(script, *words)
            self.near(found["1-1"]["contact_time"][0], hertz_time(MASS / 2, RADIUS / 2, speed)[0])

    def test_hamaker_and_jkr(self):
        hamaker = self.changed(("cohesionEnergyDensity", "hamakerConstant"), ("2 2e5 1e5", "2 1e-19 1e-19"),
                               ("    1e5 0", "    1e-19 0"), ("sjkr", "hamaker")) + (
            "fix c all property/global hamakerSurfaceCutoff scalar 4e-10\n"
            "fix o all property/global hamakerOuterCutoff scalar 1e-7\n")
        found, _ = self.contacts(hamaker)
        self.near(found["1-1"]["pull_off"][0], 1e-19 * RADIUS / 2 / (6 * 4e-10**2))
        jkr = self.changed(("cohesionEnergyDensity", "surfaceEnergy"), ("2 2e5 1e5", "2 0.05 0.02"),
                           ("    1e5 0", "    0.02 0"), ("sjkr", "jkr"))
        found, _ = self.contacts(jkr)
        self.near(found["1-1"]["pull_off"][0], 3 * math.pi * 0.05 * RADIUS / 2)
        self.near(found["1-plate"]["pull_off"][0], 3 * math.pi * 0.02 * RADIUS)

    def test_linear_springs(self):
        stiff = self.changed(("model hertz", "model hooke/stiffness")) + (
            "fix kn all property/global kn peratomtypepair 2 500 500 500 500\n"
            "fix gn all property/global gamman peratomtypepair 2 10 10 10 10\n")
        found, error = self.contacts(stiff)
        self.near(found["1-1"]["contact_time"][0], math.pi * math.sqrt(MASS / 2 / 500))
        self.assertEqual(found["1-1"]["pull_off"][0], 0)
        self.assertEqual(found["1-1"]["escape_velocity"][0], 0)
        self.assertIn("no pull-off force with model hooke/stiffness", error)
        # 2 pi R* k = 314 N/m is above the spring
        found, error = self.contacts(stiff.replace("2 500", "2 300"))
        self.assertEqual(found["1-1"]["pull_off"][0], math.inf)
        self.assertEqual(found["1-1"]["escape_velocity"][0], math.inf)
        self.assertIn("spheres collapse", error)
        # The net spring 500 - 100 pi N/m is critically damped at gamman = 2 sqrt(net/m), m = MASS/2.
        critical = 2 * math.sqrt((500 - 100 * math.pi) / (MASS / 2))
        for gamman, escape, warning in ((0.99 * critical, 0, "no pull-off force"),
                                        (1.01 * critical, math.inf, "contacts never separate")):
            found, error = self.contacts(stiff.replace("gamman peratomtypepair 2 10",
                                                       f"gamman peratomtypepair 2 {gamman!r}"))
            self.assertEqual(found["1-1"]["pull_off"][0], 0)
            self.assertEqual(found["1-1"]["escape_velocity"][0], escape)
            self.assertIn(f"in.case:{7 if escape else 9}: types 1 and 1: cohesion sjkr", error)
            self.assertIn(warning, error)
        found, _ = self.contacts(self.changed(("model hertz", "model hooke"))
                                 + "fix v all property/global characteristicVelocity scalar 2\n")
        stiffness = 16 / 15 * math.sqrt(RADIUS / 2) * MODULUS * (
            15 * MASS / 2 * 4 / (16 * math.sqrt(RADIUS / 2) * MODULUS))**0.2
        self.near(found["1-1"]["contact_time"][0], math.pi * math.sqrt(MASS / 2 / stiffness))

    def test_hertz_of_given_stiffness(self):
        """F = kn sqrt(R*) x^(3/2), of E* = 3/4 kn."""
        found, _ = self.contacts(self.changed(("model hertz", "model hertz/stiffness")) + (
            f"fix kn all property/global kn peratomtypepair 2 {' '.join([repr(4 / 3 * MODULUS)] * 4)}\n"
            "fix gn all property/global gamman peratomtypepair 2 10 10 10 10\n"))
        self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, RADIUS / 2))


class Page(Translated):
    PAGE = (SOURCE / "docs/tools/cohesion-translate.md").read_text()

    def test_its_example_is_what_the_program_prints(self):
        code, output, error = self.call(self.changed(("2 2e5 1e5", "2 0.05 0.05"), ("    1e5 0", "    0.05 0")))
        self.assertEqual(code, 0, error)
        block = re.search(r"```\n(types 1 and 1.*?)```", self.PAGE, re.S)[1]
        self.assertIn(block, re.sub(r" +\n", "\n", output))

    def test_its_options_are_those_of_the_program(self):
        option = r"--[a-z]+"
        table = self.PAGE.split("\n## Options\n")[1].split("\n## ")[0]
        rows = [line.split("|")[1] for line in table.splitlines() if line.startswith("|")]
        listed = {name for row in rows for name in re.findall(option, row)}
        code, output, _ = program.call("--help")
        self.assertEqual(code, 0)
        found = {name for line in output.splitlines() for name in re.findall(rf"^ +(?:-h,)?({option})", line)}
        self.assertEqual(listed, found)


class Script(Translated):
    def test_meshes_variables_and_included_files(self):
        (self.folder / "plate").write_text(
            "fix cad all mesh/surface file x.stl type 2\n"
            "fix w all wall/gran model hertz tangential history cohesion sjkr mesh n_meshes 1 meshes cad\n")
        script = self.changed(
            ("fix plate all wall/gran model hertz tangential history cohesion sjkr primitive type 2 zplane 0",
             "variable file string plate\ninclude ${file}"),
            ("constant ${R}", "constant ${r}"),
            ("variable R index 5e-4", "variable D index 1e-3\nvariable r equal v_D/2"))
        found, _ = self.contacts(script)
        self.assertEqual(list(found), ["1-1", "1-cad"])
        self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, RADIUS / 2))
        found, _ = self.contacts(script, "--var", "D", "2e-3")
        self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, RADIUS))

    def test_a_variable_may_have_several_words(self):
        given, _ = self.contacts(SCRIPT)
        model = "model hertz tangential history cohesion sjkr"
        script = self.changed(
            (f"pair_style gran {model}", "pair_style gran $m"), (f"wall/gran {model}", "wall/gran ${wallmodel}"),
            ("peratomtype 2e7 2e7", "peratomtype ${E}"), ("sphere 1 atom_type 1", "sphere ${seed_and_type}"),
            ("# own case", f"variable m index '{model}' other\nvariable wallmodel string \"{model}\"\n"
                           "variable E string '2e7 2e7'\nvariable seed_and_type string \"1 atom_type  1\""))
        found, error = self.contacts(script)
        self.assertEqual((found, error), (given, ""))
        # One word in quotes, in which no variable is replaced.
        script = self.changed(("${R}", "$n"), ("variable R", "variable n equal '2 * v_R - 5e-4'\nvariable R"))
        self.assertEqual(self.contacts(script)[0], given)
        code, _, error = self.call(script.replace("'2 * v_R", "'2 * ${R}"))
        self.assertNotEqual(code, 0)
        self.assertIn("the value of the variable 'n'", error)

    MESHES = ("fix cad all mesh/surface file x.stl type 2\nfix lid all mesh/surface/stress file y.stl type 2\n"
              "fix w all wall/gran model hertz tangential history cohesion sjkr mesh n_meshes {}\n")
    PLATE = "fix plate all wall/gran model hertz tangential history cohesion sjkr primitive type 2 zplane 0\n"

    def test_a_wall_that_is_defined_again_is_printed_once(self):
        again = "run 1\nunfix w\n" + self.MESHES.format("1 meshes cad").splitlines()[-1] + "\nrun 1\n"
        script = self.changed((self.PLATE, self.MESHES.format("2 meshes cad lid"))) + again
        code, output, error = self.call(script)
        self.assertEqual(code, 0, error)
        self.assertEqual([output.count(f"wall '{name}'") for name in ("cad", "lid")], [1, 1])
        self.assertNotIn("second", error)
        # Both lines are translated.
        self.assertEqual(self.call(script, "--write", "equal-force", self.folder / "out.case")[0], 0)
        text = (self.folder / "out.case").read_text()
        self.assertEqual((text.count("cohesion hamaker mesh"), text.count("sjkr mesh")), (2, 0))
        # A switch without effect on the numbers.
        code, output, _ = self.call(script.replace("1 meshes cad", "1 meshes cad tangential_reduce on"))
        self.assertEqual(output.count("wall 'cad'"), 1)

    def test_equal_contacts_are_printed_once(self):
        """Types 1 and 2 are alike, and so are the walls."""
        script = self.changed(
            ("2e7 2e7", "2e7 2e7 2e7"), ("0.22 0.22", "0.22 0.22 0.22"), ("2 0.9 0.9 0.9 0.9", "3" + 9 * " 0.9"),
            ("2 2e5 1e5 &\n    1e5 0", "3" + 9 * " 1e5"), ("primitive type 2", "primitive type 3"),
            ("timestep 1e-6", "timestep 1e-5"))
        script += self.PLATE.replace("plate", "lid").replace("type 2", "type 3")
        script += next(line for line in SCRIPT.splitlines() if "fix p1" in line).replace(
            "p1", "p2").replace("atom_type 1", "atom_type 2") + "\n"
        code, output, error = self.call(script)
        self.assertEqual(code, 0, error)
        self.assertEqual(output.count("Bond number"), 2)
        self.assertIn("\ntypes 1 and 1;\ntypes 1 and 2;\ntypes 2 and 2, model hertz, cohesion sjkr\n", output)
        self.assertIn("\n" + ";\n".join(f"type {i} and wall '{wall}' of type 3" for wall in ("plate", "lid")
                                       for i in (1, 2)) + ", model hertz", output)
        self.assertIn("in.case:8: types 1 and 1; types 1 and 2; types 2 and 2: 7.87 time steps per contact", error)
        found, _ = self.contacts(script)
        self.assertEqual(len(found), 7)

    def test_two_walls_of_meshes_are_warned_of(self):
        walls = self.MESHES.format("1 meshes cad")
        second = walls.splitlines()[-1].replace("fix w ", "fix v ").replace("meshes cad", "meshes lid") + "\n"
        _, error = self.contacts(self.changed((self.PLATE, walls + second)) + "run 1\n")
        self.assertEqual(error.count("in.case:13: LIGGGHTS stops at a second 'fix wall/gran ... mesh'"), 1)
        for between in ("unfix w\n", ""):
            script = self.changed((self.PLATE, walls + between + (second if between else "")))
            self.assertNotIn("second", self.contacts(script + "run 1\n")[1])
            self.assertNotIn("second", self.contacts(script.replace(walls, walls + self.PLATE) + "run 1\n")[1])

    def test_expressions(self):
        script = self.changed(("variable R index 5e-4",
                               "variable a equal 2^3*-1+9.5-(3-2)/2*2\nvariable R equal v_a*1e-3"))
        found, _ = self.contacts(script)  # 0.5
        self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, RADIUS / 2))

    def test_signs_and_powers_are_those_of_the_engine(self):
        """LIGGGHTS prints 4 for -2^2, 64 for 2^3^2 and 0.25 for 2^-2."""
        for expression, value in (("-2^2", 4), ("2^3^2", 64), ("2^-2", 0.25), ("8-2^2", 4)):
            script = self.changed(("variable R index 5e-4",
                                   f"variable a equal {expression}\nvariable R equal v_a*1e-4"))
            found, _ = self.contacts(script)
            self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, value * 1e-4 / 2))

    def test_variables_that_change(self):
        for lines, expected in (
                # An expression is evaluated where it is used.
                ("variable D string 1e-3\nvariable R equal v_D/2\nvariable D string 2e-3", 1e-3),
                ("variable R index 3e-3\nvariable R delete\nvariable R index 5e-4", 5e-4),
                ("variable n loop 12 pad\nvariable R string ${n}e-3", 1e-3),
                ("variable n loop 2 12\nvariable R string ${n}e-3", 2e-3)):
            found, _ = self.contacts(self.changed(("variable R index 5e-4", lines)))
            self.near(found["1-1"]["pull_off"][0], sjkr_force(2e5, expected / 2))
        code, _, error = self.call(self.changed(("variable R index 5e-4", "variable R index 5e-4\nvariable R delete")))
        self.assertNotEqual(code, 0)
        self.assertIn("in.case:12: the value of the variable 'R'", error)
        circle = self.changed(("variable R index 5e-4", "variable R equal v_S\nvariable S equal v_R"))
        code, _, error = self.call(circle)
        self.assertNotEqual(code, 0)
        self.assertIn("the value of the variable 'R'", error)
        # Leading zeros to the width of the last value.
        (self.folder / "part01").write_text("units si\n")
        self.contacts(self.changed(("units si", "variable n loop 12 pad\ninclude part${n}")))

    def test_sizes_of_set_and_of_the_command_line(self):
        template = next(line for line in SCRIPT.splitlines() if "particletemplate" in line)
        given, _ = self.contacts(SCRIPT)
        by_set, _ = self.contacts(self.changed((template, "set group all diameter 1e-3 density 2500")))
        by_word, _ = self.contacts(self.changed((template, "")), "--diameter", 1e-3, "--density", 2500)
        for other in (by_set, by_word):
            self.assertEqual(other.keys(), given.keys())
            self.near(other["1-1"]["bond_number"][0], given["1-1"]["bond_number"][0])


class Warnings(Translated):
    def warned(self, script, *parts, words=()):
        _, error = self.contacts(script, *words)
        for part in parts:
            self.assertIn(part, error)

    def test_surface_energy_in_place_of_energy_density(self):
        script = self.changed(("2 2e5 1e5", "2 0.05 0.05"), ("    1e5 0", "    0.05 0"))
        found, error = self.contacts(script)
        # sjkr_force(0.05, R*)/(m g): 1.1e-19
        self.near(found["1-1"]["bond_number"][0], 1.13881e-19, 1e-4)
        self.assertIn("in.case:7: types 1 and 1: cohesion sjkr has a Bond number of 1.14e-19", error)
        self.assertIn("0.05 J/m3 is in the range of surface energies in J/m2", error)
        # The density that is named has a Bond number of 1, to its three digits.
        named = error.split("use cohesionEnergyDensity ")[1].split()[0]
        found, _ = self.contacts(self.changed(("2 2e5 1e5", f"2 {named} 1e5")))
        self.near(found["1-1"]["bond_number"][0], 1, 0.02)

    def test_quantities_of_no_material(self):
        self.warned(self.changed(("density constant 2500", "density constant 2.5")), "in.case:11: density 2.5", "kg/m3")
        self.warned(self.changed(("index 5e-4", "index 0.5")), "in.case:11: radius 0.5 m")
        self.warned(self.changed(("peratomtype 2e7 2e7", "peratomtype 2e7 70")),
                    "in.case:4: youngsModulus 70 Pa of type 2")

    def test_cohesion_that_is_not_used_or_unlike(self):
        self.warned(self.changed(("cohesion sjkr", "")), "in.case:7: cohesionEnergyDensity is not used")
        self.warned(self.changed(("cohesion sjkr primitive", "primitive")), "in.case:10: wall 'plate' has cohesion off")

    def test_steps_and_overlaps(self):
        self.warned(self.changed(("timestep 1e-6", "timestep 1e-5")),
                    "in.case:9: types 1 and 1", "time steps per contact")
        self.warned(SCRIPT, "press grains by", words=("--speed", 1))

    BOX = "region box {}\ncreate_box 2 box\n"
    INSERTION = "fix i all insert/pack seed 1 distributiontemplate d vel constant 0 3 -4 region r\n"

    def exact_step(self, script, *words):
        """Speed of the fastest sphere, what it is, and the time step that is named."""
        _, error = self.contacts(script, *words)
        found = re.findall(r"time step 0.001 is longer than advised for the exact scheme \(types 1 and 1, spheres of up "
                           r"to (\S+) \[length/time\]: (.*)\): use a timestep of at most (\S+)", error)
        self.assertEqual(len(found), 1, error)
        return float(found[0][0]), found[0][1], float(found[0][2])

    def test_step_of_the_exact_scheme(self):
        script = self.changed(("cohesionEnergyDensity", "surfaceEnergy"), ("2 2e5 1e5", "2 1e-4 1e-4"),
                              ("    1e5 0", "    1e-4 0"), ("sjkr", "jkr"), ("timestep 1e-6", "timestep 1e-3"))
        block, cylinder = "block -1 1 0 3 0 0.2 units box", "cylinder x 0 0 0.1 -2 2 units box"
        fall = math.sqrt(2 * GRAVITY * 0.2)
        for text, words, speed, what in (
                (script, (), 3, "three times the assumed speed: specify --speed"),
                (script, ("--speed", 1), 3, "three times --speed"),
                (script, ("--speed", 0.1), 0.3, "three times --speed"),
                (script + self.BOX.format(block), (), fall, "fall through the box"),
                (script + self.BOX.format(block), ("--speed", 2), 6, "three times --speed"),
                (script + self.BOX.format(cylinder), (), fall, "fall through the box"),
                (script.replace("vector 0 0 -1", "vector 0 3 -4") + self.BOX.format(block), (),
                 math.sqrt(2 * GRAVITY * (0.6 * 3 + 0.8 * 0.2)), "fall through the box"),
                (script.replace("vector 0 0 -1", "chute 10") + self.BOX.format(block), (),
                 math.sqrt(2 * GRAVITY * math.hypot(2, 3, 0.2)), "fall through the box"),
                (script + self.INSERTION, (), 5, "insertion"),
                (script + self.INSERTION + self.BOX.format("block INF INF 0 1 0 $x"), (), 5, "insertion"),
                (script + self.INSERTION + self.BOX.format(block), (), math.hypot(5, fall),
                 "insertion and fall through the box")):
            found = self.exact_step(text, *words)
            self.near(found[0], speed, 5e-3)
            self.assertEqual(found[1], what)
            # Of an elastic enough contact without friction: a twentieth of the contact time.
            self.near(found[2], hertz_time(MASS / 2, RADIUS / 2, speed / 3)[0] / 20, 0.01)
            _, error = self.contacts(text.replace("timestep 1e-3", f"timestep {found[2]}"), *words)
            self.assertNotIn("time step", error)

    @staticmethod
    def steady_sliding(restitution, speed):
        """40/7 (K_t + 2 eta_t/dt) dt^2/m_t = 4 with m_t = 2 mu/7, at the largest overlap of an impact with `speed`
        (docs/theory/contact_steps.md); K_t = 8 G* a and eta_t = 2 sqrt(5/6) beta sqrt(K_t mu) as in LIGGGHTS."""
        mass, log = MASS / 2, math.log(restitution)
        radius_of_contact = math.sqrt(RADIUS / 2 * hertz_time(mass, RADIUS / 2, speed)[1])
        stiffness = 8 * 2e7 / (4 * (2 - 0.22) * (1 + 0.22)) * radius_of_contact
        damping = math.sqrt(5 / 6) * -log / math.hypot(log, math.pi) * math.sqrt(stiffness * mass) * 2
        return (math.sqrt(damping**2 + stiffness * mass / 5) - damping) / stiffness

    def test_friction_and_damping_shorten_the_step_of_the_exact_scheme(self):
        script = self.changed(("cohesionEnergyDensity", "surfaceEnergy"), ("2 2e5 1e5", "2 1e-4 1e-4"),
                              ("    1e5 0", "    1e-4 0"), ("sjkr", "jkr"), ("timestep 1e-6", "timestep 1e-3"),
                              ("2 0.9 0.9 0.9 0.9", "2 0.3 0.3 0.3 0.3"))
        friction = "fix mu all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
        step = self.exact_step(script)[2]
        self.near(step, hertz_time(MASS / 2, RADIUS / 2, 1)[0] / 20, 0.01)
        self.near(self.exact_step(script + friction)[2], self.steady_sliding(0.3, 3), 0.01)
        self.assertEqual(step, self.exact_step(script.replace("tangential history", "tangential off") + friction)[2])

    def test_scaled_attraction(self):
        self.warned(self.changed(("history cohesion sjkr  #", "history cohesion sjkr material_modulus on #")),
                    "in.case:9: 'material_modulus on' scales the attraction")

    def test_attraction_beyond_small_overlaps(self):
        self.warned(self.changed(("2 2e5", "2 2e6")), "strongest at an overlap of")


class Written(Translated):
    def written(self, script, *words):
        """The script that is written, and what the program printed as error."""
        target = self.folder / "out.case"
        code, _, error = self.call(script, *words[:1], *words[1:2], target, *words[2:])
        self.assertEqual(code, 0, error)
        return target.read_text(), error

    def test_equal_force(self):
        text, _ = self.written(self.changed(("${R}", "5e-4")), "--write", "equal-force")
        self.assertNotIn("sjkr primitive", text)
        # A = 6 F H_cut^2/R* by hand: 6 * 9.35917e-5 * 1.6e-19/2.5e-4
        self.assertIn("fix k all property/global hamakerConstant peratomtypepair 2 3.5939204e-19 8.984801e-20 "
                      "8.984801e-20 0\n", text)
        found, _ = self.contacts(text)
        self.near(found["1-1"]["pull_off"][1], sjkr_force(2e5, RADIUS / 2))
        self.near(found["1-plate"]["pull_off"][1], sjkr_force(1e5, RADIUS))
        text, _ = self.written(SCRIPT, "--write", "equal-force", "--law", "jkr")
        # gamma = F/(3 pi R*)
        gamma = sjkr_force(2e5, RADIUS / 2) / (3 * math.pi * RADIUS / 2)
        found, _ = self.contacts(text)
        self.near(found["1-1"]["strength"][1], gamma)
        self.near(found["1-1"]["pull_off"][1], sjkr_force(2e5, RADIUS / 2))

    def test_equal_velocity(self):
        given, _ = self.contacts(SCRIPT)
        for law in ("hamaker", "jkr"):
            text, _ = self.written(SCRIPT, "--write", "equal-velocity", "--law", law)
            found, _ = self.contacts(text)
            for name in found:
                self.near(found[name]["escape_velocity"][1], given[name]["escape_velocity"][1], 1e-4)

    def test_other_lines_stay(self):
        text, _ = self.written(self.changed(("cohesion sjkr  #", "cohesion &\n sjkr2 tangential_reduce on #")),
                               "--write", "equal-force", "--cutoff", 5e-10, 2e-7)
        lines = text.splitlines()
        for line in SCRIPT.splitlines():
            if "sjkr" not in line and "cohesionEnergyDensity" not in line and line != "    1e5 0":
                self.assertIn(line, lines)
        self.assertIn("pair_style gran model hertz tangential history cohesion &\n hamaker # of pairs", text)
        self.assertIn("hamakerSurfaceCutoff scalar 5e-10", text)

    def test_variables_that_hold_the_model_are_replaced_on_its_line(self):
        model = "hertz tangential history cohesion sjkr tangential_reduce on rolling_friction cdt"
        script = self.changed(
            ("model hertz tangential history cohesion sjkr primitive type 2", "${model} primitive type $t"),
            ("cohesion sjkr  #", "cohesion &\n ${c} # ${c}"),
            ("# own case", f'variable model string "model {model}"\nvariable c index sjkr\nvariable t index 2'))
        text, error = self.written(script, "--write", "equal-force")
        self.assertIn("fix plate all wall/gran model hertz tangential history cohesion hamaker rolling_friction cdt "
                      "primitive type $t zplane 0\n", text)
        self.assertIn("pair_style gran model hertz tangential history cohesion &\n hamaker # ${c} of pairs\n", text)
        self.assertIn("'tangential_reduce on' is removed", error)
        given, _ = self.contacts(script)
        found, _ = self.contacts(text)
        for name in ("1-1", "1-plate"):
            self.near(found[name]["pull_off"][1], given[name]["pull_off"][1])

    def test_the_step_of_the_exact_scheme_is_in_the_comment(self):
        step = r"time step 0.0001 is longer than advised for the exact scheme \(types 1 and 1, spheres of up to 3 .*"
        for law in ("hamaker", "jkr"):
            text, error = self.written(self.changed(("timestep 1e-6", "timestep 1e-4")), "--write", "equal-force",
                                       "--law", law)
            self.assertRegex(text, f"\n# WARNING: {step}\nvariable")
            self.assertRegex(error, f"in.case:13: the script that is written: {step}\n")
            text, error = self.written(SCRIPT, "--write", "equal-force", "--law", law)
            self.assertNotIn("time step", text + error)

    def test_variables_of_energy_density_radius_and_modulus_stay(self):
        script = self.changed(("2 2e5 1e5 &", "2 ${k} 1e5 &"), ("peratomtype 2e7 2e7", "peratomtype $E $E"),
                              ("# own case", "variable k index 2e5\nvariable E index 2e7"))
        for law, property in (("hamaker", "hamakerConstant"), ("jkr", "surfaceEnergy")):
            text, error = self.written(script, "--write", "equal-force", "--law", law)
            self.assertNotIn("in numbers", error)
            self.assertIn(f"peratomtypepair 2 ${{{property}_1_1}} ${{{property}_1_2}} ${{{property}_1_2}} 0\n", text)
            for words in ((), ("--var", "k", 1.5e5), ("--var", "R", 2e-4), ("--var", "k", 3e5, "R", 1e-3),
                          ("--var", "E", 1e7)):
                given, _ = self.contacts(script, *words)
                found, _ = self.contacts(text, *words)
                for name in ("1-1", "1-plate"):
                    self.near(found[name]["pull_off"][1], given[name]["pull_off"][1])

    def test_a_bond_number_that_sets_the_energy_density_stays(self):
        script = self.changed(("2 2e5 1e5 &", "2 ${k} ${k} &"), ("    1e5 0", "    ${k} 0"),
                              ("# own case", "variable B index 10\nvariable k equal 1e5*v_B^(1/3)"))
        text, error = self.written(script, "--write", "equal-force")
        self.assertNotIn("in numbers", error)
        one, other = (self.contacts(text, *words)[0] for words in ((), ("--var", "B", 25)))
        for name in ("1-1", "1-plate"):
            self.near(other[name]["bond_number"][1], 2.5 * one[name]["bond_number"][1])

    def test_the_comment_states_what_the_numbers_derive_from(self):
        bond = sjkr_force(2e5, RADIUS / 2) / (MASS * GRAVITY)
        text, _ = self.written(SCRIPT, "--write", "equal-force")
        self.assertIn("# hamakerConstant = 6 F H_cut^2/R* keeps the pull-off force F of sjkr for median grains, "
                      "F ~ R*^2 k^3/E*^2. Bond number with the values of the original script: "
                      f"{bond:.4g} (1-1), {bond / 2:.3g}", text)
        text, _ = self.written(SCRIPT, "--write", "equal-force", "--law", "jkr")
        self.assertIn("# surfaceEnergy = F/(3 pi R*) keeps the pull-off force F of sjkr", text)
        text, _ = self.written(SCRIPT, "--write", "equal-velocity")
        speed = self.contacts(SCRIPT)[0]["1-1"]["escape_velocity"][1]
        self.assertIn("# hamakerConstant keeps the escape velocity of sjkr for median grains. Escape velocity with the "
                      f"values of the original script: {speed:.4g} (1-1), ", text)

    def test_definitions_on_several_lines_with_comments_and_in_included_files_are_known(self):
        (self.folder / "numbers").write_text("variable D index 1e-3\nvariable R equal v_D/2\n")
        for lines in ("variable D index 1e-3\nvariable R equal &\n v_D/2", "include numbers",
                      "variable D index 1e-3 # $y\nvariable R equal v_D/2 # v_x"):
            script = self.changed(("variable R index 5e-4", lines))
            self.assertEqual(self.lost(script), [])
            text, _ = self.written(script, "--write", "equal-force")
            given, found = (self.contacts(of, "--var", "D", 2e-3)[0] for of in (script, text))
            self.near(found["1-1"]["pull_off"][1], given["1-1"]["pull_off"][1])
        lines = "variable D string 1e-3\nvariable D string 8e-4\nvariable R equal &\n v_D/2"
        self.assertEqual(self.lost(self.changed(("variable R index 5e-4", lines))), ["R"])

    def test_generated_names_are_not_those_of_the_script(self):
        script = self.changed(("# own case", "variable hamakerConstant_1_1 index 7\n"
                                            "variable hamakerConstant_1_1_ &\n index 8"))
        text, _ = self.written(script, "--write", "equal-force")
        self.assertIn("peratomtypepair 2 ${hamakerConstant_1_1__} ${hamakerConstant_1_2} ", text)
        self.near(self.contacts(text)[0]["1-1"]["pull_off"][1], sjkr_force(2e5, RADIUS / 2))

    def test_a_long_expression_is_not_cut(self):
        name = 600 * "r"
        script = self.changed(("variable R", f"variable {name}"), ("${R}", f"${{{name}}}"))
        text, _ = self.written(script, "--write", "equal-force")
        self.near(self.contacts(text)[0]["1-1"]["pull_off"][1], sjkr_force(2e5, RADIUS / 2))

    def lost(self, script, rule="equal-force"):
        """Variables whose value is in numbers of the script that is written."""
        _, error = self.written(script, "--write", rule)
        for name in re.findall("translate again with '--var (\\w+) VALUE'", error):
            self.assertIn("the script that is written has hamakerConstant in numbers, for this value of the variable "
                          f"'{name}': translate again", error)
        return re.findall("translate again with '--var (\\w+) VALUE'", error)

    def test_a_variable_that_has_no_effect_any_more_is_warned_of(self):
        script = self.changed(("2 2e5 1e5 &", "2 ${k} 1e5 &"), ("    1e5 0", "    1e5 $z"),
                              ("# own case", "variable k index 2e5\nvariable z index 0"))
        self.assertEqual(self.lost(self.changed(("variable R index 5e-4", ""), ("${R}", "5e-4"))), [])
        self.assertEqual(self.lost(script), [])  # nothing adheres between walls
        self.assertEqual(self.lost(script, "equal-velocity"), ["R", "k"])
        self.assertEqual(self.lost(self.changed(("peratomtypepair 2 0.9", "peratomtypepair 2 $e"), ("2500", "$d"),
                                                ("# own case", "variable e index 0.9\nvariable d index 2500")),
                                   "equal-velocity"), ["R", "d", "e"])
        defined = "# own case", "variable E index 2e7\nvariable n index 0.22"
        self.assertEqual(self.lost(self.changed(("peratomtype 2e7", "peratomtype $E"), defined)), ["E"])
        self.assertEqual(self.lost(self.changed(("peratomtype 0.22 0.22", "peratomtype $n $n"), defined)), ["n"])
        # A radius that changes after the property, or that has several values.
        for lines in ("variable R index 5e-4\nvariable R delete\nvariable R index 4e-4",
                      "variable D string 1e-3\nvariable D string 8e-4\nvariable R equal v_D/2"):
            self.assertEqual(self.lost(self.changed(("variable R index 5e-4", lines))), ["R"])
        self.assertEqual(self.lost(self.changed(("constant ${R}", "uniform ${R} 6e-4"))), ["R"])
        # A variable with several words.
        self.assertEqual(self.lost(self.changed(("peratomtype 2e7 2e7", "peratomtype $m"),
                                                ("# own case", "variable m string '2e7 2e7'"))), ["m"])
        self.assertEqual(self.lost(self.changed(("variable R index 5e-4\n", ""),
                                                ("fix p1", "variable R index 5e-4\nfix p1"))), ["R"])

    def test_blank_lines_of_a_script_with_carriage_returns_stay(self):
        script = self.changed(("units si\n", "units si\n\n\n"))
        (self.folder / "in.case").write_bytes(script.replace("\n", "\r\n").encode())
        target = self.folder / "out.case"
        code, _, error = program.call(self.folder / "in.case", "--write", "equal-force", target)
        self.assertEqual(code, 0, error)
        self.assertIn(b"units si\r\n\r\n\r\nvariable R", target.read_bytes())

    def test_friction_of_the_attraction(self):
        script = self.changed(("cohesion sjkr  #", "cohesion sjkr tangential_reduce on #"))
        text, error = self.written(script, "--write", "equal-force")
        self.assertNotIn("tangential_reduce", text)
        self.assertEqual(error.count("in.case:9: 'tangential_reduce on' is removed"), 1)
        _, error = self.written(script.replace("reduce on", "reduce off"), "--write", "equal-force")
        self.assertNotIn("tangential_reduce", error)

    def test_default_cutoffs_are_in_the_units_of_the_script(self):
        text, _ = self.written(self.changed(("units si", "units cgs")), "--write", "equal-force")
        self.assertIn("hamakerSurfaceCutoff scalar 4e-08", text)

    def test_wall_of_the_type_of_grains(self):
        script = self.changed(("primitive type 2", "primitive type 1"), ("2 2e5 1e5", "2 2e5 0"), ("${R}", "5e-4"),
                              ("    1e5 0", "    0 0"))
        text, error = self.written(script, "--write", "equal-force")
        self.assertIn("peratomtypepair 2 3.5939204e-19 0 0 0\n", text)
        self.assertIn("assign the wall an atom type of its own", error)

    def test_types_without_a_size(self):
        """Type 2 of the pairs comes from a file that the program does not read; type 3 is that of the plate."""
        script = self.changed(
            ("peratomtype 2e7 2e7", "peratomtype 2e7 2e7 2e7"), ("0.22 0.22", "0.22 0.22 0.22"),
            ("peratomtypepair 2 0.9 0.9 0.9 0.9", "peratomtypepair 3" + 9 * " 0.9"),
            ("primitive type 2", "primitive type 3"),
            ("2 2e5 1e5 &", "3 2e5 1e5 1e5 1e5 &"), ("    1e5 0", "    1e5 1e5 1e5 1e5 1e5"))
        target = self.folder / "out.case"
        code, output, error = self.call(script, "--write", "equal-force", target)
        self.assertNotEqual(code, 0, output)
        self.assertIn("in.case:7: types 1 and 2 have an energy density but no known size: specify a template, "
                      "or --diameter and --density", error)
        self.assertFalse(target.exists())
        text, _ = self.written(script, "--write", "equal-force", "--diameter", 1e-3, "--density", 2500)
        found, _ = self.contacts(text, "--diameter", 1e-3, "--density", 2500)
        for name in ("1-2", "2-2"):
            self.near(found[name]["pull_off"][1], sjkr_force(1e5, RADIUS / 2))

    def test_files_of_the_script_are_not_replaced(self):
        (self.folder / "part").write_text("units si\n")
        script = self.changed(("units si", "include part"))
        for name, target in (("link", "in.case"), ("link_of_part", "part")):
            (self.folder / name).symlink_to(self.folder / target)
        for target, what in (("./in.case", "the script:"), ("link", "the script:"), ("part", "the included file '"),
                             ("./part", "the included file '"), ("link_of_part", "the included file '")):
            code, output, error = self.call(script, "--write", "equal-force", f"{self.folder}/{target}")
            self.assertNotEqual(code, 0, output)
            self.assertIn(f"--write would replace {what}", error)
            self.assertEqual((self.folder / "in.case").read_text(), script)
            self.assertEqual((self.folder / "part").read_text(), "units si\n")

    def test_refusals(self):
        for script, words, parts in (
                (SCRIPT, ("equal-speed", "out"), ("equal-force or equal-velocity",)),
                (SCRIPT, ("equal-force", self.folder / "in.case"), ("would replace the script",)),
                (SCRIPT, ("equal-force", "/nowhere/out"), ("'/nowhere/out' cannot be written",)),
                (SCRIPT.replace("cohesion sjkr", ""), ("equal-force", "out"), ("no cohesion sjkr",)),
                (self.changed(("cohesion sjkr  #", "cohesion 'sjkr' #")),
                 ("equal-force", self.folder / "out"), ("in.case:9", "cohesion model is in quotes")),
                (self.changed(("2 0.9", "2 1.0")), ("equal-velocity", "out"), ("escape velocity",)),
                (self.changed(("model hertz", "model hooke"))
                 + "fix v all property/global characteristicVelocity scalar 2\n",
                 ("equal-force", "out"), ("in.case:9", "no pull-off force to keep"))):
            code, output, error = self.call(script, "--write", *words)
            self.assertNotEqual(code, 0, output)
            for part in parts:
                self.assertIn(part, error)


class Units(Translated):
    def refused(self, script, text, *words):
        code, output, error = self.call(script, *words)
        self.assertNotEqual(code, 0, output)
        self.assertIn(text, error)

    def test_units_without_metres_have_no_defaults(self):
        gravity = next(line for line in SCRIPT.splitlines() if "fix gravity" in line)
        for units in ("units lj", ""):
            script = self.changed(("units si", units))
            speed, target = ("--speed", 1), self.folder / "out.case"
            self.refused(script, "units lj have no speed in metres per second: specify --speed")
            self.refused(script.replace(gravity, ""), "units lj have no acceleration", *speed)
            self.refused(script, "units lj have no length in metres: specify --cutoff",
                         *speed, "--write", "equal-force", target)
            self.assertFalse(target.exists())
            for words in (("--cutoff", 4e-10, 1e-7), ("--law", "jkr")):
                code, _, error = self.call(script, *speed, "--write", "equal-force", target, *words)
                self.assertEqual(code, 0, error)
                target.unlink()

    def test_assumed_conditions_are_marked(self):
        script = "\n".join(line for line in SCRIPT.splitlines() if "fix gravity" not in line)
        for text, words, line in (
                (script, (), "Impacts at 1 [length/time] (assumed); gravity 9.81 [length/time^2] (assumed)"),
                (SCRIPT, ("--speed", 2), "Impacts at 2 [length/time]; gravity 9.81 [length/time^2]")):
            code, output, error = self.call(text, *words)
            self.assertEqual(code, 0, error)
            self.assertEqual(output.splitlines()[0], line)


class Errors(Translated):
    def refused(self, script, *parts, words=()):
        code, output, error = self.call(script, *words)
        self.assertNotEqual(code, 0, output)
        for part in parts:
            self.assertIn(part, error + output)

    def test_place_and_cure(self):
        self.refused(self.changed(("cohesion sjkr primitive", "cohesion easo/capillary/viscous primitive")),
                     "in.case:10: 'cohesion easo/capillary/viscous' is not evaluated", "sjkr2")
        self.refused(self.changed(("model hertz tangential history cohesion sjkr  #", "model luding #")),
                     "in.case:9: 'model luding' is not evaluated")
        for keyword in ("limitForce", "viscous"):
            self.refused(self.changed(("cohesion sjkr  #", f"cohesion sjkr {keyword} on #")),
                         f"in.case:9: '{keyword} on' is not evaluated: remove it for this check")
        self.contacts(self.changed(("cohesion sjkr  #", "cohesion sjkr limitForce off #")))
        self.refused(self.changed(("model hertz tangential history cohesion sjkr  #", "model hooke cohesion jkr #"),
                                  ("cohesionEnergyDensity", "surfaceEnergy"))
                     + "fix v all property/global characteristicVelocity scalar 2\n",
                     "in.case:9: 'cohesion jkr' needs 'model hertz', not 'model hooke'")
        self.refused(self.changed(("pair_style gran model hertz", "pair_style gran/hertz/history 1 0 #")),
                     "in.case:9", "LIGGGHTS 3")
        self.refused(self.changed(("pair_style gran model hertz", "pair_style granular #")),
                     "in.case:9: pair_style granular of LAMMPS is not evaluated", "gran/jkr for jkr")
        self.refused(self.changed(("youngsModulus", "youngModulus")), "youngsModulus", "add this line")
        self.refused(self.changed(("variable R index", "#")),
                     "in.case:11: the value of the variable 'R'", "--var R VALUE")
        self.refused(self.changed(("constant ${R}", "constant 1mm")), "in.case:11: '1mm' is no number")
        self.refused(self.changed(("constant ${R}", "lognormal 1 2")), "in.case:11", "uniform or gaussian number")
        self.refused(self.changed(("constant ${R}", "gaussian mass 1e-3 1e-4")), "in.case:11", "'gaussian mass'")
        self.refused(self.changed(("constant ${R}", "gaussian 1e-3 4e-4")), "in.case:11", "above three deviations")
        self.refused(self.changed(("density constant 2500", "density uniform 2000 3000")), "in.case:11", "constant RHO")
        self.refused(self.changed(("    1e5 0", "    2e5 0")), "in.case:7", "symmetric")
        self.refused(self.changed(("peratomtype 2e7 2e7", "peratomtype 2e7")), "in.case:4", "youngsModulus of type 2")
        self.refused(self.changed(("0.22 0.22", "0.22 0.7")), "Poisson's ratio", "0.7")
        self.refused(self.changed(("primitive type", "kind")), "in.case:10", "primitive")
        wall = "primitive type 2 zplane 0"
        self.refused(self.changed((wall, "mesh n_meshes 1 meshes cad")),
                     "in.case:10: mesh 'cad' has no 'fix mesh/surface ... type': define it before the wall")
        self.refused(self.changed((wall, "mesh n_meshes 2 meshes cad"),
                                  ("units si", "fix cad all mesh/surface file x type 2")),
                     "in.case:10", "ends before the ID of a mesh")
        self.refused(self.changed((wall, "mesh meshes cad")), "in.case:10", "add 'n_meshes'")
        self.refused("units si\n", "neither 'pair_style gran' nor")
        self.refused(self.changed(("fix p1", "#")), "specify --diameter and --density")
        self.refused("include nowhere\n", "in.case:1: the file 'nowhere' cannot be read")
        code, _, error = program.call("/nowhere/in.case")
        self.assertNotEqual(code, 0)
        self.assertIn("'/nowhere/in.case' cannot be read", error)


if __name__ == "__main__":
    unittest.main()
