# SPDX-License-Identifier: BSD-3-Clause
"""Cohesion liquid_bridge in LIGGGHTS, both schemes: escape velocities of pairs and walls, what a broken
bridge takes, that nothing acts before the touch, and that a bridge goes from run to run, rank to rank
and through restart files."""
import math
import unittest

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import (DENSITY, MASS, RADIUS, STIFFNESS, capillary, contact, frames,
                                                  liquid_bridge, part, script, sphere)
from cohesion_tests.theory.liquid_bridge import FORCE, GAP, Capillary, escape_velocity, parting_speed
from cohesion_tests.theory.pair_motion import CONTACT_TIME, DAMPING, DIAMETER, MU

MODELS = "model hooke/stiffness tangential off cohesion liquid_bridge"
SETTINGS = " absolute_damping on tangential_damping off scheme "
PLANE = ("primitive type 2 xplane -8.5e-3", (), {})


def mesh(cells):
    """A square plate of 2 cells^2 triangles."""
    plate = rectangle((-8.5e-3, -9.5e-3, -9.5e-3), (0, 1.9e-2, 0), (0, 0, 1.9e-2), cells)
    return ("mesh n_meshes 1 meshes square", ["fix square all mesh/surface file square.stl type 2"],
            {"square.stl": stl(plate)})


def plate(scheme):
    return f"fix plate all wall/gran {MODELS} primitive type 2 xplane -9e-3{SETTINGS}{scheme}"


def ends(speeds, dt, steps, wall, scheme):
    """Gap and speed of parting at the end, of spheres that approach each other or a wall so fast, each
    with the share of a step by which it is late. A wall whose spring, dashpot and bridge are twice those
    of two spheres moves a sphere, of twice the reduced mass, as a pair."""
    spheres = []
    for n, (speed, late) in enumerate(speeds):
        gap = 1e-7 + speed * dt * late
        place = (-8.5e-3 + RADIUS + gap, -8.5e-3 + 1.7e-3 * (n % 10), -8.5e-3 + 1.7e-3 * (n // 10))
        if wall:
            spheres.append(sphere(place, (-speed, 0, 0)))
        else:
            spheres += [sphere((-8.5e-3, *place[1:]), (speed / 2, 0, 0)),
                        sphere((-8.5e-3 + DIAMETER + gap, *place[1:]), (-speed / 2, 0, 0))]
    shape, before, inputs = wall or ("", (), {})
    walls = [*before, f"fix plate all wall/gran {MODELS} {shape} {SETTINGS}{scheme}"] if wall else []
    end = frames(spheres, MODELS + SETTINGS + scheme, liquid_bridge(FORCE, GAP), dt=dt, steps=steps, every=steps,
                 contacts=contact(wall=2.0), skin=2e-4, walls=walls, inputs=inputs)[-1]
    if wall:
        return [(end[n][0] + 8.5e-3 - RADIUS, end[n][3]) for n in range(1, len(speeds) + 1)]
    return [(end[2 * n][0] - end[2 * n - 1][0] - DIAMETER, end[2 * n][3] - end[2 * n - 1][3])
            for n in range(1, len(speeds) + 1)]


class HeadOn(unittest.TestCase):
    def test_a_broken_bridge_takes_its_work(self):
        # A step after its rupture a pair must still be seen: 0.2 m/s at t_c/4 are less than 0.01 of a radius.
        speed = 0.2
        w = parting_speed(speed, FORCE, MU, DAMPING)
        left = math.sqrt(w**2 - 2 * FORCE * GAP / MU)
        for wall in (False, PLANE, mesh(1)):
            for scheme, division in (("exact", 4), ("exact", 50), ("sampled", 1000)):
                with self.subTest(wall=wall and wall[0], scheme=scheme, steps_per_contact=division):
                    dt = CONTACT_TIME / division
                    for _, parting in ends([(speed, p / 4) for p in range(4)], dt, 8 * division, wall, scheme):
                        # As above; sampled: the bridge pulls up to a step too long or too short where it forms and
                        # where it breaks, F dt/mu each, and the dashpot and the spring of the contact are taken
                        # up to a step late: 2 zeta w0 dt = 0.11/division and (w0 dt)^2/2 of the speed, at both ends.
                        room = 1e-10 if scheme == "exact" else 2 * FORCE * dt / MU + 2 * 0.12 / division * speed
                        self.assertAlmostEqual(parting, left, delta=room)

    def test_sampled_converges_to_the_same(self):
        # The same room, over the escape velocity: 1 % at t_c/400.
        escape, division = escape_velocity(), 400
        for wall in (False, PLANE):
            gaps = ends([(f * escape, p / 4) for f in (0.98, 1.02) for p in range(4)], CONTACT_TIME / division,
                        30 * division, wall, "sampled")
            self.assertEqual([gap > GAP for gap, _ in gaps], 4 * [False] + 4 * [True])

    def test_nothing_before_touch(self):
        # Passes within h_r, and runs that begin there: not a bit of the velocity changes.
        spheres = [sphere((0, 0, 0), (0, 0.05, 0)), sphere((DIAMETER + 0.3 * GAP, 0, 0), (0, -0.05, 0)),
                   sphere((0, 5e-3, 0)), sphere((DIAMETER + 0.5 * GAP, 5e-3, 0), (-1e-4, 0, 0)),
                   sphere((-9e-3 + RADIUS + 0.5 * GAP, -5e-3, 0), (0, 0.1, 0))]
        for scheme in ("exact", "sampled"):
            end = frames(spheres, MODELS + SETTINGS + scheme, liquid_bridge(FORCE, GAP), dt=CONTACT_TIME / 8, steps=80,
                         every=80, walls=[plate(scheme)])[-1]
            for n, given in enumerate(spheres, 1):
                self.assertEqual(tuple(end[n][3:6]), tuple(map(float, given["velocity"])), f"{scheme} {n}")


class Continued(unittest.TestCase):
    """A captured couple, a bead on a wall and a couple within h_r that never touched, in the middle of a run in which
    all are in the gap: the bridges that are there go on, and no other begins."""
    STEPS = 40

    def spheres(self):
        speed = 0.8 * escape_velocity()
        # The first couple across the border between two ranks.
        return [sphere((-DIAMETER / 2 - 1e-7, 0, 0), (speed, 0, 0)), sphere((DIAMETER / 2, 0, 0)),
                sphere((0, 5e-3, 0)), sphere((DIAMETER + 0.3 * GAP, 5e-3, 0), (1e-4, 0, 0)),
                sphere((-9e-3 + RADIUS + 1e-7, -5e-3, 0), (-speed, 0, 0))]

    def text(self, scheme, run):
        return script(self.spheres(), MODELS + SETTINGS + scheme, liquid_bridge(FORCE, GAP), dt=CONTACT_TIME / 8,
                      every=self.STEPS // 2, walls=[plate(scheme)], run=run,
                      contacts=contact(wall=2.0))

    def test_runs_ranks_and_restart(self):
        half = self.STEPS // 2
        for scheme in ("exact", "sampled"):
            whole = Run(self.text(scheme, f"run {self.STEPS}\n")).frames("out.txt")
            middle, end = whole[1], whole[-1]
            for gap in (middle[2][0] - middle[1][0] - DIAMETER, middle[5][0] + 9e-3 - RADIUS):
                self.assertGreater(gap, 0.05 * GAP, scheme)
                self.assertLess(gap, 0.95 * GAP, scheme)
            text = self.text(scheme, "")
            again = (text[:text.index("region box")] + "read_restart a.rest\n" +
                     text[text.index("neighbor "):text.index("create_atoms")] +
                     text[text.index("fix E all"):])
            for what, run, ranks in (
                    ("two runs", f"run {half}\nrun {half}\n", 0),
                    ("steps counted anew", f"run {half}\nreset_timestep {100 * half}\nrun {half}\n", 0), ("two ranks", f"run {self.STEPS}\n", 2),
                    ("two runs on two ranks", f"run {half}\nrun {half}\n", 2),
                    ("a restart file", f"run {half}\nwrite_restart a.rest\nclear\n{again}run {half}\n", 0)):
                with self.subTest(scheme=scheme, what=what):
                    other = Run(self.text(scheme, run), ranks=ranks).frames("out.txt")[-1]
                    for n in end:
                        # Roundings of 0.01 m, 1e-18 m, in 40 steps, and that over dt where an event puts a place.
                        for d in range(3):
                            self.assertAlmostEqual(other[n][d], end[n][d], delta=1e-14)
                            self.assertAlmostEqual(other[n][3 + d], end[n][3 + d], delta=1e-10)
            self.assertEqual(tuple(end[4][3:6]), (1e-4, 0.0, 0.0))


class Liquids(unittest.TestCase):
    """Bridges of a liquid; whether pairs stick with them: escape_test.py."""
    TENSION, ANGLE, VOLUME = 0.05, 0.6, 1e-13
    RADII = ((5e-4, 5e-4), (5e-4, 2.5e-4), (5e-4, math.inf))
    # Elastic: the dashpots of the properties are not on.
    CONTACT = contact(gamman=0.0)

    def spheres(self, overlap, speed=0.0, density=DENSITY):
        """Two pairs, and one at a plane at x = -9e-3, that part."""
        spheres = []
        for k, (radius, other) in enumerate(self.RADII[:2]):
            y, distance = -5e-3 + 3e-3 * k, radius + other - overlap
            spheres += [sphere((0, y, 0), (-speed / 2, 0, 0), radius=radius, density=density),
                        sphere((distance, y, 0), (speed / 2, 0, 0), radius=other, density=density)]
        return spheres + [sphere((-9e-3 + RADIUS - overlap, 5e-3, 0), (speed, 0, 0), density=density)]

    def gaps(self, frame):
        """Of a frame, with the number of the sphere that the force pulls to the left."""
        for k, radii in enumerate(self.RADII):
            if k < 2:
                yield 2 * k + 2, frame[2 * k + 2][0] - frame[2 * k + 1][0] - sum(radii)
            else:
                yield 5, frame[5][0] + 9e-3 - RADIUS

    def test_the_pull_is_the_published_curve(self):
        """Of equal and unequal spheres and a wall, so heavy that they are hardly slowed as their bridges open."""
        speed, dt, density = 0.02, 1e-5, 1e6
        for scheme in ("exact", "sampled"):
            settings = f"{MODELS} tangential_damping off scheme {scheme} capillary on"
            path = frames(self.spheres(1e-9, speed, density), settings,
                          capillary(self.TENSION, self.ANGLE, self.VOLUME), dt=dt, steps=330, every=1, skin=2e-4,
                          contacts=self.CONTACT,
                          walls=[f"fix plate all wall/gran {MODELS} primitive type 2 xplane -9e-3 "
                                 f"tangential_damping off scheme {scheme} capillary on"])
            for k, radii in enumerate(self.RADII):
                bridge = Capillary(self.TENSION, self.ANGLE, self.VOLUME, *radii)
                # Places are rounded by 2e-18 m, which exact puts over the step.
                rounding = density * math.pi / 6 * DIAMETER**3 * 4e-18 / dt**2 if scheme == "exact" else 0.0
                checked = 0
                for frame in path:
                    number, gap = list(self.gaps(frame))[k]
                    pull = -part(frame[number], "f")[0]
                    if gap > bridge.rupture + 2 * speed * dt:
                        self.assertAlmostEqual(pull, 0.0, delta=rounding)
                    if not 2 * speed * dt < gap < bridge.rupture - 2 * speed * dt:
                        continue
                    checked += 1
                    # exact puts the mean of the pull over two steps into one: F'' (v dt)^2/12 more, F'' below 7 F/L^2
                    # (at touch).
                    curved = 7 / 12 * (speed * dt)**2 / (bridge.volume / bridge.radius) * bridge.touch
                    room = 1e-9 * pull + rounding + (curved if scheme == "exact" else 0.0)
                    self.assertAlmostEqual(pull, bridge.force(gap), delta=room, msg=f"{scheme} {radii} {gap}")
                self.assertGreater(checked, 250)

    def test_a_bridge_carries_the_pull_of_touch(self):
        """Spheres that hang from a plane by bridges, of 0.98 and 1.02 of the weight that one carries, at rest where
        spring, bridge and weight balance; the heavy one at touch."""
        bridge = Capillary(self.TENSION, self.ANGLE, self.VOLUME, *self.RADII[2])
        g, factors = bridge.touch / MASS, (0.98, 1.02)
        spheres = [sphere((-9e-3 + RADIUS - max(1 - f, 1e-9) * bridge.touch / STIFFNESS, 3e-3 * n, 0),
                          density=f * DENSITY) for n, f in enumerate(factors)]
        for scheme in ("exact", "sampled"):
            settings = f" absolute_damping on tangential_damping off scheme {scheme} capillary on"
            end = frames(spheres, MODELS + settings, capillary(self.TENSION, self.ANGLE, self.VOLUME),
                         dt=CONTACT_TIME / 20, steps=4000, every=4000, skin=2e-4, boundary="m m m", walls=[
                             f"fix plate all wall/gran {MODELS} primitive type 2 xplane -9e-3" + settings,
                             f"fix g all gravity {g:.17g} vector 1 0 0"])[-1]
            self.assertLess(end[1][0] + 9e-3 - RADIUS, 0.0, scheme)
            self.assertGreater(end[2][0] + 9e-3 - RADIUS, bridge.rupture, scheme)

    def test_a_plane_pulls_twice_as_much_as_a_sphere_and_by_the_engines_own_model_it_does_not(self):
        """At touch, where each is 2 pi R gamma of the mean radius R."""
        def pulls(models, settings, properties):
            frame = frames(self.spheres(1e-9), models + settings, properties, contacts=self.CONTACT, walls=[
                f"fix plate all wall/gran {models} primitive type 2 xplane -9e-3" + settings])[0]
            return [-part(frame[number], "f")[0] + STIFFNESS * -gap for number, gap in self.gaps(frame)]

        equal, unequal, wall = pulls(MODELS, " tangential_damping off scheme sampled capillary on",
                                     capillary(self.TENSION, 0.0, self.VOLUME))
        # The spring's force is rounded at an overlap of 1e-9 m by 1e-18/1e-9 of 8e-7 N.
        self.assertAlmostEqual(equal, 2 * math.pi * RADIUS * self.TENSION, delta=1e-14)
        self.assertAlmostEqual(wall / equal, 2, delta=1e-9)
        self.assertAlmostEqual(unequal / equal, 2 / 3, delta=1e-9)
        # In per cent of the sphere's volume; half of a cap of each sphere makes the bridge.
        own = "".join(f"fix {name} all property/global {name} {value}\n" for name, value in {
            "surfaceLiquidContentInitial": "scalar 0.1", "surfaceTension": f"scalar {self.TENSION}",
            "fluidViscosity": "scalar 0", "contactAngle": "peratomtype 0 0",
            "minSeparationDistanceRatio": "scalar 0.01", "maxSeparationDistanceRatio": "scalar 1.1"}.items())
        equal, unequal, wall = pulls("model hooke/stiffness tangential off cohesion easo/capillary/viscous",
                                     " tangential_damping off", own)
        touch = 2 * math.pi * RADIUS * self.TENSION
        print(f"easo/capillary/viscous over 2 pi R gamma: equal {equal / touch:.3f}, "
              f"unequal {unequal / touch * 1.5:.3f}, plane {wall / touch / 2:.3f}")
        self.assertLess(wall / equal, 1.1)


class BadInput(unittest.TestCase):
    def test_values(self):
        for force, gap, message in ((-1e-4, 1e-5, "force F_b of the bridge = -0.0001"),
                                    (1e-4, -1e-5, "rupture gap h_r of the bridge = -1e-05"),
                                    (1e-4, 0.0, "must be greater than zero")):
            run = Run(script([sphere((0, 0, 0))], MODELS, liquid_bridge(force, gap)))
            assert_refused(self, run, "cohesion model liquid_bridge, atom types 1 and 1", message, "bridgeForce")

    def test_values_of_a_liquid(self):
        for tension, angle, volume, message in ((-0.07, 0, 1e-13, "surface tension gamma of the bridge = -0.07"),
                                                (0.07, 30, 1e-13, "must be in radians"),
                                                (0.07, 0, 0, "must be greater than zero")):
            run = Run(script([sphere((0, 0, 0))], MODELS + " capillary on", capillary(tension, angle, volume)))
            assert_refused(self, run, "cohesion model liquid_bridge, atom types 1 and 1", message, "bridgeVolume")

    def test_values_in_a_wrong_unit(self):
        """Spheres of R = 0.5 mm: V in m^3 is below 0.1 R^3 = 1.25e-11; 1e-3 is a volume in mm^3, and breaks at 0.1 m."""
        for settings, properties in ((" capillary on", capillary(0.07, 0, 1e-3)), ("", liquid_bridge(1e-4, 0.1))):
            with self.subTest(settings):
                run = Run(script([sphere((0, 0, 0))], MODELS + settings, properties))
                assert_refused(self, run, "cohesion model liquid_bridge, atom types 1 and 1",
                               "h_r of the bridge = 0.1: must not be above 0.0005", "check its unit")

    def test_a_wrong_unit_of_types_without_particles_and_of_a_wall(self):
        """Type 2 has no particles; the wall is of that type."""
        floor = f"fix floor all wall/gran {MODELS} primitive type 2 zplane -5e-3 capillary on scheme sampled"
        dry = capillary(0.07, 0, 1e-3).replace("bridgeSurfaceTension peratomtypepair 2 0.07 0.07 0.07",
                                               "bridgeSurfaceTension peratomtypepair 2 0.0 0.07 0.07")
        for walls, code in (((), 0), ((floor,), 1)):
            run = Run(script([sphere((0, 0, 0))], MODELS + " capillary on", dry, walls=walls))
            self.assertEqual(run.code, code, run.output[-2000:])
        assert_refused(self, run, "atom types 1 and 2: rupture gap h_r of the bridge = 0.1")

    def test_a_large_volume(self):
        for volume, warns in ((1.2e-11, 0), (1.3e-11, 1)):
            run = Run(script([sphere((0, 0, 0))], MODELS + " capillary on", capillary(1e-6, 0, volume), skin=1e-3,
                             run="run 1\nrun 1\n"))
            self.assertEqual(run.code, 0, run.output[-2000:])
            self.assertEqual(run.output.count("of the cube of the radius"), warns, run.output[-3000:])

    def test_missing_property(self):
        for missing in ("bridgeForce", "bridgeRuptureGap"):
            lines = [line for line in liquid_bridge(1e-4, 1e-5).splitlines() if missing not in line]
            assert_refused(self, Run(script([sphere((0, 0, 0))], MODELS, "\n".join(lines) + "\n")), missing,
                           "cohesion model liquid_bridge")


if __name__ == "__main__":
    unittest.main()
