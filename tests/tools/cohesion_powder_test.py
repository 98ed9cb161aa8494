# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-powder: its numbers beside formulas written out again, and what it refuses."""
import math
import re
import tempfile
import unittest
from pathlib import Path

from cohesion_tests.csv_program import CsvProgram
from cohesion_tests.theory.closure_formulas import DOUBLE, ergun_pressure_gradient

program = CsvProgram("COHESION_POWDER")

RHO, MU, G = 1.205, 1.82e-5, 9.81  # of the gas, unless told
GLASS = ("--diameter", 5e-4, "--density", 2500, "--young", 63e9, "--poisson", 0.22, "--hamaker", 6.5e-20)
BED = ("--width", 0.05, "--depth", 0.04, "--height", 0.1)


class Numbers(unittest.TestCase):
    def near(self, found, expected, relative=1e-12):
        self.assertAlmostEqual(found / expected, 1, delta=relative)

    def test_glass(self):
        found = program.values(*GLASS, *BED)
        d, density, eps = 5e-4, 2500, 0.42
        self.near(ergun_pressure_gradient(DOUBLE, eps, found["u_mf_ergunWenYu"], d, RHO, MU),
                  (1 - eps) * (density - RHO) * G)
        mass = density * math.pi / 6 * d**3
        pull_off = 6.5e-20 / 6 * 0.25 * d / 4e-10**2
        self.near(found["pull_off"], pull_off)
        self.near(found["bond"], pull_off / (mass * G))
        speed = 2 * max(value for name, value in found.items() if name.startswith("u_mf_") and "wen_yu" not in name)
        self.near(found["impact_speed"], speed)
        # 4/5 E* sqrt(R*) ... : largest overlap of Hertz's impact
        modulus = 63e9 / (2 * (1 - 0.22**2))
        overlap = (15 * mass / 2 * speed**2 / (16 * modulus * math.sqrt(d / 4))) ** 0.4
        self.near(found["hertz_time"], 2.9432 * overlap / speed)
        without = program.values(*GLASS[:-2])
        self.near(without["material_stiffness"], mass / 2 * speed**2 / overlap**2)
        self.assertEqual((without["escape_over_material"], without["pull_off_over_material"]), (1, 1))
        area, height = 0.05 * 0.04, 0.1
        self.near(found["grains"], (1 - eps) * area * height / (math.pi / 6 * d**3))
        self.near(found["mass"], (1 - eps) * area * height * density)
        self.near(found["pressure_drop"], (1 - eps) * (density - RHO) * G * height)

    def test_springs_are_soft_enough_and_not_softer(self):
        found = program.values(*GLASS, "--overlap", 0.005)
        # Of an impact without loss on a wall, which presses more than a pair; restitution makes it less.
        mass = 2500 * math.pi / 6 * 5e-4**3
        overlap = found["impact_speed"] * math.sqrt(mass / found["stiffness"]) / 5e-4
        self.assertLess(overlap, 0.0055)
        self.assertGreater(overlap, 0.0045)

    def test_soft_springs_keep_what_is_asked(self):
        velocity, force = (program.values(*GLASS, "--keep", keep) for keep in ("velocity", "force"))
        self.near(velocity["escape_over_material"], 1)
        self.near(velocity["pull_off_over_material"],
                  math.sqrt(velocity["stiffness"] / velocity["material_stiffness"]))
        self.near(force["pull_off_over_material"], 1)
        # F_ad^2/(2 K) is more than in the material, W what it was.
        self.assertGreater(force["escape_over_material"], 1)

    def test_stiffness_given_is_used(self):
        found = program.values("--diameter", 1e-3, "--density", 2650, "--stiffness", 800, "--hamaker", 7.49e-19)
        self.assertEqual((found["stiffness"], found["material_stiffness"]), (800, 800))
        # t_c/8 and not above; a whole part of the gas step, and that of 0.01 s, so that some twentieth may be missing
        step = found["contact_time"] / 8
        self.assertLessEqual(found["particle_step"], step)
        self.assertGreater(found["particle_step"], 0.9 * step)
        for steps in (found["gas_step"] / found["particle_step"], 0.01 / found["gas_step"]):
            self.assertAlmostEqual(steps, round(steps), delta=1e-9 * steps)

    def test_the_gas_has_twice_the_minimum_fluidisation_of_the_closure_of_the_case(self):
        for words, closure in (((), "beetstra"), (("--drag", "wenYu"), "wenYu")):
            found = program.values(*GLASS, *words)
            self.near(found["gas_velocity"], 2 * found[f"u_mf_{closure}"])
        self.assertNotEqual(found["u_mf_beetstra"], found["u_mf_wenYu"])

    def test_surface_energy_is_that_of_derjaguin(self):
        found = program.values(*GLASS[:-2], "--surface-energy", 0.02)
        self.near(found["pull_off"], 4 * math.pi * 0.02 * 0.25 * 5e-4)

    def test_rough_grains(self):
        rms, wavelength, reduced = 5e-9, 5e-7, 0.25 * 5e-4
        found, smooth = (program.values(*GLASS, "--keep", "force", *more)
                         for more in (("--roughness", rms, wavelength), ()))
        self.near(found["pull_off"] / smooth["pull_off"], 1 / (1 + 32 * 1.817 * reduced * rms / wavelength**2)
                  + 1 / (1 + 1.817 * rms / 4e-10)**2)
        code, output, error = program.call(*GLASS, "--keep", "force", "--roughness", rms, wavelength)
        self.assertIn("roughness 5e-09 5e-07", output)

    def test_distributions(self):
        found = program.values("--diameter", 1e-4, 4e-4, *GLASS[2:])
        self.near(found["sauter_mean"], 1.6e-4)
        self.near(found["size_ratio"], 4)
        # F_ad goes with d, the weight with its cube.
        self.near(found["bond_largest"], found["bond"] / 16)
        found = program.values("--percentiles", 2e-5, 4e-5, 8e-5, *GLASS[2:])
        self.near(found["sauter_mean"], 1e-6 / 0.02875)

    def test_each_pair_of_sizes_has_the_stiffness_of_its_material(self):
        """Of a pair of two sizes that of two equal grains with its reduced radius; those of K_m decide 1/K^(1/5)."""
        arguments = (*GLASS[2:], "--speed", 0.05, "--restitution", 1)
        for keep in ("force", "velocity"):
            code, output, error = program.call("--diameter", 1e-4, 2e-4, *arguments, "--keep", keep)
            self.assertEqual(code, 0, error)
            pairs = re.findall(r"pair_coeff (\d \d) .* material_stiffness (\S+) material_keep " + keep, output)
            self.assertEqual([name for name, _ in pairs], ["1 1", "1 2", "2 2"])
            stiffness = [float(value) for _, value in pairs]
            for k, diameter in ((0, 1e-4), (2, 2e-4)):
                alone = program.values("--diameter", diameter, *arguments, "--keep", keep)
                self.near(stiffness[k], alone["material_stiffness"], 1e-5)
            # In Hertz's impact at equal speed K_m = mu v^2/x^2 goes as mu^(1/5) R*^(2/5).
            reduced = (2 / 3 / 0.5) ** 0.4 * (8 / 9 / 0.5) ** 0.2
            if keep == "force":
                self.near(stiffness[1] / stiffness[0], reduced, 2e-2)
        one = program.call("--diameter", 1e-4, *arguments)[1]
        self.assertEqual(one.count("pair_coeff * *"), 1)
        liggghts = program.call("--diameter", 1e-4, 2e-4, *arguments, "--engine", "liggghts")[1]
        matrix = re.search(r"materialStiffness peratomtypepair 3 (.*)", liggghts)[1].split()
        self.assertEqual([float(value) for value in matrix[:2] + matrix[4:5]], stiffness)

    def test_the_steps_of_a_contact_are_printed(self):
        output = program.call(*GLASS)[1]
        found = program.values(*GLASS)
        steps = float(re.search(r"particle step, t_c/(\S+), scheme exact", output)[1])
        self.near(steps, found["contact_time"] / found["particle_step"], 5e-3)

    def test_a_packing_has_falling_grains_ten_steps_and_walls(self):
        packing = (*GLASS, "--keep", "force", "--use", "packing")
        found, bed = program.values(*packing), program.values(*packing[:-2])
        fall = math.sqrt(2 * G * 5e-4)
        self.near(found["impact_speed"], fall)
        self.assertGreater(bed["impact_speed"], 2 * fall)
        # Steps become shorter, to divide an interval of outputs.
        self.assertGreaterEqual(found["contact_time"] / found["particle_step"], 10 * (1 - 1e-9))
        self.assertLess(found["contact_time"] / found["particle_step"], 11)
        output = program.call(*packing)[1]
        contact = re.search(r"pair_coeff \* \* (.*)", output)[1]
        self.assertIn(f"# walls, all: {contact}\n", output)
        self.assertNotIn("# walls", program.call(*packing[:-2])[1])
        hertz = program.values(*packing, "--contact", "hertz")
        self.assertGreaterEqual(hertz["contact_time"] / hertz["particle_step"], 20 * (1 - 1e-9))
        self.near(program.values(*packing, "--speed", 0.3)["impact_speed"], 0.3)

    def test_parcels_are_grains_magnified(self):
        words = ("--diameter", 1e-3, "--density", 2650, "--stiffness", 800, "--hamaker", 7.49e-19, *BED)
        grains, parcels = (program.values(*words, *more) for more in ((), ("--coarse-graining", 2)))
        for same in ("u_mf_beetstra", "bond", "contact_time", "grains", "mass", "pressure_drop", "impact_speed"):
            self.assertEqual(grains[same], parcels[same])
        self.near(parcels["spheres"], grains["grains"] / 8)
        self.near(parcels["bond_computed"], grains["bond"] / 2)
        self.near(parcels["cell"], 6e-3)
        # In two digits
        self.near(parcels["particle_step"], 2 * grains["particle_step"], 0.1)
        _, output, _ = program.call(*words, "--coarse-graining", 2)
        self.assertIn("stiffness 1600 restitution 0.9 friction 0.3 hamaker 5.992e-18 cutoff 8e-10 2e-07", output)

    def test_cells_are_as_wide_as_asked_for(self):
        """And the gas step is that of the Courant number in them, but for a whole number of particle steps."""
        coarse, fine = (program.values(*GLASS, *BED, *more) for more in ((), ("--cell", 2)))
        self.near(coarse["cell"], 1.5e-3)
        self.near(fine["cell"], 1e-3)
        # Whole parts of 0.01 s: one step more or less of them.
        self.near(fine["particle_step"], coarse["particle_step"], fine["gas_step"] / 0.01)
        self.assertAlmostEqual(fine["gas_step"] / coarse["gas_step"], 2 / 3, delta=fine["gas_step"] / 0.01
                               + 1.5 * fine["particle_step"] / coarse["gas_step"])
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case"
            code, _, error = program.call(*GLASS, *BED, "--cell", 2, "--write", case)
            self.assertEqual(code, 0, error)
            text = (case / "constant/powder").read_text()
            top, rows = (float(text.split(f"\n{name} ")[1].split(";")[0]) for name in ("top", "rows"))
            self.near(top / rows, 1e-3)

    def test_few_parcels_across_are_warned_of(self):
        words = ("--diameter", 1e-3, "--density", 2650, "--stiffness", 800, *BED)
        for ratio, warned in ((2, False), (3, True)):  # 0.04 m: 20 and 13
            code, _, error = program.call(*words, "--coarse-graining", ratio)
            self.assertEqual((code, "parcels across" in error), (0, warned), error)

    def test_a_gas_by_name(self):
        words = ("--diameter", 5e-4, "--density", 2500, "--stiffness", 800)
        self.near(program.values(*words)["gas_density"], RHO)
        self.near(program.values(*words)["gas_viscosity"], MU)
        # Ideal gas, and Sutherland's law with the constants of White's table
        found = program.values(*words, "--gas", "nitrogen", "--pressure", 3e5, "--temperature", 600)
        self.near(found["gas_density"], 3e5 * 28.01348 / 8314.46261815324 / 600)
        self.near(found["gas_viscosity"], 1.663e-5 * (600 / 273)**1.5 * (273 + 107) / (600 + 107))
        # 20 C and one atmosphere unless told: the air that is taken without a name, to a part in two hundred.
        found = program.values(*words, "--gas", "air")
        self.near(found["gas_density"], 101325 * 28.96546 / 8314.46261815324 / 293.15)
        self.near(found["gas_density"], RHO, 0.005)
        self.near(found["gas_viscosity"], MU, 0.005)
        # All that sees the gas sees this one.
        same = program.values(*words, "--gas-density", found["gas_density"], "--gas-viscosity", found["gas_viscosity"])
        self.assertEqual(found, same)

    def test_liggghts_has_ten_steps_of_a_contact(self):
        words = ("--diameter", 1e-3, "--density", 2650, "--stiffness", 800, "--hamaker", 7.49e-19)
        found = program.values(*words, "--engine", "liggghts")
        self.assertLessEqual(found["particle_step"], found["contact_time"] / 10)
        self.assertGreater(found["particle_step"], 0.9 * found["contact_time"] / 10)


class SquareWell(unittest.TestCase):
    WELL = ("--law", "square_well")

    def test_depth_is_that_of_the_escape_velocity_of_the_material(self):
        found = program.values(*GLASS, *self.WELL)
        hamaker = program.values(*GLASS)
        reduced = 0.5 * 2500 * math.pi / 6 * 5e-4**3
        # v^2 = (2 D/m)(1/e^2 - 1)
        speed = math.sqrt(2 * found["well_depth"] / reduced * (1 / 0.9**2 - 1))
        self.assertAlmostEqual(speed / hamaker["material_escape"], 1, delta=1e-12)
        self.assertAlmostEqual(found["escape_over_material"], 1, delta=1e-12)
        self.assertEqual(found["pull_off_over_material"], 0)
        self.assertAlmostEqual(found["well_width"] / 5e-6, 1, delta=1e-12)
        weight = 2 * reduced * G
        self.assertAlmostEqual(found["well_bond"] * weight * found["well_width"] / found["well_depth"], 1, delta=1e-12)
        # A well that bears what the attraction bears is as narrow as that.
        narrow = program.values(*GLASS, *self.WELL, "--well-ratio", 1 + found["well_width_bond"] / 5e-4)
        # 1 + 3e-6 leaves 11 digits of the width.
        self.assertAlmostEqual(narrow["well_bond"] / found["bond"], 1, delta=1e-9)
        self.assertEqual(narrow["well_depth"], found["well_depth"])
        for words, warned in (((), True), (("--well-ratio", 1 + found["well_width_bond"] / 5e-4), False)):
            _, output, error = program.call(*GLASS, *self.WELL, *words)
            self.assertEqual("not against a weight" in error, warned, error)
        self.assertIn("well 1.4798", output)
        self.assertIn(" 1.00000", output.split("friction 0.3 well ")[1].split("\n")[0])
        # What is the powder's and not the law's
        for same in ("bond", "pull_off", "material_stiffness", "u_mf_beetstra"):
            self.assertEqual(found[same], hamaker[same])

    def test_rough_grains_may_have_soft_springs(self):
        found = program.values(*GLASS, *self.WELL, "--asperity", 1e-7)
        self.assertAlmostEqual(found["escape_over_material"], 1, delta=1e-12)
        self.assertLess(found["well_depth"], program.values(*GLASS, *self.WELL)["well_depth"])

    def test_scripts_name_each_pair_and_each_wall(self):
        two = ("--diameter", 2e-4, 4e-4, *GLASS[2:], *self.WELL, "--well-ratio", 1.02)
        found = program.values(*two)
        _, lammps, _ = program.call(*two)
        self.assertIn("pair_style gran/squarewell scheme exact", lammps)
        self.assertNotIn("material_stiffness", lammps)
        depths = {line.split("stiffness")[0].strip(): float(line.split(" well ")[1].split()[0])
                  for line in lammps.split("\n") if " friction 0.3 well " in line}
        self.assertEqual(list(depths), ["pair_coeff 1 1", "pair_coeff 1 2", "pair_coeff 2 2", "# walls, size_1:",
                                        "# walls, size_2:"])
        # Six digits are printed.
        for name, value in (("pair_coeff 1 1", "well_depth"), ("pair_coeff 2 2", "well_depth_largest"),
                            ("# walls, size_1:", "well_depth_wall")):
            self.assertAlmostEqual(depths[name] / found[value], 1, delta=1e-5)
        _, liggghts, _ = program.call(*two, "--engine", "liggghts")
        matrix = [float(word) for word in liggghts.split("global wellDepth peratomtypepair 3")[1].split("\n")[0].split()]
        expected = [depths[name] for name in ("pair_coeff 1 1", "pair_coeff 1 2", "# walls, size_1:", "pair_coeff 1 2",
                                              "pair_coeff 2 2", "# walls, size_2:", "# walls, size_1:", "# walls, size_2:")]
        self.assertEqual(matrix[:8], expected)
        self.assertIn("fix wellRatio all property/global wellRatio peratomtype 1.02 1.02 1", liggghts)
        self.assertIn("cohesion square_well", liggghts)

    def test_parcels_have_the_depth_of_their_volume(self):
        depth = lambda *more: float(program.call(*GLASS, *self.WELL, *more)[1].split(" friction 0.3 well ")[1].split()[0])
        self.assertAlmostEqual(depth("--coarse-graining", 2) / depth() / 8, 1, delta=1e-5)


class Elastic(unittest.TestCase):
    """--contact hertz and jkr of grains of 0.5 mm."""
    D, RADIUS = 5e-4, 1.25e-4
    MODULUS = 63e9 / (2 * (1 - 0.22**2))
    HERTZ, JKR = (*GLASS, "--contact", "hertz"), (*GLASS[:-2], "--surface-energy", 0.02, "--contact", "jkr")

    def near(self, found, expected, relative=1e-12):
        self.assertAlmostEqual(found / expected, 1, delta=relative)

    def test_pull_off_and_tabor(self):
        found = program.values(*self.HERTZ)
        self.near(found["pull_off"], 6.5e-20 * self.RADIUS / (6 * 4e-10**2))
        work = found["pull_off"] / (2 * math.pi * self.RADIUS)
        self.near(found["tabor"], (self.RADIUS * work**2 / (self.MODULUS**2 * 2e-10**3))**(1 / 3))
        found = program.values(*self.JKR)
        self.near(found["pull_off"], 3 * math.pi * 0.02 * self.RADIUS)
        self.near(found["work_of_adhesion"], 0.04)

    def test_steps_are_a_twentieth_of_the_contact_of_the_softened_run(self):
        for words in (self.HERTZ, self.JKR, self.HERTZ[:-4] + ("--contact", "hertz")):
            found = program.values(*words, "--soft-young", 1e8)
            self.assertEqual(found["modulus"], 1e8)
            step = found["contact_time"] / 20
            # A whole part of the gas step, and that of 0.01 s.
            self.assertTrue(0.9 * step < found["particle_step"] <= step, found)
        # Without adhesion, as the last: 2.87 (mu^2/(R* E*^2 v))^(1/5), three digits.
        mu, modulus = 0.5 * 2500 * math.pi / 6 * self.D**3, self.MODULUS * 1e8 / 63e9
        self.near(found["contact_time"], 2.87 * (mu**2 / (self.RADIUS * modulus**2 * found["impact_speed"]))**0.2, 2e-3)

    def test_a_softer_modulus_keeps_what_is_asked(self):
        for words in (self.HERTZ, self.JKR):
            velocity, force = (program.values(*words, "--soft-young", 1e8, "--keep", keep) for keep in ("velocity", "force"))
            # Both speeds are bisected to 1e-5.
            self.near(velocity["escape_over_material"], 1, 3e-5)
            self.near(velocity["pull_off_over_material"], (1e8 / 63e9)**0.4)
            self.assertEqual(force["pull_off_over_material"], 1)
            self.assertGreater(force["escape_over_material"], 2)

    def test_the_modulus_is_as_soft_as_the_overlap_allows(self):
        for words in (self.HERTZ, self.JKR):
            found = program.values(*words, "--overlap", 0.005)
            # Of an elastic impact on a wall, twice the mass and twice R*: x ~ (mu^2/R*)^(1/5); the adhesion adds little.
            overlap = found["impact_overlap"] * 2**0.2
            self.assertTrue(0.0045 < overlap <= 0.005, overlap)
            self.assertLess(found["modulus"], 63e9)
        self.assertEqual(program.values(*self.HERTZ, "--overlap", 1e-5)["modulus"], 63e9)

    def test_lines_of_scripts(self):
        _, output, _ = program.call(*self.HERTZ, "--soft-young", 1e8)
        self.assertIn("pair_coeff * * normal hertz 1e+08 0.22 restitution 0.9 friction 0.3 hamaker 6.5e-20 cutoff 4e-10 1e-07 "
                      "material_modulus 6.3e+10 0.22 material_keep velocity", output)
        _, output, _ = program.call(*self.JKR, "--soft-young", 1e8, "--coarse-graining", 2)
        self.assertIn("pair_style gran/jkr scheme exact", output)
        # Energies of surfaces grow as lengths, moduli stay.
        self.assertIn("normal hertz 1e+08 0.22 restitution 0.9 friction 0.3 surface_energy 0.04 material_modulus 6.3e+10 0.22 "
                      "material_keep velocity", output)
        _, output, _ = program.call(*self.JKR, "--soft-young", 63e9)
        self.assertNotIn("material_modulus", output)

    def test_lines_of_liggghts_have_the_attraction_of_the_material(self):
        for keep in ("velocity", "force"):
            keywords = f"tangential_damping on material_modulus on material_keep {keep}\n"
            _, output, _ = program.call(*self.HERTZ, "--soft-young", 1e8, "--keep", keep, "--engine", "liggghts")
            self.assertIn("fix youngsModulus all property/global youngsModulus peratomtype 100000000 100000000", output)
            self.assertIn("fix materialYoungsModulus all property/global materialYoungsModulus peratomtype 63000000000 63000000000",
                          output)
            self.assertIn(f"model hertz tangential history cohesion hamaker {keywords}", output)
            self.assertNotIn("particles yes", output)
            value = lambda name, k: float(output.split(f"property/global {name} ")[1].split("\n")[0].split()[k])
            self.near(value("hamakerConstant", 2), 6.5e-20, 1e-9)
            self.near(value("hamakerSurfaceCutoff", 1), 4e-10, 1e-9)
            _, output, _ = program.call(*self.JKR, "--soft-young", 1e8, "--keep", keep, "--engine", "liggghts")
            self.assertIn(f"model hertz tangential history cohesion jkr {keywords}", output)
            self.near(value("surfaceEnergy", 2), 0.02, 1e-9)
        _, output, _ = program.call(*self.JKR, "--soft-young", 63e9, "--engine", "liggghts")
        self.assertNotIn("material", output.split("pair_style")[1])
        for soft, command in ((1e6, "soft_particles yes"), (63e9, "hard_particles yes")):
            words = self.HERTZ[:-4] + ("--contact", "hertz", "--soft-young", soft, "--engine", "liggghts")
            self.assertIn(command, program.call(*words)[1])

    def test_what_makes_no_sense(self):
        for words, *parts in ((("--contact", "jkr"), "--surface-energy"),
                              (("--soft-young", 1e8), "is of --contact hertz and jkr"),
                              (("--contact", "hertz", "--stiffness", 100), "stiffness K = 100"),
                              (("--contact", "hertz", "--soft-young", 1e11), "must not be above"),
                              (("--contact", "hertz", "--law", "square_well"), "square well"),
                              (("--contact", "hertz", "--asperity", 1e-7), "--keep force"),
                              (("--contact", "hertz", "--soft-young", 1e3), "too small for the softened contact"),
                              (("--contact", "mindlin"), "mindlin")):
            code, output, error = program.call(*GLASS, *words)
            self.assertNotEqual(code, 0, words)
            for part in parts:
                self.assertIn(part, error + output)
        code, _, error = program.call(*self.JKR, "--asperity", 1e-7)
        self.assertEqual((code, "smooth spheres" in error), (1, True), error)

    def test_tabors_parameter_is_warned_of(self):
        soft = ("--diameter", 1e-4, "--density", 1000, "--young", 1e7, "--surface-energy", 0.02)
        hard = ("--diameter", 1e-6, "--density", 2500, "--young", 2e11, "--surface-energy", 0.005)
        for words, contact, warned in ((soft, "hertz", True), (soft, "jkr", False), (hard, "jkr", True), (hard, "hertz", False)):
            code, _, error = program.call(*words, "--contact", contact)
            self.assertEqual((code, "Tabor's parameter is" in error), (0, warned), error)


class LiggghtsProperties(unittest.TestCase):
    def matrices(self, *words):
        code, output, error = program.call(*words, "--engine", "liggghts")
        self.assertEqual(code, 0, error)
        lines = [line.split() for line in output.split("\n") if "peratomtypepair" in line]
        return {line[1]: [float(value) for value in line[7:]] for line in lines}

    def test_dashpots_are_of_the_mass_of_each_pair(self):
        """Of every pair the restitution: e = exp(-pi z/sqrt(1 - z^2)), eta = 2 z sqrt(K m)."""
        found = self.matrices("--diameter", 1e-3, 2e-3, "--density", 2650, "--stiffness", 800, "--restitution", 0.8)
        z = -math.log(0.8) / math.hypot(math.pi, math.log(0.8))
        masses = [2650 * math.pi / 6 * d**3 for d in (1e-3, 2e-3)]
        pair = masses[0] * masses[1] / sum(masses)
        for place, mass in ((0, masses[0] / 2), (1, pair), (2, masses[0]), (3, pair), (4, masses[1] / 2), (5, masses[1])):
            # Six digits are printed.
            self.assertAlmostEqual(found["gamman_abs"][place] / (2 * z * math.sqrt(800 * mass)), 1, delta=1e-5)
        self.assertNotIn("hamakerConstant", found)

    def test_rough_grains_have_the_constant_of_their_pull_off_force(self):
        d, r, cut = 1e-4, 1e-7, 4e-10
        found = self.matrices("--diameter", d, "--density", 1500, "--stiffness", 10, "--hamaker", 1e-19, "--asperity", r)
        for place, radius in ((0, d / 4), (1, d / 2)):
            # Rumpf: a sphere of the asperity's radius, and the bodies behind it
            share = r / (r + radius) + (cut / (cut + r))**2
            self.assertAlmostEqual(found["hamakerConstant"][place] / (1e-19 * share), 1, delta=1e-5)


class Refusals(unittest.TestCase):
    def refused(self, words, *parts, code=1):
        found, output, error = program.call(*words)
        self.assertNotEqual(found, 0, output)
        for part in parts:
            self.assertIn(part, error + output)

    def test_what_makes_no_sense(self):
        self.refused(("--density", 2500, "--young", 1e9), "--diameter")
        self.refused((*GLASS[:2], "--density", 30, *GLASS[4:], "--gas-density", 40),
                     "density of the grains = 30: must be above that of the gas")
        self.refused((*GLASS, "--mass-share", 1, 2), "number of mass shares = 2", "one for each diameter")
        self.refused((*GLASS, "--height", 0.1), "height of the bed", "--width and --depth or --column")
        self.refused((*GLASS, "--width", 0.1), "--width requires --depth")
        self.refused((*GLASS, "--diameter", 6e-4), "--diameter: given twice")
        self.refused((*GLASS, "--gravity", 9.8, "--gravity", 1.6), "--gravity")
        self.refused((*GLASS, "--coarse-graining", 0.5), "--coarse-graining")
        self.refused((*GLASS, *BED, "--use", "packing", "--write", "never-written"),
                     "--use packing: --write writes a fluidised bed", "leave --use packing out")
        self.refused((*GLASS, "--cell", 1), "--cell")
        self.refused((*GLASS, "--measure", "--engine", "liggghts"), "--measure runs LAMMPS")
        self.refused((*GLASS, *BED, "--grains", 100, "--write", "never-written"), "--grains = 100: the smallest vessel",
                     "2 cells across")
        self.assertFalse(Path("never-written").exists())
        with tempfile.TemporaryDirectory() as folder:
            for more in ((), ("--column", 0.05)):
                words = (*GLASS, *(BED if not more else ("--height", 0.1)), *more, "--write", Path(folder) / f"case-{len(more)}")
                _, _, said = program.call(*words, "--grains", 100)
                enough = int(said.split(" has ")[1].split(":")[0])
                self.refused((*words, "--grains", enough - 1), f"has {enough}:")
                code, _, said = program.call(*words, "--grains", enough)
                self.assertEqual(code, 0, said)
        self.refused((*GLASS, "--asperity", 1e-7), "asperity", "--keep force")
        self.refused((*GLASS, "--roughness", 5e-9, 5e-7), "asperity", "--keep force")
        self.refused((*GLASS, "--roughness", 5e-9, 5e-7, "--asperity", 1e-7), "--asperity")
        self.refused((*GLASS, "--keep", "force", "--roughness", 1e-10, 1e-5), "asperity height", "of smooth surfaces")
        self.refused((*GLASS, "--surface-energy", 0.1), "--surface-energy")
        self.refused((*GLASS, "--gas", "steam"), "steam", "nitrogen")
        self.refused((*GLASS, "--gas", "air", "--gas-density", 1.2), "--gas-density excludes --gas")
        self.refused((*GLASS, "--gas-viscosity", 2e-5, "--gas", "air"), "--gas-viscosity excludes --gas")
        self.refused((*GLASS, "--pressure", 2e5), "--pressure requires --gas")
        self.refused((*GLASS, "--temperature", 300), "--temperature requires --gas")
        self.refused((*GLASS, "--gas", "helium", "--temperature", 900), "temperature of helium = 900", "200 and 600 K")
        self.refused((*GLASS, "--gas", "carbon-dioxide", "--pressure", 2e6), "pressure of carbon-dioxide = 2e+06", "ideal")
        well = ("--law", "square_well")
        self.refused((*GLASS, "--well-ratio", 1.02), "well = 1.02", "add --law square_well")
        self.refused((*GLASS, *well, "--keep", "force"), "none to keep")
        self.refused((*GLASS[:-2], *well), "give --hamaker or --surface-energy")
        self.refused((*GLASS, *well, "--restitution", 1), "restitution e = 1", "no pair sticks")
        self.refused((*GLASS, *well, "--well-ratio", 0.99), "well = 0.99: must be a finite number not below 1")
        self.refused((*GLASS, *well, "--well-ratio", 4), "well = 4: must not be above 3")
        self.refused((*GLASS, "--law", "velcro"), "velcro")
        self.refused(("--percentiles", 3e-5, 2e-5, 4e-5, *GLASS[2:]), "d10 = 3e-05: must be below d50")
        self.refused(("--diameter", 5e-4, "--density", 2500, "--young", 63e9, "--poisson", 0.7), "Poisson's ratio = 0.7: must lie between 0 and 0.5")
        self.refused((*GLASS, *BED, "--void-fraction", 1.2), "void fraction = 1.2: must lie between 0 and 1")

    def test_values_in_other_units(self):
        """With the value, the unit of the option and what it would be in it."""
        rest = GLASS[4:]
        for words, option, *said in (
                (("--diameter", 75, "--density", 1500, *rest), "--diameter = 75", "in m", "--diameter 7.5e-05"),
                (("--diameter", 0.5, "--density", 1500, *rest), "--diameter = 0.5", "0.5 mm is meant: --diameter 0.0005"),
                (("--diameter", 75e-6, "--density", 2.5, *rest), "--density = 2.5", "in kg/m3", "--density 2500"),
                (("--percentiles", 20, 40, 80, *GLASS[2:]), "--percentiles = 20", "--percentiles 2e-05"),
                ((*GLASS[:4], "--young", 63), "--young = 63", "in Pa", "--young 6.3e+10"),
                ((*GLASS[:4], "--young", 63e9, "--hamaker", 65), "--hamaker = 65", "zJ", "--hamaker 6.5e-20"),
                ((*GLASS[:4], "--young", 63e9, "--surface-energy", 40), "--surface-energy = 40", "--surface-energy 0.04"),
                ((*GLASS, "--cutoff", 0.4, 100), "--cutoff = 0.4", "--cutoff 4e-10"),
                ((*GLASS, "--gas-viscosity", 18.2), "--gas-viscosity = 18.2", "--gas-viscosity 1.82e-05"),
                ((*GLASS, "--gas", "air", "--pressure", 2), "--pressure = 2", "--pressure 200000"),
                ((*GLASS, "--width", 50, "--depth", 50, "--height", 100), "--width = 50", "--width 0.05")):
            self.refused(words, option, *said)

    def test_soft_springs_leave_room_for_the_cut_off(self):
        self.refused((*GLASS, "--stiffness", 1e-3), "outer cut-off", "too small for the softened contact")
        found = program.values("--diameter", 1e-3, "--density", 2500, "--young", 2e11, "--hamaker", 1e-19, "--speed", 0.01)
        self.assertAlmostEqual(found["escape_over_material"], 1, delta=1e-9)

    def test_a_folder_with_files_is_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "mine").write_text("data")
            self.refused((*GLASS, *BED, "--write", folder), folder, "not empty")
            self.assertEqual([file.name for file in Path(folder).iterdir()], ["mine"])

    def test_an_engine_that_is_not_there(self):
        code, _, error = program.call(*GLASS, "--measure", "--lammps", "no-such-program")
        self.assertEqual(code, 0)
        self.assertIn("'no-such-program' did not run, so that nothing is measured", error)


class WrittenCase(unittest.TestCase):
    def test_springs_of_large_grains_bear_impacts(self):
        """5 mm: only the slowest impacts stick, and those of the run press Hertz's contact where it is stiffer."""
        words = ("--diameter", 5e-3, "--density", 2500, "--young", 63e9, "--poisson", 0.22, "--hamaker", 1e-19)
        found = program.values(*words)
        mass = 2500 * math.pi / 6 * 5e-3**3
        overlap = found["impact_speed"] * math.sqrt(mass / found["stiffness"])  # of a wall, without loss
        self.assertLess(overlap / 5e-3, 0.01 * 1.05)  # loss takes away a twentieth
        self.assertGreater(found["stiffness"], found["material_stiffness"])
        self.assertEqual(found["pull_off_over_material"], 1)
        _, text, error = program.call(*words)
        self.assertNotIn("material_stiffness", text)
        self.assertNotIn("press grains", error)
        _, _, error = program.call(*words[:5], 1e7, *words[6:])
        self.assertIn("m/s press grains of this Young's modulus by", error)

    def test_a_long_run_is_told(self):
        for diameter, long in ((1e-6, True), (5e-4, False)):
            with tempfile.TemporaryDirectory() as folder:
                case = Path(folder) / "case"
                _, _, error = program.call("--diameter", diameter, *GLASS[2:], *BED, "--grains", 600, "--write", case)
                self.assertEqual("particle steps of" in error, long, error)
                self.assertEqual("h for the particles, on one process" in error, long, error)

    def test_grains_are_those_of_the_distribution(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case"
            code, _, error = program.call("--diameter", 2e-4, 4e-4, "--mass-share", 1, 3, *GLASS[2:], *BED, "--grains",
                                          5000, "--gravity", 1.62, "--write", case)
            self.assertEqual(code, 0, error)
            self.assertIn("gravityOfPowder (0 0 -1.62);", (case / "constant/gravity").read_text())
            lines = (case / "grains.data").read_text().split("Atoms")[1].split("\n")
            grains = [list(map(float, line.split())) for line in lines if line]
            small, large = (sum(row[2] == d for row in grains) for d in (2e-4, 4e-4))
            self.assertLessEqual(small + large, 5000)
            self.assertGreater(small + large, 2000)
            # One grain of each may be rounded away.
            self.assertAlmostEqual(small / large, 1 / 3 * 8, delta=2 * 8 / 3 / large * 4)
            box = [float((case / "constant/powder").read_text().split(name)[1].split(";")[0])
                   for name in ("width", "depth", "top")]
            for row in grains:
                for place, edge in zip(row[4:], box):
                    self.assertTrue(0.5 * row[2] * 0.9 < place < edge - 0.5 * row[2] * 0.9, row)

    def test_it_ends_when_it_should_and_its_gas_is_that_of_its_drag(self):
        for words in (GLASS, ("--diameter", 75e-6, "--density", 1500, *GLASS[4:], "--drag", "wenYu")):
            found = program.values(*words, *BED)
            with tempfile.TemporaryDirectory() as folder:
                case = Path(folder) / "case"
                code, _, error = program.call(*words, *BED, "--grains", 1000, "--write", case)
                self.assertEqual(code, 0, error)
                entry = lambda file, name: (case / file).read_text().split(f"\n{name} ")[1].split(";")[0].strip()
                steps = [0.1 / float(entry("constant/powder", "gasStep")),
                         float(entry("constant/powder", "gasStep")) / float(entry("constant/grains", "dt"))]
                for count in steps:  # twelve digits are written
                    self.assertAlmostEqual(count, round(count), delta=1e-9 * count)
                self.assertIn("endTime         0.1;", (case / "system/controlDict").read_text())
                drag = entry("constant/coupling", "drag")
                self.assertEqual(drag, words[-1] if "--drag" in words else "beetstra")
                self.assertAlmostEqual(float(entry("constant/powder", "velocity")) / found[f"u_mf_{drag}"], 2, delta=1e-9)
                # Grains sink at the speed that the springs bear: m g/gamma.
                mass = words[3] * math.pi / 6 * words[1]**3
                gamma = float(entry("constant/grains", "slow").strip('"'))
                self.assertAlmostEqual(mass * G / gamma / found["impact_speed"], 1, delta=1e-5)

    def test_walls_of_square_wells_are_those_of_each_size(self):
        with tempfile.TemporaryDirectory() as folder:
            words = (*GLASS[2:], *BED, "--grains", 4000, "--law", "square_well", "--well-ratio", 1.1)
            case = Path(folder) / "case"
            code, _, error = program.call("--diameter", 2e-4, 4e-4, *words, "--write", case)
            self.assertEqual(code, 0, error)
            walls = (case / "constant/walls").read_text().split("\n")
            fixes = [line.split()[:4] for line in walls if line.startswith("fix")]
            self.assertEqual(fixes, [["fix", f"{name}_size_{k}", f"size_{k}", "wall/gran/squarewell"]
                                     for k in (1, 2) for name in ("side_x", "side_y", "plate")])
            self.assertEqual(sum(line.startswith("group size_") for line in walls), 2)
            # No grain begins in the well of another.
            lines = (case / "grains.data").read_text().split("Atoms")[1].split("\n")
            grains = [list(map(float, line.split()))[2:] for line in lines if line]
            for one, other in zip(grains, grains[1:]):
                self.assertGreater(math.dist(one[2:], other[2:]), 1.1 * 0.5 * (one[0] + other[0]))

    def test_a_column_has_them_inside(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "case"
            code, _, error = program.call(*GLASS, "--column", 0.02, "--height", 0.02, "--grains", 60000, "--write", case)
            self.assertEqual(code, 0, error)
            lines = (case / "grains.data").read_text().split("Atoms")[1].split("\n")
            grains = [list(map(float, line.split())) for line in lines if line]
            across = 12 * 1.5e-3  # whole cells, an even number
            solid = (1 - 0.42) * math.pi / 4 * across**2 * 0.02 / (math.pi / 6 * 5e-4**3)
            self.assertAlmostEqual(len(grains) / solid, 1, delta=1e-3)
            for row in grains:
                self.assertLess(math.hypot(row[4], row[5]), across / 2 - 0.5 * 5e-4)
            # A grain has a place of its own: two in a line are 1.05 of a diameter apart, 0.04 of which is noise.
            places = sorted((round(row[6] / 1e-5), row[4], row[5]) for row in grains)
            for one, other in zip(places, places[1:]):
                if one[0] == other[0]:
                    self.assertGreater(math.dist(one[1:], other[1:]), 1e-9)


if __name__ == "__main__":
    unittest.main()
