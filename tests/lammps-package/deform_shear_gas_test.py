# SPDX-License-Identifier: BSD-3-Clause
"""Gases under fix deform/shear: profile, temperature and stress, long runs, lists that miss no pair."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.sheared_script import BOX, DUMP, HEAD, RATE, Shear, dense_gas, spheres
from cohesion_tests.thermo import thermo_end, thermo_lines


class Profile(Shear):
    def test_profile_temperature_and_stress_are_those_of_the_particles(self):
        atoms = spheres(300, 3, speed=0.2)
        for number, atom in enumerate(atoms):
            atom["diameter"] = 0.5 + 0.5 * (number % 2)
        self.write(atoms)
        names = " ".join(f"c_flow[{k}]" for k in range(1, 11))
        output = self.run_script(
            HEAD % {"dimension": 3, "skin": "0.3"} + "pair_style zero 1.0\npair_coeff * *\n"
            f"fix shear all deform/shear rate {RATE}\nfix move all nve/sphere\n"
            "compute flow all shear/profile layers 5\nfix keep all ave/time 50 1 50 c_flow[*] "
            "mode vector file layers.txt format ' %.17g'\n" + DUMP % 50 +
            f"thermo 50\nthermo_style custom step c_flow {names}\n"
            "thermo_modify format float %.17g\ntimestep 0.01\nrun 200\n", ranks=2)
        mass = numpy.pi / 6 * numpy.array([atom["diameter"]**3 for atom in atoms])
        rows = thermo_lines(output)[1]
        self.assertEqual(len(rows), 5)
        for row, table in zip(rows, self.snapshots()):
            x, v = table[:, 1:4].copy(), table[:, 4:7].copy()
            count = numpy.floor(x[:, 1] / BOX[1])
            y = x[:, 1] - count * BOX[1] - BOX[1] / 2
            v[:, 0] -= count * RATE * BOX[1]
            slope, intercept = numpy.polyfit(y, v[:, 0], 1, w=numpy.sqrt(mass))
            away = v - (mass[:, None] * v).sum(axis=0) / mass.sum()
            away[:, 0] = v[:, 0] - intercept - slope * y
            flux = numpy.einsum("i,ij,ik->jk", mass, away, away)
            temperature = numpy.trace(flux) / 3 / mass.sum()
            stress = flux / BOX.prod()
            layer = numpy.floor((y / BOX[1] + 0.5) * 5)
            squares = [mass[layer == k].sum() * numpy.average(
                v[layer == k, 0] - intercept - slope * y[layer == k], weights=mass[layer == k])**2
                for k in range(5)]
            expected = [temperature, slope, intercept, temperature,
                        numpy.sqrt(sum(squares) / mass.sum()), *numpy.diag(stress), stress[0, 1],
                        stress[0, 2], stress[1, 2]]
            # A few hundred roundings of terms of order one.
            numpy.testing.assert_allclose(row[1:], expected, rtol=0, atol=1e-12)
        # The start: profile laid on, up to three standard errors of the slope of speeds of 0.2 over
        # heights that spread by 8/sqrt(12); no net momentum.
        self.assertLess(abs(rows[0][2] - RATE), 3 * 0.2 / numpy.sqrt(300) / 2.3)
        start = self.snapshots()[0]
        self.assertLess(numpy.abs((mass[:, None] * start[:, 4:7]).sum(axis=0)).max(), 1e-11)
        last = (self.path("layers.txt").read_text().splitlines())[-5:]
        table = numpy.array([[float(word) for word in line.split()] for line in last])
        self.assertLess(numpy.abs(table[:, 1] - numpy.arange(0.8, 8, 1.6)).max(), 0.5)
        self.assertAlmostEqual(table[:, 3].sum(), 1.0, 12)
        for k in range(5):
            self.assertAlmostEqual(table[k, 2], numpy.average(v[layer == k, 0],
                                                              weights=mass[layer == k]), 12)

    def test_fresh_and_later_runs(self):
        """Profile at the start only, not again in a later run nor after a restart."""
        self.write(spheres(50, 3, speed=0.2))
        head = HEAD % {"dimension": 3, "skin": "0.3"}
        tail = ("pair_style zero 1.0\npair_coeff * *\n"
                f"fix shear all deform/shear rate {RATE}\nfix move all nve/sphere\n"
                "compute flow all shear/profile\nthermo_style custom step c_flow[1] f_shear\n")
        output = self.run_script(head + tail + "run 0\nrun 0\nrun 10\nwrite_restart r\n")
        slope = thermo_end(output)["c_flow[1]"]
        self.assertLess(abs(slope - RATE), 0.1)
        again = self.run_script("plugin load ${plugin}\nread_restart r\n" + tail + "run 0\n")
        self.assertEqual(thermo_end(again), thermo_end(output))
        self.assertNotIn("added the profile", again)
        # Another ID is another shear.
        again = self.run_script("plugin load ${plugin}\nread_restart r\n" +
                                tail.replace("fix shear", "fix other").replace("f_shear", "f_other") +
                                "run 0\n")
        self.assertIn("added the profile", again)
        self.assertAlmostEqual(thermo_end(again)["c_flow[1]"], slope + RATE, 4)
        self.assertEqual(thermo_end(again)["f_other"], 0.0)


class TallBox(Shear):
    def test_the_speed_of_the_mean_flow_is_no_flight_past_a_contact(self):
        """gran/hamaker stops when particles fly too far for its list; that is what they fly past each
        other. Here the mean flow takes the topmost 0.04 in half a step, a new list allows for 0.024."""
        self.write([{"type": 1, "diameter": 1.0, "density": 1.0, "x": numpy.array([5.0, y, 3.0])}
                    for y in (0.5, 3.9, 7.5)])
        script = (HEAD % {"dimension": 3, "skin": "0.08"} +
                  "pair_style gran/hamaker\npair_coeff * * stiffness 800 restitution 0.9\n"
                  "fix shear all deform/shear rate 2.0 profile %s\nfix move all nve/sphere\n"
                  "timestep 0.01\nrun 20\n")
        self.run_script(script % "yes")
        code, output = engine.run_text(script % "no", self.folder)
        self.assertEqual(code, 1)  # at rest in space they do fly past each other
        self.assertIn("fly up to", output)


class LongRuns(Shear):
    def test_no_particle_is_lost_and_no_momentum_gained(self):
        """A dense gas with friction and adhesion over a strain of 16, flips and all."""
        self.write(dense_gas(6, 1.0))
        steps, dt = 8000, 0.002
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                output = self.run_script(
                    HEAD % {"dimension": 3, "skin": "0.3"} +
                    "pair_style gran/hamaker\npair_coeff * * stiffness 5000 restitution 0.8 friction "
                    "0.3 hamaker 1e-5 cutoff 1e-3 1e-2\nfix shear all deform/shear rate 1.0\n"
                    "fix move all nve/sphere\ncompute flow all shear/profile layers 4\n"
                    "variable py equal vcm(all,y)\n"
                    f"timestep {dt}\nthermo 100\nthermo_style custom step atoms f_shear v_py c_flow[1] "
                    "c_flow[2] c_flow[3] c_flow[4]\nthermo_modify format float %.15g\n"
                    f"run {steps}\n", ranks=ranks)
                names, rows = thermo_lines(output)
                table = dict(zip(names, numpy.array(rows).T))
                self.assertTrue((table["Atoms"] == 240).all())
                self.assertAlmostEqual(table["f_shear"][-1], steps * dt, 12)
                # Momentum is conserved but for rounding. A pair across a face is computed twice, from places that
                # differ by 2^-53 of 8: of a speed by 4e-13 in a step. Where a pair parts slowly the root of what its
                # energy account leaves makes it larger by one over that speed: 1e4 in the slowest of some 1e4 partings,
                # and ten times that where a load parts a taut contact, almost at rest. Over 240 spheres that is 2e-10.
                self.assertLess(numpy.abs(table["v_py"]).max(), 1e-9)
                # In the mean, the line is the one that the box asks for. The slope of one snapshot
                # varies by sqrt(12 T/N)/L_y, over a strain of 2 or so like over one snapshot.
                half = slice(len(rows) // 2, None)
                temperature = table["c_flow[3]"][half].mean()
                spread = numpy.sqrt(12 * temperature / 240) / BOX[1]
                self.assertLess(abs(table["c_flow[1]"][half].mean() - 1.0),
                                4 * spread / numpy.sqrt(4))


class Lists(Shear):
    def test_no_pair_is_missed(self):
        """Energy of a potential that ends with a jump, every step, against all pairs."""
        cut, dt, steps = 1.0, 0.01, 200
        # Lists grow old by the particles' own motion, and by the shear alone.
        for ranks, rate, speed in ((1, 2.0, 0.3), (2, -2.0, 0.01), (1, 2.0, 0.01)):
            with self.subTest(ranks=ranks, rate=rate, speed=speed):
                atoms = spheres(200, 3, speed=speed)
                self.write(atoms)
                output = self.run_script(
                    HEAD % {"dimension": 3, "skin": "0.5"} +
                    f"pair_style yukawa 1.0 {cut}\npair_coeff * * 1e-12\n"
                    f"fix shear all deform/shear rate {rate}\nfix move all nve/sphere\n" + DUMP % 1 +
                    f"timestep {dt}\nthermo 1\nthermo_style custom step pe xy\n"
                    f"thermo_modify norm no format float %.17g\nrun {steps}\n", ranks=ranks)
                energies = [row[1] for row in thermo_lines(output)[1]]
                for n, (table, energy) in enumerate(zip(self.snapshots(), energies)):
                    exact = 1e-12 * yukawa(table[:, 1:4], rate * n * dt * BOX[1], cut)
                    # Sums of 200 terms in another order.
                    self.assertLess(abs(energy / exact - 1), 1e-12, f"step {n}")
                builds = int(output.split("Neighbor list builds =")[1].split()[0])
                self.assertGreater(builds, 3)
                self.assertLess(builds, 100)


def yukawa(x, tilt, cut):
    """Sum over all pairs, images included."""
    d = x[None, :, :] - x[:, None, :]
    count = numpy.rint(d[..., 1] / BOX[1])
    d[..., 0] -= count * tilt
    d[..., 1] -= count * BOX[1]
    d[..., 0] -= BOX[0] * numpy.rint(d[..., 0] / BOX[0])
    d[..., 2] -= BOX[2] * numpy.rint(d[..., 2] / BOX[2])
    r = numpy.sqrt((d**2).sum(axis=2))[numpy.triu_indices(len(x), 1)]
    r = r[r < cut]
    return (numpy.exp(-r) / r).sum()


if __name__ == "__main__":
    unittest.main()
