# SPDX-License-Identifier: BSD-3-Clause
"""Rolling friction of gran/hamaker and wall/gran/hamaker in LAMMPS on several ranks, in restart files, and refused."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine, refusals
from cohesion_tests.lammps_scenes import one_sphere
from cohesion_tests.lammps_scenes.rolling_balls import G, RADIUS, Rolling, ball, report
from cohesion_tests.lammps_scenes.unlike_couples import T_C
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import CUT, DIAMETER, OUT, STIFFNESS
from cohesion_tests.thermo import thermo_lines


class RanksAndRestart(Rolling):
    def packing(self):
        random = numpy.random.default_rng(815)
        grid = 5.5e-4 + 9.97e-4 * numpy.arange(5)  # overlapped from the start
        return [ball(x[2], random.uniform(-0.05, 0.05, 3), random.uniform(-80, 80, 3), x[0], x[1])
                for x in numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T]

    NUDGE = 1e-12  # [m]: far above rounding, far below what makes or ends a contact

    def room(self, atoms, whole, dt, steps, **settings):
        """What rounding may do to places, and to velocities with the spin times the radius: in each step to
        places 0.0052 m 2^-53 < 1e-18 m, in some ten operations, as much as a nudge of all places at the
        start does at the end."""
        random = numpy.random.default_rng(2)
        nudged = [{**atom, "x": numpy.array(atom["x"]) + random.uniform(-1, 1, 3) * self.NUDGE}
                  for atom in atoms]
        moved = numpy.abs(self.run_spheres(nudged, dt, steps, steps, **settings)[0][-1] - whole)
        each = 10 * steps * 1e-18 / self.NUDGE
        room = each * moved[:, :3].max(), each * max(moved[:, 3:6].max(), moved[:, 6:9].max() * RADIUS)
        report(f"room for rounding: {room[0]:.1e} m, {room[1]:.1e} m/s")
        # A wrong memory makes 1e-3 m/s.
        self.assertLess(room[1], 1e-6)
        return room

    def test_same_end(self):
        contact = f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 rolling_friction 0.1"
        planes = "xplane 0 0.0051 yplane 0 0.0051 zplane 0 NULL"
        # New lists all the time.
        settings = {"pair": contact, "wall": f"{contact} {planes}", "gz": -G, "skin": 2e-5,
                    "box": 3 * [(0.0, 0.0052)]}
        dt, steps = T_C / 10, 60
        whole = self.run_spheres(self.packing(), dt, steps, steps, **settings)[0][-1]
        self.assertGreater(numpy.abs(whole[:, 6:9]).max(), 1.0)
        smooth = {**settings, "pair": contact.replace("0.1", "0"),
                  "wall": settings["wall"].replace("rolling_friction 0.1", "")}
        other = self.run_spheres(self.packing(), dt, steps, steps, **smooth)[0][-1]
        self.assertGreater(numpy.abs(whole[:, 6:9] - other[:, 6:9]).max(), 1.0)
        room = self.room(self.packing(), whole, dt, steps, **settings)
        for name, options in (("two ranks", {"ranks": 2}), ("halves", {"save": 33}),
                              ("restart", {"start": "restart"}),
                              ("restart, two ranks", {"start": "restart", "ranks": 2})):
            end = self.run_spheres(self.packing(), dt, steps, steps, **{**settings, **options})[0][-1]
            difference = numpy.abs(end - whole)
            report(f"{name}: {difference[:, :3].max():.1e} m, {difference[:, 3:6].max():.1e} m/s, "
                   f"{difference[:, 6:9].max() * RADIUS:.1e} m/s of spin")
            # Sums in another order.
            self.assertLess(difference[:, :3].max(), room[0])
            self.assertLess(max(difference[:, 3:6].max(), difference[:, 6:9].max() * RADIUS), room[1])

    def test_pairs_that_come_back_the_other_way_round(self):
        # A packing that flies through a periodic box: particles change places in the engine's list,
        # and ranks, so that of a pair the other one comes first.
        atoms = self.packing()
        for atom in atoms:
            atom["v"] = atom["v"] + numpy.array([1.0, 0.3, 0.0])
        settings = {"pair": f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 rolling_friction 0.1 "
                            f"hamaker 7.49e-19 cutoff {CUT} {OUT}", "boundary": "p p p",
                    "box": 3 * [(0.0, 0.0052)]}
        dt, steps = T_C / 10, 200
        ends = [self.run_spheres(atoms, dt, steps, steps, **settings, **options)[0][-1]
                for options in ({}, {"sort": 5}, {"ranks": 2}, {"ranks": 2, "sort": 5})]
        room = self.room(atoms, ends[0], dt, steps, **settings)[1]
        for name, end in zip(("sorted", "two ranks", "two ranks, sorted"), ends[1:]):
            difference = numpy.abs(end - ends[0])[:, 3:9] * numpy.array(3 * [1.0] + 3 * [RADIUS])
            report(f"flying packing, {name}: {difference.max():.1e} m/s")
            self.assertLess(difference.max(), room)


class Ended(Rolling):
    def test_springs_survive_a_restart_after_rolling_has_ended(self):
        """A pair pressed by adhesion whose spheres turn the same way: the sliding spring swings. Rolling
        friction ends between two runs; the restart file is of the second. A well of no depth laid over it
        makes no difference."""
        A = 7.49e-19
        sunk = pair_motion.Pair(A).adhesion / STIFFNESS
        spin = (0.0, 1.0, 0.0)
        engine.write_spheres(self.folder, [ball(0.0, spin=spin), ball(0.0, spin=spin, x=DIAMETER - sunk)],
                             3 * [(-0.01, 0.01)], 1)
        head = "plugin load ${plugin}\nunits si\natom_style sphere\nboundary f f f\nnewton off\n"
        words = (f"stiffness {STIFFNESS} restitution 0.9 friction 10 hamaker {A} cutoff {CUT} {OUT} "
                 "rolling_friction ")
        again = "comm_modify vel yes\nneighbor 1e-4 bin\n"
        move = (f"fix move all nve/sphere\ntimestep {T_C / 10:.17g}\ncompute tally all gran/energy\n"
                "thermo 1\nthermo_style custom step c_tally[4]\n")
        end = ("run 7\nwrite_dump all custom end.txt id x y z vx vy vz omegax omegay omegaz "
               "modify format float %.17g sort id\n")
        styles = (("gran/hamaker", "", ""), ("hybrid/overlay gran/hamaker squarewell", "gran/hamaker ",
                                             "pair_coeff * * squarewell well 1e-30 1.0001\n"))
        # In 17 steps some ten roundings of places of 1e-3 m, 2e-19 m each, which a contact makes pi/t_c times
        # as many m/s; a spring that is lost makes 1e-4 m/s.
        room = 17 * 10 * 2e-19

        def near(one, other):
            difference = numpy.abs(one - other)
            self.assertLess(difference[:, 1:4].max(), room)
            self.assertLess(max(difference[:, 4:7].max(), difference[:, 7:].max() * RADIUS),
                            room * math.pi / T_C)

        ends = []
        for style, name, more in styles:
            with self.subTest(style):
                on, off = (f"pair_coeff * * {name}{words}{mu}\n{more}" for mu in (0.1, 0))
                tables = []
                for text in (f"{head}{again}read_data data.spheres\npair_style {style}\n{on}{move}run 5\n"
                             f"{off}run 5\nwrite_restart restart.ended noinit\n",
                             # A hybrid style keeps no coefficients in restart files.
                             f"{head}read_restart restart.ended\n{again}{off}{move}"):
                    code, output = engine.run_text(text + end, self.folder)
                    self.assertEqual(code, 0, output)
                    names, lines = thermo_lines(output)
                    self.assertGreater(lines[1][names.index("c_tally[4]")], 0.0)
                    tables.append(engine.dump(self.folder, "end.txt"))
                near(*tables)
                ends.append(tables[0])
        near(*ends)


class Input(Rolling):
    HEAD = one_sphere.HEAD + "timestep 1e-6\npair_style gran/hamaker\n"
    MOVE = "\nfix move all nve/sphere\nrun 1\n"

    def ends(self, text, code, lines=False):
        found, output = engine.run_text(self.HEAD + text, self.folder)
        self.assertEqual(found, code, output)
        if lines:
            return output
        return output if code == 0 else refusals.errors(output)

    def test_values(self):
        self.assertIn("rolling friction coefficient", self.ends(
            "pair_coeff * * stiffness 800 rolling_friction -0.1" + self.MOVE, 1))
        self.assertIn("rolling friction coefficient", self.ends(
            "pair_coeff * * stiffness 800\nfix w all wall/gran/hamaker stiffness 800 "
            "rolling_friction -1 zplane 0 NULL" + self.MOVE, 1))

    def test_gravity_of_a_variable_beside_the_pressure(self):
        """The engine works out a virial only in steps that were asked for before: who asks for the tally must
        not make it forget that the pressure has to be asked for."""
        found = []
        for gravity in ("9.81", "v_g"):
            output = self.ends(
                "pair_coeff * * stiffness 800\nvariable g equal 9.81\n"
                f"fix weight all gravity {gravity} vector 0 0 -1\ncompute tally all gran/energy\nthermo 3\n"
                "thermo_style custom step press c_tally c_tally[9] c_tally[11]\n"
                "thermo_modify format float %.17g\nfix move all nve/sphere\nrun 10\n", 0, lines=True)
            found.append(thermo_lines(output)[1])
        self.assertEqual([row[0] for row in found[0]], [0, 3, 6, 9, 10])
        self.assertEqual(*found)

    def test_cannot_begin_between_runs(self):
        on, off = (f"pair_coeff * * stiffness 800 rolling_friction {mu}" for mu in (0.1, 0))
        self.ends(f"{on}{self.MOVE}{off}\nrun 1\n{on}\nrun 1", 0)
        message = self.ends(f"{off}{self.MOVE}{on}\nrun 1", 1)
        self.assertIn("rolling_friction cannot begin here", message)

    def test_restart_file_without_rolling(self):
        self.ends("pair_coeff * * stiffness 800\n" + self.MOVE + "write_restart restart.none", 0)
        head = self.HEAD[:self.HEAD.index("region")]
        found, output = engine.run_text(
            head + "read_restart restart.none\nneighbor 1e-4 bin\n"
            "pair_coeff * * stiffness 800 rolling_friction 0.1" + self.MOVE, self.folder)
        self.assertEqual(found, 1, output)
        self.assertIn("rolling_friction cannot begin here", output)

    def test_a_stiff_rolling_spring_shortens_the_contact(self):
        # At a wall with friction: (3 + sqrt(6.5)) K_t/m against 7/2 K_t/m.
        def steps(words):
            output = self.ends(f"pair_coeff * * stiffness 800\nfix w all wall/gran/hamaker stiffness "
                               f"800 friction 0.3 {words} zplane 0 NULL" + self.MOVE, 0)
            row = output[output.index("1 - wall"):].split()
            return float(row[4])
        ratio = steps("") / steps("rolling_friction 0.1")
        self.assertAlmostEqual(ratio, math.sqrt((3 + math.sqrt(6.5)) / 3.5), delta=1e-3)


if __name__ == "__main__":
    unittest.main()
