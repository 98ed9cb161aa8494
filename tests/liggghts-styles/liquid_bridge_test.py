# SPDX-License-Identifier: BSD-3-Clause
"""Cohesion liquid_bridge in LIGGGHTS, both schemes: escape velocities of pairs and walls, what a broken
bridge takes, that nothing acts before the touch, and that a bridge goes from run to run, rank to rank
and through restart files."""
import math
import unittest

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import RADIUS, contact, frames, liquid_bridge, script, sphere
from cohesion_tests.theory.liquid_bridge import FORCE, GAP, escape_velocity, parting_speed
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


class BadInput(unittest.TestCase):
    def test_values(self):
        for force, gap, message in ((-1e-4, 1e-5, "force F_b of the bridge = -0.0001"),
                                    (1e-4, -1e-5, "rupture gap h_r of the bridge = -1e-05"),
                                    (1e-4, 0.0, "must be greater than zero")):
            run = Run(script([sphere((0, 0, 0))], MODELS, liquid_bridge(force, gap)))
            assert_refused(self, run, "cohesion model liquid_bridge, atom types 1 and 1", message, "bridgeForce")

    def test_missing_property(self):
        for missing in ("bridgeForce", "bridgeRuptureGap"):
            lines = [line for line in liquid_bridge(1e-4, 1e-5).splitlines() if missing not in line]
            assert_refused(self, Run(script([sphere((0, 0, 0))], MODELS, "\n".join(lines) + "\n")), missing,
                           "cohesion model liquid_bridge")


if __name__ == "__main__":
    unittest.main()
