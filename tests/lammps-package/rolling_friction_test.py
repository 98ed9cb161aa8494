# SPDX-License-Identifier: BSD-3-Clause
"""Rolling friction of gran/hamaker and wall/gran/hamaker in LAMMPS, against closed forms; and
gravity in the energy book."""
import math
import sys
import unittest

import numpy

import couples
import lammps_engine as engine
from couples import CUT, DENSITY, DIAMETER, MASS, OUT, STIFFNESS
from gran_hamaker_couple_test import Box, T_C

RADIUS = DIAMETER / 2
INERTIA = 0.4 * MASS * RADIUS**2
G = 9.81
WALL_TIME = math.pi * math.sqrt(MASS / STIFFNESS)  # of a contact with a wall, no damping
DAMPING_RATE = -math.log(0.3) / WALL_TIME  # of the normal motion at a wall, restitution 0.3, or more
CONTACT = f"stiffness {STIFFNESS} restitution 0.3"
# A height of 5e-4 m is rounded by 5e-20 m, the overlap under the weight is 1.7e-8 m: 3e-12 of the
# load in each step, at random; a mean over a hundred steps and a few operations more.
ROUNDING = 1e-11


def report(text):
    print(text, file=sys.stderr)


class Rolling(unittest.TestCase):
    def setUp(self):
        keeper = engine.temporary_folder()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def run_spheres(self, atoms, dt, steps, every, box=((-0.02, 0.06), (-0.02, 0.02), (-0.01, 0.02)),
                    **options):
        """Snapshots (snapshot, atom, column from x on) and the thermo output by column."""
        engine.write_spheres(self.folder, atoms, box, 1)
        settings = {"start": "data", "boundary": "f f f", "skin": 2e-4, "scheme": "event",
                    "pair": "stiffness 800", "wall": "none", "gx": 0.0, "gy": 0.0, "gz": 0.0,
                    "sort": 0, "save": 0, **options}
        settings["walls"] = int(settings["wall"] != "none")
        self.output = engine.run("in.rolling", self.folder, dt=dt, steps=steps, every=every,
                                 **settings)
        names, lines = engine.thermo_lines(self.output)
        path = numpy.array(engine.dumps(self.folder, "path.txt"))[:, :, 1:]
        return path, dict(zip(names, numpy.array(lines).T))


def ball(height, v=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), x=0.0, y=0.0):
    return {"type": 1, "diameter": DIAMETER, "density": DENSITY, "x": (x, y, height), "v": v,
            "omega": spin}


class OnAPlane(Rolling):
    def roll(self, parts, coefficient, slope, speed, time, scheme="event"):
        """A ball that rolls down a plane of this slope along x from rest under its load; speeds at
        100 times in the second half of `time` [s]."""
        dt = WALL_TIME / parts
        angle = math.atan(slope)
        sunk = MASS * G * math.cos(angle) / STIFFNESS
        every = int(time / dt / 200) + 1
        path, thermo = self.run_spheres(
            [ball(RADIUS - sunk, (speed, 0.0, 0.0), (0.0, speed / RADIUS, 0.0))], dt, 200 * every,
            every, scheme=scheme, gx=G * math.sin(angle), gz=-G * math.cos(angle),
            wall=f"{CONTACT} friction 0.6 rolling_friction {coefficient} zplane 0 NULL")
        return every * dt * numpy.arange(100, 201), path[100:, 0], thermo

    def test_a_ball_is_slowed_at_5_7_mu_g(self):
        # m a = -T, I a/R = -(R mu_R m g - R T): a = mu_R g/(1 + 2/5). Springs have come to rest.
        for parts, scheme in ((3, "event"), (10, "event"), (50, "event"), (20, "sampled")):
            t, path, _ = self.roll(parts, 0.02, 0.0, 0.05, 0.1, scheme)
            slowed = numpy.polyfit(t, path[:, 3], 1)[0] / (-5 / 7 * 0.02 * G)
            turned = numpy.polyfit(t, RADIUS * path[:, 7], 1)[0] / (-5 / 7 * 0.02 * G)
            report(f"on a plane, t_c/{parts}, {scheme}: slowed at 5/7 mu_R g x (1 {slowed - 1:+.1e}), "
                   f"spin {turned - 1:+.1e}")
            # The speed is rounded alike in many steps, each time by half its last digit.
            rounding = ROUNDING + 0.05 * 2.0**-53 / (5 / 7 * 0.02 * G * WALL_TIME / parts)
            self.assertAlmostEqual(slowed, 1.0, delta=rounding)
            self.assertAlmostEqual(turned, 1.0, delta=rounding)
            self.assertEqual(numpy.abs(path[:, [4, 6, 8]]).max(), 0.0)

    def test_a_ball_comes_to_rest_after_v2_over_2a(self):
        speed, coefficient = 0.02, 0.05
        slowing = 5 / 7 * coefficient * G
        _, path, thermo = self.roll(10, coefficient, 0.0, speed, 3 * speed / slowing)
        way = speed**2 / (2 * slowing)
        # The rolling spring, R theta = mu_R m g/K_r, and the sliding one, less than that, are to be
        # stretched first and let go at the end.
        spring = coefficient * MASS * G / (2 / 7 * STIFFNESS)
        report(f"way until at rest: {path[-1, 0] / way - 1:+.1e} off v^2/(2 a), springs stretch by "
               f"{spring / way:.1e} of it")
        self.assertAlmostEqual(path[-1, 0], way, delta=4 * spring)
        # Springs and dashpots are at rest: 0.05 s are 400 contact times, of which each takes 1/e.
        self.assertLess(max(abs(path[-1, 3]), RADIUS * abs(path[-1, 7])), 2.0**-53 * speed)
        # All of the energy is lost, to rolling nearly: the sliding spring takes part in the last swing.
        energy = thermo["c_book[1]"][0] + thermo["c_book[2]"][0]
        lost = thermo["c_book[13]"][-1] - thermo["c_book[13]"][0]
        self.assertAlmostEqual(lost / energy, 1.0, delta=spring / way)

    def test_a_slope_holds_it_below_mu_r_and_not_above(self):
        coefficient = 0.1
        for slope in (0.05, 0.098, 0.102, 0.2):
            t, path, _ = self.roll(10, coefficient, slope, 0.0, 0.1)
            angle = math.atan(slope)
            excess = 5 / 7 * G * (math.sin(angle) - coefficient * math.cos(angle))
            fit = numpy.polyfit(t, path[:, 3], 1)[0]
            report(f"slope {slope} = {slope / coefficient:.2f} mu_R: acceleration {fit:.4g} m/s^2, "
                   f"5/7 g (sin - mu_R cos) = {excess:.4g}")
            if slope < coefficient:
                # The overshoot of the springs may have rolled it before; then it stays.
                self.assertLess(numpy.abs(path[:, 3]).max(), 1e-9)
            else:
                self.assertAlmostEqual(fit, excess, delta=ROUNDING * G)


    def test_a_plane_that_moves_is_one_at_rest_in_its_frame(self):
        dt, steps, speed, moves = WALL_TIME / 10, 2000, 0.05, 0.25
        found = []
        for wall_speed in (0.0, moves):
            path, _ = self.run_spheres(
                [ball(RADIUS - MASS * G / STIFFNESS, (speed + wall_speed, 0.0, 0.0),
                      (0.0, speed / RADIUS, 0.0))], dt, steps, steps // 100, gz=-G,
                wall=f"{CONTACT} friction 0.6 rolling_friction 0.02 zplane 0 NULL translate x {wall_speed}")
            found.append((path[:, 0, 3] - wall_speed, RADIUS * path[:, 0, 7]))
        self.assertLess(found[0][0][-1], speed - 0.9 * 5 / 7 * 0.02 * G * dt * steps)
        # Some ten operations with the speed of the ball in each step; springs hold what they add up to.
        for rest, moving in zip(*found):
            self.assertLess(numpy.abs(moving - rest).max(), 10 * steps * 2.0**-53 * (speed + moves))


class OnePair(Rolling):
    def test_a_pair_pressed_by_adhesion_loses_its_spin(self):
        # I w' = -R mu_R F_ad, R = r/2: equal spheres with opposite spins do not slide.
        A, coefficient, spin = 7.49e-19, 0.02, 40.0
        pull = couples.Pair(A).adhesion
        for scheme in ("event", "sampled"):
            dt = T_C / 20
            rate = 0.5 * RADIUS * coefficient * pull / INERTIA
            steps = int(0.9 * spin / rate / dt) // 100 * 100
            atoms = [ball(0.0, spin=(0.0, spin, 0.0)),
                     ball(0.0, spin=(0.0, -spin, 0.0), x=DIAMETER - pull / STIFFNESS)]
            path, thermo = self.run_spheres(
                atoms, dt, steps, steps // 100, scheme=scheme,
                pair=f"{CONTACT} friction 0.5 rolling_friction {coefficient} hamaker {A} "
                     f"cutoff {CUT} {OUT}")
            t = dt * steps / 100 * numpy.arange(101)
            for atom, sign in ((0, -1), (1, 1)):
                found = numpy.polyfit(t[10:], path[10:, atom, 7], 1)[0] / rate * sign
                report(f"pair, {scheme}: spin lost at R mu_R F_ad/I x (1 {found - 1:+.1e})")
                # The overlap is 2.4e-7 m of places of 1e-3 m.
                self.assertAlmostEqual(found, 1.0, delta=ROUNDING)
            numpy.testing.assert_allclose(path[:, 0, 7], -path[:, 1, 7], rtol=1e-12)
            energy = thermo["c_book[2]"][0]
            self.assertGreater(thermo["c_book[13]"][-1], 0.9 * energy)
            residual = numpy.abs(thermo["c_book[10]"]).max() / energy
            report(f"pair, {scheme}: energy book {residual:.1e}")
            self.assertLess(residual, 4 * 2.0**-53 * steps)

    def test_swings_at_the_closed_form(self):
        # R^2 (2/I) K_r = w^2, damped at eta_r/(2 m_r); the midpoint rule's phase is 2 atan(w dt/2)
        # per step, (w dt)^2/12 behind, its decay likewise.
        A, spin = 7.49e-19, 1e-3
        pull = couples.Pair(A).adhesion
        inverse_mass = (RADIUS / 2)**2 * 2 / INERTIA
        alpha = 0.25 * couples.DAMPING * inverse_mass
        frequency = math.sqrt(2 / 7 * STIFFNESS * inverse_mass)
        q = math.sqrt(frequency**2 - alpha**2)
        atoms = [ball(0.0, spin=(0.0, spin, 0.0)),
                 ball(0.0, spin=(0.0, -spin, 0.0), x=DIAMETER - pull / STIFFNESS)]
        errors = []
        for parts in (5, 10, 20, 40):
            dt = T_C / parts
            path, _ = self.run_spheres(
                atoms, dt, 4 * parts, 1,
                pair=f"stiffness {STIFFNESS} damping {couples.DAMPING} rolling_friction 10 "
                     f"hamaker {A} cutoff {CUT} {OUT}")
            # The grid's spin at n is the mean of two half steps, of second order.
            t = dt * numpy.arange(4 * parts + 1)
            exact = numpy.exp(-alpha * t) * (numpy.cos(q * t) - alpha / q * numpy.sin(q * t))
            errors.append(numpy.abs(path[:, 0, 7] / spin - exact).max())
            # Phase behind by w t (w dt)^2/12, t = 4 t_c; the mean of half steps 1 - (w dt)^2/8; the
            # first step's half window is of second order, too.
            self.assertLess(errors[-1],
                            (frequency * dt)**2 * (frequency * 4 * T_C / 12 + 1 / 8 + 1 / 4))
        report("pair, swings: errors at t_c/5 ... /40: " + ", ".join(f"{e:.1e}" for e in errors))
        self.assertLess(errors[3], errors[1] / 12)


class Impacts(unittest.TestCase):
    """Oblique impacts of spheres of two sizes, spinning, with friction and rolling friction."""

    def test_momentum_and_angular_momentum(self):
        box, without = Box(0.3, 6, rolling=0.2), Box(0.3, 6)
        scale = box.MASSES[0] * box.SPEED
        momentum = (box.MASSES[:, None] * box.v).sum(axis=2)
        self.assertLess(numpy.abs(momentum - momentum[0]).max(), 60 * 4 * 2.0**-53 * scale)
        orbital = numpy.cross(box.x - box.centre, box.v) * box.MASSES[:, None]
        total = (orbital + box.spin).sum(axis=2)
        drift = numpy.abs(total - total[0]).max()
        report(f"rolling impacts: angular momentum {drift / scale / DIAMETER:.1e} of m v d")
        self.assertLess(drift, 60 * 4 * 2.0**-53 * 30 * scale * DIAMETER)
        self.assertGreater(numpy.abs(box.spin[-1] - without.spin[-1]).max(), 1e-2 * scale * DIAMETER)

    def test_energy_book_is_of_first_order(self):
        # As with friction (gran_hamaker_couple_test): the angular impulse of rolling is below
        # R mu_R 2 mu (1 + e) v, and by n+1/2 a part v dt/(2 R) of it is along the normal. Friction
        # and rolling friction act on the same spins in turn: second order, and smaller here. Order 1 is
        # told from 1/2 by what lies between the factors of a fourfold step, 4 and 2.
        reach, residuals = 0.5 * Box.DIAMETERS.sum(), []
        for division in (4, 8, 16, 32):
            box = Box(0.3, division, rolling=0.2)
            residual = numpy.abs(box.book[10]).max()
            bound = 8 * (0.3 + 0.2) * Box.SPEED * T_C / division / (2 * reach) * box.energy
            report(f"rolling impacts, t_c/{division}: energy book {residual / box.energy:.1e} of all, "
                   f"{residual / bound:.2f} of the bound; lost in rolling "
                   f"{box.book[13][-1] / box.energy:.4f}")
            self.assertLess(residual, bound)
            self.assertGreaterEqual(numpy.diff(box.book[13]).min(), -box.rounding)
            self.assertGreater(box.book[13][-1], 1e-3 * box.energy)
            self.assertEqual(box.book[12][-1], 0.0)
            residuals.append(residual)
        self.assertGreater(residuals[1] / residuals[3], 4**0.75)


class Gravity(Rolling):
    def test_a_ball_thrown_up_that_bounces(self):
        # In flight the book closes to rounding. In contact gravity acts on the grid and not along
        # the path that the contact takes within the step. At an edge of contact the two differ by
        # up to v dt/4 (the impulse v m (1 + e) of the first or last step, at its middle), m g of
        # that in energy; four bounces have eight edges. Against m v^2/2: 4 g dt/v. What contact
        # and weight do to each other in between is second order.
        residuals = []
        for parts in (5, 10, 20, 40):
            dt = WALL_TIME / parts
            steps = int(0.1 / dt)
            path, book = self.run_spheres([ball(RADIUS + 1e-3, (0.01, 0.0, 0.05), (0.0, 3.0, 0.0))],
                                          dt, steps, 1, gz=-G,
                                          wall=f"stiffness {STIFFNESS} restitution 0.9 friction 0.3 "
                                               "zplane 0 NULL")
            v = path[:, 0, 5] + 0.5 * dt * path[:, 0, 11] / MASS
            height = path[:, 0, 2] + 0.5 * dt * v
            # A few roundings of m g z.
            numpy.testing.assert_allclose(book["c_book[11]"], MASS * G * height, rtol=1e-14)
            mechanical = sum(book[f"c_book[{k}]"] for k in (1, 2, 3, 4, 5, 11, 12))
            numpy.testing.assert_allclose(book["c_book"], mechanical, rtol=1e-14)
            energy = book["c_book"][0]
            flies = book["c_book[6]"] == 0.0  # before the first bounce
            self.assertGreater(flies.sum(), 10 * parts)
            self.assertLess(numpy.abs(book["c_book[10]"][flies]).max(),
                            8 * 2.0**-53 * flies.sum() * energy)
            # All forces but those of the contact and the weight: roundings of the work they do,
            # in a bounce twice the energy.
            self.assertLess(numpy.abs(book["c_book[9]"]).max(), 10 * 4 * 2.0**-53 * energy)
            residuals.append(numpy.abs(book["c_book[10]"]).max() / energy)
            bounces = (numpy.diff(numpy.sign(path[:, 0, 5])) > 0).sum()
            self.assertGreater(bounces, 2)
            report(f"thrown up, {bounces} bounces at t_c/{parts}: energy book {residuals[-1]:.1e}")
            impact = math.sqrt(0.05**2 + 2 * G * 1e-3)
            self.assertLess(residuals[-1], 4 * G * dt / impact)
        self.assertLess(residuals[3], residuals[0] / 8)

    def test_through_a_periodic_side(self):
        # Down a periodic direction the potential goes on falling.
        dt = WALL_TIME / 10
        path, book = self.run_spheres([ball(1e-3, (0.3, 0.0, 0.0))], dt, 4000, 100,
                                      box=((0.0, 0.004), (-0.02, 0.02), (-0.01, 0.02)),
                                      boundary="p p f", gx=G)
        t = dt * 100 * numpy.arange(41)
        v = path[:, 0, 3] + 0.5 * dt * G
        fallen = 0.3 * t + 0.5 * G * t**2
        self.assertGreater(fallen[-1], 0.008)
        numpy.testing.assert_allclose(book["c_book[11]"], -MASS * G * (fallen + 0.5 * dt * v),
                                      rtol=1e-12, atol=1e-14 * MASS * G)
        # The speed is rounded alike in many steps.
        self.assertLess(numpy.abs(book["c_book[10]"]).max(),
                        4000 * 2 * 2.0**-53 * book["c_book[1]"][-1])


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
        sunk = couples.Pair(A).adhesion / STIFFNESS
        spin = (0.0, 1.0, 0.0)
        engine.write_spheres(self.folder, [ball(0.0, spin=spin), ball(0.0, spin=spin, x=DIAMETER - sunk)],
                             3 * [(-0.01, 0.01)], 1)
        head = "plugin load ${plugin}\nunits si\natom_style sphere\nboundary f f f\nnewton off\n"
        words = (f"stiffness {STIFFNESS} restitution 0.9 friction 10 hamaker {A} cutoff {CUT} {OUT} "
                 "rolling_friction ")
        again = "comm_modify vel yes\nneighbor 1e-4 bin\n"
        move = (f"fix move all nve/sphere\ntimestep {T_C / 10:.17g}\ncompute book all gran/energy\n"
                "thermo 1\nthermo_style custom step c_book[4]\n")
        end = ("run 7\nwrite_dump all custom end.txt id x y z vx vy vz omegax omegay omegaz "
               "modify format float %.17g sort id\n")
        styles = (("gran/hamaker", "", ""), ("hybrid/overlay gran/hamaker square_well", "gran/hamaker ",
                                             "pair_coeff * * square_well 1e-30 1.0001\n"))
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
                    names, lines = engine.thermo_lines(output)
                    self.assertGreater(lines[1][names.index("c_book[4]")], 0.0)
                    tables.append(engine.dump(self.folder, "end.txt"))
                near(*tables)
                ends.append(tables[0])
        near(*ends)


class Input(Rolling):
    HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
create_atoms 1 single 0.002 0.005 0.005 units box
set group all diameter 1e-3 density 2650
neighbor 1e-4 bin
timestep 1e-6
pair_style gran/hamaker
"""
    MOVE = "\nfix move all nve/sphere\nrun 1\n"

    def ends(self, text, code, lines=False):
        found, output = engine.run_text(self.HEAD + text, self.folder)
        self.assertEqual(found, code, output)
        if lines:
            return output
        return " ".join(line for line in output.splitlines() if code == 0 or "ERROR" in line)

    def test_values(self):
        self.assertIn("rolling friction coefficient", self.ends(
            "pair_coeff * * stiffness 800 rolling_friction -0.1" + self.MOVE, 1))
        self.assertIn("rolling friction coefficient", self.ends(
            "pair_coeff * * stiffness 800\nfix w all wall/gran/hamaker stiffness 800 "
            "rolling_friction -1 zplane 0 NULL" + self.MOVE, 1))

    def test_gravity_of_a_variable_beside_the_pressure(self):
        """The engine works out a virial only in steps that were asked for before: who asks for the book must
        not make it forget that the pressure has to be asked for."""
        found = []
        for gravity in ("9.81", "v_g"):
            output = self.ends(
                "pair_coeff * * stiffness 800\nvariable g equal 9.81\n"
                f"fix weight all gravity {gravity} vector 0 0 -1\ncompute book all gran/energy\nthermo 3\n"
                "thermo_style custom step press c_book c_book[9] c_book[11]\n"
                "thermo_modify format float %.17g\nfix move all nve/sphere\nrun 10\n", 0, lines=True)
            found.append(engine.thermo_lines(output)[1])
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
