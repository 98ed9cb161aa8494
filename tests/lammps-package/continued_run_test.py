# SPDX-License-Identifier: BSD-3-Clause
"""Runs of the exact scheme that go on from the forces of another: the motion, and the energy tally of compute
gran/energy that is first looked at on their first line."""
import math
import re
import sys
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.pair_motion import CONTACT_TIME, CUT, DIAMETER, MASS, OUT, STIFFNESS
from cohesion_tests.thermo import thermo_lines

DT = CONTACT_TIME / 20
R = DIAMETER / 2
SPEED = 0.05
SPLIT, STEPS = 9, 40  # in the middle of a contact
WELL = "well 1e-10 1.01"
HAMAKER = f"hamaker 7.49e-19 cutoff {CUT} {OUT}"
TANGENTIAL = 2 / 7 * STIFFNESS
ADHESION = 7.49e-19 * R / 6 / CUT**2  # force at a wall; half of that between spheres
FRICTION = "friction 0.3 rolling_friction 0.1"
CONTACT = f"stiffness {STIFFNESS} restitution 0.9"
PERIOD = 40 * DT
SPIN = numpy.array([300.0, 100.0, -200.0])

STORED = ["c_tally[3]", "c_tally[4]", "c_tally[12]", "c_tally[5]"]  # springs, of which two tangential; adhesion
MOTION = ["c_tally[1]", "c_tally[2]"]
LOST = ["c_tally[6]", "c_tally[7]", "c_tally[8]", "c_tally[13]"]

OVERLAY = (f"pair_style hybrid/overlay gran/hamaker squarewell\npair_coeff * * gran/hamaker {CONTACT} {HAMAKER}\n"
           "pair_coeff * * squarewell well 1e-10 1.01\n")


def scene(style, words, oblique=0.0, scheme="exact", walls="", x=5e-3):
    """Two spheres that touch after four steps, or with `walls` one below which they are."""
    way = 4 * DT * SPEED
    v = SPEED * numpy.array([1.0, oblique, 0.5 * oblique])
    atoms = [{"type": 1, "diameter": DIAMETER, "density": 2650.0, "omega": spin * oblique,
              "x": ((x + side * (R + way)) % 0.01, 5e-3, 5e-3), "v": -side * v}
             for side, spin in ((-1, SPIN), (1, 0.5 * SPIN))]
    if walls:
        atoms = [{**atoms[0], "x": (R + 2 * way, 5e-3, 5e-3), "v": -v}]
    pair = f"pair_style gran/{style} scheme {scheme}\npair_coeff * * {CONTACT} {words}\n"
    if walls:
        pair += f"fix w all wall/gran/{style} scheme {scheme} {CONTACT} {words} {walls}\n"
    return atoms, pair


class ContinuedRun(ScriptTestCase):
    def tally(self, pair, runs, ranks=1, head="read_data data.spheres", boundary="p p p",
             dt=DT):
        """The lines of the last run, by name, and the end of the motion. COMPUTE in `runs` begins the tally."""
        opened = ("compute tally all gran/energy\nthermo_style custom step c_tally[*]\n"
                  "thermo_modify norm no format float %.17g")
        output = self.goes(f"""
plugin load ${{plugin}}
units si
atom_style sphere
newton off
boundary {boundary}
{head}
comm_modify vel yes
neighbor 1e-4 bin
{pair}
fix move all nve/sphere
timestep {dt:.17g}
thermo 1
{runs.replace("COMPUTE", opened)}
write_dump all custom end.txt id x y z vx vy vz omegax omegay omegaz modify format float %.17g sort id
""", ranks=ranks)
        names, rows = thermo_lines(output)
        return dict(zip(names, numpy.array(rows).T)), engine.dump(self.folder, "end.txt")

    def check(self, atoms, pair, friction=False, boundary="p p p"):
        """What a tally has that begins between two runs, or after a restart, against one that was there
        from the start."""
        engine.write_spheres(self.folder, atoms, 3 * [(0.0, 0.01)], 1)
        whole, end = self.tally(pair, f"COMPUTE\nrun {STEPS}", boundary=boundary)
        whole = {name: values[SPLIT:] for name, values in whole.items()}
        rest = STEPS - SPLIT
        halves = f"run {SPLIT}\nCOMPUTE\nrun {rest}"
        self.tally(pair, f"run {SPLIT}\nwrite_restart restart.half", boundary=boundary)
        kinetic = MASS * SPEED**2
        # Places of 0.01 m, rounded to 2^-53, in some ten operations against a spring stretched by 2e-6 m at
        # most; twice that for the file.
        rounding = 20 * 2**-53 * 0.01 * STIFFNESS * 2e-6
        self.assertLess(rounding, 1e-6 * kinetic)
        ways = [("from the first run on", f"COMPUTE\nrun {SPLIT}\nrun {rest}", {}),
                ("between runs, after one of no steps", halves.replace("COMPUTE", "run 0\nCOMPUTE"), {}),
                ("restart", f"COMPUTE\nrun {rest}", {"head": "read_restart restart.half"})]
        if friction:
            ways.append(("between runs, two ranks", halves, {"ranks": 2}))
        for name, runs, options in ways:
            with self.subTest(name):
                tally, again = self.tally(pair, runs, boundary=boundary, **options)
                # The places' rounding, times pi/t_c a speed, over R a spin; a force that is lost makes 1 1/s.
                numpy.testing.assert_allclose(again, end, rtol=0,
                                              atol=20 * 2**-53 * 0.01 * math.pi / CONTACT_TIME / R)
                stored = numpy.array([tally[key] - whole[key] for key in STORED])
                moves = numpy.array([tally[key] - whole[key] for key in MOTION])
                room = numpy.full(4, rounding)
                if friction:
                    # Friction moves what the normal motion has left, along the plane of contact of mid-step:
                    # in the half step after the grid the normal turns by v dt/(2 R), and surfaces fly
                    # u dt/2; their places are known up to the product.
                    v = 3 * SPEED  # of either against the other, at most
                    turned = 0.25 * v * (v + 1.5 * R * numpy.linalg.norm(SPIN)) * DT**2 / R
                    room[:3] += [math.sqrt(2 * k * whole[key][0]) * turned
                                 for k, key in zip((STIFFNESS, TANGENTIAL, TANGENTIAL), STORED)]
                    room[3] += ADHESION * turned
                # What contacts have exchanged with other forces before the tally began is not in the springs: of
                # f for half a step each with b, below w0 v each.
                offset = stored[0, 1]
                self.assertLess(abs(offset), (math.pi * DT / CONTACT_TIME)**2 / 8 * kinetic)
                stored[0] -= offset
                self.assertTrue((abs(stored[:, 0]) < room).all(), (stored[:, 0], room))
                self.assertLess(abs(moves[:, 0]).max(), rounding)
                self.assertGreater(abs(numpy.array([whole[key][0] for key in STORED])).max(), 1e3 * rounding)
                # From the second line on all is as it was; the residual counts from the opening.
                self.assertLess(max(abs(stored[:, 1:]).max(), abs(moves[:, 1:]).max()), rounding)
                lost = numpy.array([tally[key] - whole[key] + whole[key][0] - tally[key][0] for key in LOST])
                self.assertLess(abs(lost).max(), rounding)
                missing = tally["c_tally[10]"] - tally["c_tally[10]"][0]
                self.assertLess(abs(missing - whole["c_tally[10]"] + whole["c_tally[10]"][0]).max(),
                                room.sum() + 4 * rounding)
        return whole

    def test_head_on(self):
        for name, options in (("hamaker", {"words": HAMAKER, "x": 0.0}), ("squarewell", {"words": WELL}),
                              ("hamaker", {"words": HAMAKER, "x": 0.0, "scheme": "sampled"})):
            with self.subTest(name, **options):
                self.check(*scene(name, **options))

    def test_well_over_a_contact(self):
        self.check(scene("hamaker", "")[0], OVERLAY)

    def test_with_friction(self):
        for name, words in (("hamaker", HAMAKER), ("squarewell", WELL)):
            with self.subTest(name):
                whole = self.check(*scene(name, f"{words} {FRICTION}", oblique=1.0, x=0.0), friction=True)
                for key in STORED:
                    self.assertNotEqual(whole[key][0], 0.0)

    def test_moving_walls(self):
        for words, oblique in ((HAMAKER, 0.0), (f"{HAMAKER} {FRICTION}", 1.0)):
            with self.subTest(words):
                self.check(*scene("hamaker", words, oblique, walls=f"xplane 0 NULL wiggle x 1e-7 {PERIOD:.17g}"),
                           friction=oblique > 0, boundary="f p p")

    def test_packing(self):
        """Where each sphere has up to six contacts: a tally that begins between two runs has what the splitting of
        one step leaves, second order in the step, of the energies of all springs and of the adhesion. Motion and tally
        then go on as if there had been no stop, to the last bit."""
        random = numpy.random.default_rng(3)
        places = R + 0.998 * DIAMETER * numpy.arange(6)
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": DIAMETER, "density": 2650.0, "x": x, "v": random.uniform(-SPEED, SPEED, 3),
             "omega": random.uniform(-50, 50, 3)}
            for x in numpy.array(numpy.meshgrid(places, places, places)).reshape(3, -1).T], 3 * [(0.0, 0.006)], 1)
        for friction in ("", FRICTION):
            words = f"{CONTACT} {HAMAKER} {friction}"
            pair = (f"pair_style gran/hamaker\npair_coeff * * {words}\nfix w all wall/gran/hamaker {words} "
                    "xplane 0 0.006 yplane 0 0.006 zplane 0 NULL\nfix g all gravity 9.81 vector 0 0 -1\n")
            apart = []
            for part in (5, 20):
                def after(runs):
                    lines, end = self.tally(pair, runs, boundary="f f f", dt=CONTACT_TIME / part)
                    return {name: values[-1] for name, values in lines.items()}, end

                (last, _), (first, _) = (after(f"COMPUTE\nrun {6 * part}\n{more}") for more in ("", "run 0"))
                whole, end = after(f"COMPUTE\nrun {12 * part}")
                for opened in ("COMPUTE", "COMPUTE\nrun 0"):
                    tally, again = after(f"run {6 * part}\n{opened}\nrun {6 * part}")
                    numpy.testing.assert_array_equal(again, end)
                    for key in STORED[1:] + MOTION:
                        self.assertEqual(tally[key], whole[key], (key, opened))
                    self.assertAlmostEqual(tally[STORED[0]], whole[STORED[0]],
                                           delta=(math.pi / part)**2 / 8 * whole[STORED[0]])
                for key in MOTION:
                    self.assertEqual(first[key], last[key])
                apart.append(sum(abs(first[key] - last[key]) for key in STORED) / last["c_tally[3]"])
                print(f"packing {friction}: t_c/{part}: {apart[-1]:.1e} of the springs", file=sys.stderr)
            # Between the 4 of first order and the 16 of second.
            self.assertLess(apart[1], apart[0] / 8)

    def test_outputs_at_set_up_are_those_of_the_last_step(self):
        """Forces, torques, pressure and energy of a packing between walls. Of a collision that is resolved within a step,
        the last friction force is not stored."""
        grains = "".join(f"create_atoms 1 single {x:.17g} {y:.17g} {z:.17g} units box\n" for x, y, z in numpy.array(
            numpy.meshgrid(*3 * [R + 0.998 * DIAMETER * numpy.arange(3)])).reshape(3, -1).T)
        dump = "write_dump all custom {} id fx fy fz tqx tqy tqz modify sort id format float %.17g\n"
        for scheme in ("exact", "sampled"):
            words = f"{CONTACT} {HAMAKER} {FRICTION if scheme == 'sampled' else ''}"
            with self.subTest(scheme):
                output = self.goes(f"""
plugin load ${{plugin}}
units si
atom_style sphere
newton off
comm_modify vel yes
boundary f f f
region box block 0 0.003 0 0.003 0 0.004 units box
create_box 1 box
{grains}set group all diameter {DIAMETER} density 2650
neighbor 1e-4 bin
pair_style gran/hamaker scheme {scheme}
pair_coeff * * {words}
fix walls all wall/gran/hamaker {words} xplane 0 NULL yplane 0 NULL zplane 0 NULL scheme {scheme}
fix weight all gravity 9.81 vector 0 0.1 -1
fix move all nve/sphere
timestep {CONTACT_TIME / 20!r}
thermo_style custom step press pe
thermo_modify format float %.12g
run 50
{dump.format("last.txt")}run 0
{dump.format("first.txt")}""")
                last, first = (engine.dump(self.folder, name)[:, 1:] for name in ("last.txt", "first.txt"))
                for part in (slice(0, 3), slice(3, 6)):
                    most = abs(last[:, part]).max()
                    self.assertTrue(most > 0.0 or scheme == "exact")
                    numpy.testing.assert_allclose(first[:, part], last[:, part], rtol=0, atol=1e-12 * most)
                *_, before, after = re.findall(r"^ *50 +(\S+) +(\S+) *$", output, re.MULTILINE)
                numpy.testing.assert_allclose([float(word) for word in after], [float(word) for word in before], rtol=1e-9)

    def test_range_that_a_script_changes(self):
        """Between two runs a law begins, becomes wider, or the box smaller: a pair that is in range then is held, and
        did not fall into it. Whether a tally is kept does not matter."""
        speed, before, after = 2.7e-3, 5, 20
        time = after * DT
        depth, width = 1e-11, 0.1 * DIAMETER
        # The surface attracts with the depth over its cut-off, 1e-6 m; the tail's energy is nearly as much.
        cut = 1e-6
        A = 6 * depth / (0.5 * R) * cut
        pull = depth / cut / (MASS / 2)
        wide = f"well {depth} 1.1"
        for name, scheme, first, then, gap in (
                ("squarewell", "exact", "well 0 1.1", wide, width - 2e-7),
                ("squarewell", "sampled", "well 0 1.1", wide, width - 2e-7),
                ("squarewell", "exact", "well 1e-13 1.01", wide, width - 2e-7),
                ("squarewell", "exact", wide, "", width + 1e-6),
                ("hamaker", "exact", "", f"hamaker {A:.17g} cutoff {cut} {10 * cut}", 0.5 * cut)):
            for parts in (1, -1):
                with self.subTest(name, scheme=scheme, first=first, then=then, parts=parts > 0):
                    engine.write_spheres(self.folder, [
                        {"type": 1, "diameter": DIAMETER, "density": 2650.0,
                         "x": (5e-3 + side * (R + 0.5 * gap), 5e-3, 5e-3), "v": (side * parts * 0.5 * speed, 0, 0)}
                        for side in (1, -1)], 3 * [(0.0, 0.01)], 1)
                    pair = f"pair_style gran/{name} scheme {scheme}\npair_coeff * * {CONTACT} "
                    # The shorter box brings the spheres nearer by 1.2e-6 m.
                    change = (f"pair_coeff * * {CONTACT} {then}" if then else
                              "change_box all x final 5.5e-6 0.0099945 remap units box")
                    runs = f"run {before}\n{change}\nrun {after}"
                    tally, end = self.tally(pair + first, "COMPUTE\n" + runs)
                    numpy.testing.assert_array_equal(self.tally(pair + first, runs)[1], end)
                    found = (end[0] - end[1])[4]
                    if name == "squarewell":
                        # One that parts turns round at the edge. Places of 0.01 m are rounded to 2^-53.
                        self.assertAlmostEqual(found, -speed, delta=1e-9 * speed)
                    else:
                        # A run goes on with the force of the step before it, of no law: that of one step is missing.
                        self.assertAlmostEqual(found, parts * speed - pull * time, delta=1.1 * pull * DT)
                    self.assertLess(tally["c_tally[5]"][-1], -0.9 * depth)

    def test_friction_that_is_taken_away_leaves_no_springs(self):
        atoms, pair = scene("hamaker", f"{HAMAKER} friction 0.3", oblique=0.5)
        engine.write_spheres(self.folder, atoms, 3 * [(0.0, 0.01)], 1)
        # A spring that begins anew has a stretch of two steps then, not of eight.
        first = "COMPUTE\nrun 12\n"
        again = "".join(f"pair_coeff * * {CONTACT} {HAMAKER} friction {friction}\nrun 2\n" for friction in (0, 0.3))
        before, after = (self.tally(pair, runs)[0]["c_tally[4]"][-1] for runs in (first, first + again))
        self.assertGreater(before, 1e-4 * MASS * SPEED**2)
        self.assertLess(after, (2.5 / 8)**2 * before)

    def test_another_box_keeps_what_a_wall_owes(self):
        # Touches in the middle of the ninth step, and leaves twenty steps later, at the speed with which it came.
        atoms, pair = scene("hamaker", "", walls="xplane 0 NULL")
        atoms[0]["x"] = (R + 8.5 * DT * SPEED, 5e-3, 5e-3)
        pair = pair.replace("restitution 0.9", "restitution 1")
        engine.write_spheres(self.folder, atoms, 3 * [(0.0, 0.01)], 1)
        for split in (7, 8, 9, 10, 27, 28, 29, 30):
            runs = f"run {split}\nchange_box all y final 0 0.0099 units box\nrun {40 - split}"
            with self.subTest(split):
                speed = self.tally(pair, runs, boundary="f p p")[1][0, 4]
                self.assertAlmostEqual(abs(speed), SPEED, delta=1e-9 * SPEED)

    def test_another_step(self):
        """In a contact that lasts, one force for the halves of two steps is right to second order. Where the contact
        begins in the step, as much of its spring is not seen."""
        w = math.pi / CONTACT_TIME
        atoms, pair = scene("hamaker", "", walls="xplane 0 NULL")
        atoms[0]["x"] = (R + 8.5 * DT * SPEED, 5e-3, 5e-3)
        pair = pair.replace("restitution 0.9", "restitution 1")
        engine.write_spheres(self.folder, atoms, 3 * [(0.0, 0.01)], 1)
        for part in (0.5, 2):
            second = (w * DT)**2 * (abs(part**2 - 1) / 6 + w * DT * (1 + part) / 24)
            errors = {False: 0.0, True: 0.0}
            for split in (7, 8, 9, 10, 14, 18, 23, 27, 28, 29, 30):
                runs = f"run {split}\ntimestep {part * DT:.17g}\nrun {math.ceil((40 - split) / part)}"
                at_end = split in (7, 8, 28)  # of the contact, its beginning or its end
                limit = 0.5 * (w * max(part, 1) * DT)**2 if at_end else second
                with self.subTest(part=part, split=split):
                    speed = self.tally(pair, runs, boundary="f p p")[1][0, 4]
                    self.assertAlmostEqual(speed / SPEED, 1.0, delta=limit)
                    errors[at_end] = max(errors[at_end], abs(speed / SPEED - 1))
            print(f"t_c/{CONTACT_TIME / DT:.3g} becomes t_c/{CONTACT_TIME / DT / part:.3g}: the speed errs by at most "
                  f"{errors[False]:.1e}, {errors[True]:.1e} where the contact begins or ends within a step of that")

    def edge(self, held=False):
        """Two spheres that meet the edge of a well after four steps and a half; `held`: one of them is. What they have
        beyond it is sqrt(2) times the speed of those that move."""
        width, depth = 0.1 * DIAMETER, MASS * SPEED**2 * (0.5 if held else 1.0)
        way = 4.5 * DT * SPEED
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": DIAMETER, "density": 2650.0, "v": (-side * SPEED * moves, 0, 0),
             "x": (5e-3 + side * (R + 0.5 * width + way * moves), 5e-3, 5e-3)}
            for side, moves in ((1, 1), (-1, not held))], 3 * [(0.0, 0.01)], 1)
        return (f"pair_style gran/squarewell %s\npair_coeff * * {CONTACT} %s well {depth:.17g} 1.1\n" +
                ("group second id 2\nfix hold second freeze\n" if held else ""))

    def check_edge(self, pair, runs, held=False, **options):
        end = self.tally(pair, runs, **options)[1]
        speeds = math.sqrt(2) * SPEED * numpy.array([1, not held])
        # Places of 0.01 m, rounded to 2^-53, in some twenty steps.
        numpy.testing.assert_allclose(abs(end[:, 4]), speeds, rtol=0, atol=20 * 2**-53 * 0.01 / (DT / 10))

    def test_another_step_keeps_the_impulse_of_an_edge(self):
        # A step is as long as the speed says, and shorter as soon as the well accelerates both.
        reset = f"fix reset all dt/reset 1 {DT / 10:.17g} {DT:.17g} {SPEED * DT:.17g}\nrun 16"
        for scheme, friction, held in (("", "", False), ("", "friction 0.3", True), ("scheme sampled", "", False)):
            pair = self.edge(held) % (scheme, friction)
            # A run of no step may come between, before the edge and after it.
            for runs in [f"run {split}\ntimestep {part * DT:.17g}\n{zero}run 10" for split in (3, 4, 5, 6)
                         for part in (0.5, 2) for zero in (("", "run 0\n") if split in (4, 5) else ("",))] + [reset]:
                with self.subTest(runs, scheme=scheme, held=held):
                    self.check_edge(pair, runs, held)

    def test_another_step_after_a_restart_keeps_it_too(self):
        pair = self.edge() % ("", "")
        for split in (4, 5):
            self.tally(pair, f"run {split}\nwrite_restart restart.edge noinit")
            for ranks in (1, 2):
                with self.subTest(split, ranks=ranks):
                    self.check_edge("", "run 10", head="read_restart restart.edge", dt=0.5 * DT, ranks=ranks)


if __name__ == "__main__":
    unittest.main()
