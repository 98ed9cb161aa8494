# SPDX-License-Identifier: BSD-3-Clause
"""pair_style squarewell over contacts of LAMMPS: ranks, restarts, energy, refraction and input."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas, couples
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.lammps_scenes.square_well_scene import T_C, Gas, relative, report, well_speed
from cohesion_tests.theory.pair_motion import DAMPING, DIAMETER, MU, STIFFNESS
from cohesion_tests.thermo import thermo_lines


class Overlay(Gas):
    """pair_style squarewell over contacts of LAMMPS."""
    GAMMA = DAMPING / MU

    def style(self, friction):
        return (f"hybrid/overlay gran/hooke/history {STIFFNESS} {2 / 7 * STIFFNESS} {self.GAMMA:.17g} "
                f"NULL {friction} {int(friction > 0)} squarewell")

    def end(self, scheme, **options):
        # Without friction: LAMMPS' own style loses its history when hybrid is given again.
        atoms = self.write_gas() if options.get("mode") != "restart" else None
        return self.follow(atoms, ["* * gran/hooke/history", "1 1 squarewell well 2e-10 1.1",
                                   "2 2 squarewell well 1e-10 1.05", "3 3 squarewell well 1e-10 1.2",
                                   "1 3 squarewell well 1.4e-10 1.15", "1 2 squarewell well 1e-10 1.1",
                                   "2 3 squarewell well 1e-10 1.1"],
                           1e-5, 1000, ["fix w all wall/gran/squarewell stiffness 800 restitution 0.9 "
                                        "well 4e-10 1.1 zplane 0 0.0106",
                                        "fix g all gravity 9.81 vector 0 0 -1"], self.BOX,
                           boundary="p p f", style=self.style(0.0), **options)

    def test_ranks_and_restart(self):
        whole = self.end("")
        table, _ = gas.table(self.output)
        self.assertLess(table[-1, 1], -5e-10)
        for name, options in (("two runs", {"mode": "halves"}), ("2 ranks", {"ranks": 2}),
                              ("writes a restart file", {"mode": "restart_file"}),
                              ("restart", {"mode": "restart"})):
            other = self.end("", **options)
            numpy.testing.assert_array_equal(other[:, 0], whole[:, 0])
            difference = numpy.abs(other[:, 1:4] - whole[:, 1:4]).max()
            report(f"overlay, {name}: differs by {difference:.1e} m after 1000 steps")
            self.assertLess(difference, 1e-12)  # as for gran/squarewell

    def test_energy_of_an_impact(self):
        # Elastic contact, in and out of the well with D gained and lost: the speed is back. What the
        # contact style errs by itself, from couples without well that meet at the speed inside.
        depth, speed, dt, width = 5e-11, 0.02, T_C / 50, 1e-5
        inside = math.hypot(speed, well_speed(depth))
        found = []
        for v, lines, gap in ((speed, ["* * gran/hooke/history", f"* * squarewell well {depth} 1.01"],
                               width + 1e-7),
                              (inside, ["* * gran/hooke/history", "* * squarewell well 0 1.01"], 1e-7)):
            atoms = couples.couple(0, gap, (0.0, v, 0.0))
            style = f"hybrid/overlay gran/hooke/history {STIFFNESS} 228 0 NULL 0 0 squarewell"
            path, output = couples.run(atoms, lines, dt, 1000, every=1, style=style, skin=4e-4)
            out = relative(path[-1])[0, 4]
            found.append(out**2 + (2 * depth / MU if v == speed else 0.0))
            if v == speed:
                names, values = thermo_lines(output)
                pe = numpy.array(values).T[names.index("PotEng")]
                self.assertAlmostEqual(pe.min() / -depth, 1, delta=1e-12)
                self.assertEqual(pe[-1], 0.0)
        # The contacts begin at different places in the step, so that they err differently: leapfrog
        # is wrong by (w0 dt)^2/8 of the energy where the spring sets in and lets go.
        self.assertLess(abs(found[0] / found[1] - 1), 2 * (math.pi / 50)**2 / 8)

    def test_passes_without_contact_are_refracted(self):
        depth, ratio, speed, dt = 4e-11, 1.2, 0.05, T_C / 4
        edge, n = ratio * DIAMETER, math.sqrt(1 + 2 * 4e-11 / MU / 0.05**2)
        offsets = [n * DIAMETER + share * (edge - n * DIAMETER) for share in (0.01, 0.5, 0.99)]
        atoms = []
        for offset in offsets:
            along = math.sqrt(edge**2 - offset**2) + 1e-5
            distance = math.hypot(offset, along)
            atoms += couples.couple(len(atoms) // 2, distance - DIAMETER, (0.0, speed, 0.0),
                                    normal=(offset / distance, along / distance, 0.0),
                                    pitch=(4e-3, 6e-3))
        lines = ["* * gran/hooke/history", f"* * squarewell well {depth} {ratio}"]
        steps = int(2.2 * edge / speed / dt)
        path, _ = couples.run(atoms, lines, dt, steps, style=self.style(0.0), skin=1e-3,
                              size=(0.03, 0.01, 0.004))
        out = relative(path[-1])[:, 3:5]
        for offset, turned in zip(offsets, numpy.arctan2(-out[:, 0], -out[:, 1])):
            slope = 2 / math.sqrt(1 - (offset / edge)**2)
            expected = 2 * (math.asin(offset / edge) - math.asin(offset / n / edge))
            # Rounding, and the turning of a straight flight between grid points: each of the two
            # impulses puts the distance up to a quarter of it times dt off.
            self.assertLess(abs(turned - expected),
                            5 * math.sqrt(4 * steps) * 2e-18 / edge * slope
                            + 0.5 * speed * offset / edge**3 * math.sqrt(2 * depth / MU) * dt**2)

    def test_without_depth_nothing_acts(self):
        # Each has one partner: the order of neighbours can change nothing.
        contact = f"gran/hooke/history {STIFFNESS} 228 {self.GAMMA:.17g} NULL 0 0"
        atoms = [atom for k in range(8) for atom in couples.couple(k, (k - 4) * 1e-6, (0.0, 0.02, 0.0))]
        paths = [couples.run(atoms, lines, T_C / 50, 100, style=style, skin=4e-4)[0]
                 for lines, style in ((["* *"], contact),
                                      (["* * gran/hooke/history", "* * squarewell well 0 1.01"],
                                       f"hybrid/overlay {contact} squarewell"))]
        numpy.testing.assert_array_equal(paths[1], paths[0])

    def test_without_depth_there_is_no_list(self):
        """Of all D = 0 none is made, and no step is too long, unless something asks which pairs are bound; LAMMPS
        prints for which styles it makes lists."""
        asks = "fix clusters all agglomerates 1\n"
        for depth, fix, listed in ((0.0, "", False), (1e-11, "", True), (0.0, asks, True)):
            code, output = engine.run_text(HEAD + f"pair_style {self.style(0.0)}\npair_coeff * * gran/hooke/history\n"
                                           f"pair_coeff * * squarewell well {depth} 1.01\n" + fix + MOVE, self.folder)
            self.assertEqual(code, 0, output)
            self.assertIn("pair gran/hooke/history", output)
            self.assertEqual("pair squarewell" in output, listed, output)

    def test_depth_that_is_given_later(self):
        """Pairs are then where they are: one in the well has to climb out, one outside falls in, one
        that parts outside flies on; in the same input and from a restart file."""
        depth, speed, dt = 5e-11, 0.02, T_C / 50
        atoms = [atom for k, (gap, v) in enumerate(((4e-6, -speed), (1.1e-5, speed), (1.1e-5, -speed)))
                 for atom in couples.couple(k, gap, (0.0, v, 0.0))]
        start, deeper = (f"pair_style {self.style(0.0)}\npair_coeff * * gran/hooke/history\n"
                         "pair_coeff * * squarewell well 0 1.01\nfix move all nve/sphere\n",
                         f"pair_coeff * * squarewell well {depth} 1.01\n")
        engine.write_spheres(self.folder, atoms, [(0.0, 0.064), (0.0, 0.01), (0.0, 0.004)], 1)
        head = ("plugin load ${plugin}\nunits si\natom_style sphere\nnewton off\ncomm_modify vel yes\n",
                f"neighbor 4e-4 bin\ntimestep {dt!r}\n")
        # 160 steps out of the well, or 30 to its edge and 220 to the contact.
        end = "run 236\nwrite_dump all custom end.txt id x y z vx vy vz modify format float %.17g sort id\n"
        first = head[0] + "read_data data.spheres\n" + head[1] + start + "run 4\n"
        again = (head[0] + "read_restart rest\n" + head[1] +
                 "pair_coeff * * gran/hooke/history\nfix move all nve/sphere\n")
        for texts in ([first + deeper + end], [first + "write_restart rest\n", again + deeper + end]):
            for text in texts:
                code, output = engine.run_text(text, self.folder)
                self.assertEqual(code, 0, output[-2000:])
            out = engine.dump(self.folder, "end.txt")[:, 1:].reshape(3, 2, 6)
            squared = relative(out)[:, 4]**2
            # Impulses lead from place to place: some four roundings of both places, over dt.
            rounding = 4 * 2 * 2**-53 * 0.064 / dt
            numpy.testing.assert_allclose(squared, speed**2 + 2 * depth / MU * numpy.array([-1, 1, 0]), rtol=0,
                                          atol=2 * math.sqrt(speed**2 + 2 * depth / MU) * rounding)

    def test_input(self):
        for text, expected in (
                ("squarewell scheme exact\npair_coeff * * well 1e-11 1.1", ("no keywords", "scheme")),
                ("squarewell\npair_coeff * * well 1e-11", ("needs 'well D ratio': ratio is missing",)),
                ("squarewell\npair_coeff * * D 1e-11", ("'D'", "well")),
                ("squarewell\npair_coeff * * well 1e-11 0.9", ("ratio r_out/r", "0.9")),
                ("squarewell\npair_coeff * * well 1e-11 1.1 3", ("'3'",))):
            code, output = engine.run_text(HEAD + "pair_style " + text + MOVE, self.folder)
            self.assertEqual(code, 1, output)
            for word in expected:
                self.assertIn(word, output)


if __name__ == "__main__":
    unittest.main()
