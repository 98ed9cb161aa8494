# SPDX-License-Identifier: BSD-3-Clause
"""Faces of LAMMPS regions as walls of the soft styles: each acts as the plane that touches it at the nearest point."""
import math
import unittest

import numpy

from cohesion_tests import escape_table, lammps as engine
from cohesion_tests.region_shapes import HEAD, SHAPES, regions
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.pair_motion import CONTACT_TIME, CUT, DENSITY, DIAMETER, OUT
from cohesion_tests.theory.slow_ramp import Grain
from cohesion_tests.thermo import thermo_end


class Shapes(ScriptTestCase):
    """Spheres of one type each beside one face each, without pairs."""

    def run_shapes(self, spheres, contact, lines, style="gran/hamaker"):
        """spheres: shape, distance of the centre, speed towards the face, diameter, density; gives the gaps over the
        course."""
        atoms = []
        for shape, distance, speed, diameter, density in spheres:
            _, point, normal = SHAPES[shape]
            n = numpy.array(normal)
            atoms.append({"type": 1 + list(SHAPES).index(shape), "diameter": diameter, "density": density,
                          "x": numpy.array(point) + distance * n, "v": -speed * n})
        engine.write_spheres(self.folder, atoms, 3 * [(-0.06, 0.06)], len(SHAPES))
        text = HEAD.format(begin="read_data data.spheres", more=regions())
        text += "pair_style zero 1e-3\npair_coeff * *\n"
        for k in range(1, len(SHAPES) + 1):
            text += f"group g{k} type {k}\nfix w{k} g{k} wall/{style} {contact} region shape{k}\n"
        self.output = self.goes(text + lines)
        return numpy.array([[numpy.dot(x - SHAPES[s[0]][1], SHAPES[s[0]][2]) - s[3] / 2
                             for x, s in zip(snapshot[:, 1:4], spheres)]
                            for snapshot in engine.dumps(self.folder, "path.txt")])

    def test_capture(self):
        """At 0.999 of the escape velocity a sphere stays within H_cut, at 1.001 it passes it, at three phases of the
        step. The tangent plane does not turn, so the grade is the rounding's, below 1e-6."""
        law, strength = escape_table.LAWS[0], 7.49e-19
        escape = escape_table.escape_velocity(law, strength, 0)
        for division in (5, 16):
            dt = CONTACT_TIME / division
            spheres = [(shape, DIAMETER / 2 + 1.001 * OUT + phase * dt * escape, factor * escape, DIAMETER, DENSITY)
                       for shape in SHAPES for factor in (0.999, 1.001) for phase in (0.1, 0.4, 0.8)]
            gaps = self.run_shapes(spheres, law.lammps(strength, True), f"""
dump path all custom {5 * division} path.txt id x y z
dump_modify path format float %.17g sort id
fix move all nve/sphere
timestep {dt!r}
run {25 * division}
""")
            for sphere, gap in zip(spheres, gaps[-1]):
                with self.subTest(shape=sphere[0], division=division):
                    self.assertEqual(gap > 1.01 * CUT, sphere[2] > escape, f"gap {gap}")

    def test_strength(self):
        """A load that grows to 0.99 F_ad does not part a contact, one to 1.01 F_ad does; the ramp lags by 1.5e-3."""
        grain = Grain(50.0, 0.5)
        steps = grain.steps(10)
        for level in (0.99, 1.01):
            start = grain.diameter / 2 - grain.overlap_at_rest
            spheres = [(shape, start, 0.0, grain.diameter, 1500.0) for shape in SHAPES]
            ramp = f"{grain.force!r}*v_level*{level}"
            loads = ""
            for axis, letter in enumerate("xyz"):
                parts = "+".join(f"(type=={k})*({n[axis]!r})" for k, (_, _, n) in enumerate(SHAPES.values(), 1))
                loads += f"variable f{letter} atom {ramp}*({parts})\n"
            gaps = self.run_shapes(spheres, f"{grain.words} {grain.adhesion}", f"""
variable level equal (step<{steps})*step/{steps}+(step>={steps})
{loads}
fix load all addforce v_fx v_fy v_fz
dump path all custom {steps} path.txt id x y z
dump_modify path format float %.17g sort id
fix move all nve/sphere
timestep {grain.contact_time / 10!r}
run {steps + 100}
""")
            for sphere, gap in zip(spheres, gaps[-1]):
                with self.subTest(shape=sphere[0], level=level):
                    self.assertEqual(gap < 0.0, level < 1.0, f"gap {gap}")


R = 5e-4
MASS = DENSITY * 4 / 3 * math.pi * R**3
STIFFNESS = 800.0
DT = math.pi * math.sqrt(MASS / STIFFNESS) / 10
CONTACT = f"stiffness {STIFFNESS} restitution 1"
HAMAKER = "hamaker 5e-19 cutoff 4e-10 1e-7"
AT_REST = 5e-19 * R / (6 * 4e-10**2) / STIFFNESS  # overlap


class Motion(ScriptTestCase):
    def path(self, region, spheres, wall, steps, begin="", more="", every=1, ranks=1, style="gran/hamaker"):
        """spheres: place, velocity and spin of each; the columns id x y z vx vy vz omegax omegay omegaz."""
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": 2 * R, "density": DENSITY, "x": x, "v": v, "omega": w} for x, v, w in spheres],
            3 * [(-0.02, 0.02)], 1)
        self.output = self.goes(HEAD.format(begin=begin or "read_data data.spheres", more=region) + f"""
pair_style zero 1e-3
pair_coeff * *
fix w all wall/{style} {wall}
fix move all nve/sphere
{more}
timestep {DT!r}
dump path all custom {every} path.txt id x y z vx vy vz omegax omegay omegaz
dump_modify path format float %.17g sort id
thermo_style custom step atoms f_w[1] f_w[2] f_w[3] f_w[4] f_w[1][1]
thermo_modify format float %.17g
run {steps}
""", ranks=ranks)
        return numpy.array(engine.dumps(self.folder, "path.txt"))

    def cloud(self, count=30, speed=0.3, size=0.008):
        random = numpy.random.default_rng(7)
        return [(size * (2 * random.random(3) - 1), speed * (2 * random.random(3) - 1), 100 * random.random(3))
                for _ in range(count)]

    BLOCK = "region shape block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\n"
    PLANES = "xplane -0.01 0.01 yplane -0.01 0.01 zplane -0.01 0.01"

    def test_a_block_is_six_planes(self):
        """Of every law and scheme, with friction and rolling friction, at rest and moving: the same bits."""
        frictional = "friction 0.3 rolling_friction 0.05"
        laws = {"gran/hamaker": f"stiffness {STIFFNESS} restitution 0.8 {frictional} {HAMAKER}",
                "gran/squarewell": f"stiffness {STIFFNESS} restitution 0.8 {frictional} well 1e-9 1.2",
                "gran/liquidbridge": f"stiffness {STIFFNESS} restitution 0.8 {frictional} bridge 2e-4 5e-5",
                "gran/jkr": "normal hertz 5e6 0.25 restitution 0.8 friction 0.3 surface_energy 0.01"}
        for style, contact in laws.items():
            for more in ("", "scheme sampled", "translate y 0.02", "wiggle x 1e-4 2e-3")[::2 if "jkr" in style else 1]:
                with self.subTest(style, more=more):
                    found = []
                    for wall in ("region shape", self.PLANES):
                        path = self.path(self.BLOCK, self.cloud(), f"{contact} {wall} {more}", 6000, every=1000,
                                         style=style)
                        found.append((path, thermo_end(self.output)["f_w[1]"]))
                    numpy.testing.assert_array_equal(found[0][0], found[1][0])
                    self.assertLess(abs(found[0][1] - found[1][1]), 1e-12)
                    self.assertGreater((numpy.sign(found[0][0][-1][:, 4:7]) != numpy.sign(
                        found[0][0][0][:, 4:7])).sum(), 30)

    def test_energies_of_a_block_are_those_of_planes(self):
        """compute gran/energy: every number of it at every 500 steps. Friction does not change the velocity across the
        first face that a sphere touches: there the dashpot dissipates 1 - 0.8^2 of its energy. Among the samples is a
        contact: its adhesion is at least that at the gap H_cut."""
        energies, cloud = [], self.cloud()
        for wall in ("region shape", self.PLANES):
            self.path(self.BLOCK, cloud, f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 {HAMAKER} {wall}",
                      6000, every=1000,
                      more="compute e all gran/energy\nfix e all ave/time 500 1 500 c_e[*] file e.txt")
            energies.append(numpy.loadtxt(f"{self.folder}/e.txt"))
        numpy.testing.assert_array_equal(*energies)
        dissipated = 0.0
        for x, v, _ in cloud:
            times = (0.01 - R - numpy.sign(v) * x) / numpy.abs(v)
            if times.min() < (6000 - 20) * DT:
                dissipated += (1 - 0.8**2) * MASS * v[times.argmin()]**2 / 2
        self.assertGreater(dissipated, 0.0)
        self.assertGreater(energies[0][-1, 6], dissipated)
        self.assertLess(energies[0][:, 5].min(), -5e-19 * R / 6 * (1 / 4e-10 - 1 / 1e-7))

    def test_rest_in_a_corner(self):
        """Weight along the diagonal of two or three faces: each carries its component, as planes do."""
        g = numpy.array([-9.0, -5.0, -7.0])
        for down in (g, g * (1, 0, 1)):
            gravity = f"fix g all gravity {float(numpy.linalg.norm(down))!r} vector {down[0]} {down[1]} {down[2]}"
            start = -0.01 + R - MASS * numpy.abs(down) / STIFFNESS
            rests = []
            for wall in ("region shape", self.PLANES):
                rests.append(self.path(self.BLOCK, [(start, (0, 0, 0), (0, 0, 0))],
                                       f"stiffness {STIFFNESS} restitution 0.3 {wall}", 1000, more=gravity)[-1, 0])
                end = thermo_end(self.output)
                # Round-off of a place, 2e-18 m, times K.
                numpy.testing.assert_allclose([end[f"f_w[{k}]"] for k in (1, 2, 3)], MASS * down, rtol=0, atol=1e-13)
            numpy.testing.assert_array_equal(*rests)

    def test_round_an_edge(self):
        """A sphere that adheres slides, or rolls, around the edge of a block and goes on along the next face. The
        curvature begins and ends at once: swings of (m v^2/r)^2/(2 K), twice, and of these the amplitudes may add: 4
        times 7e-5 of the energy, half of that of the speed. The turn of a step, (v dt/r)^2, is 1e-5."""
        speed = 0.1
        block = "region shape block -0.01 0.01 -0.01 0.01 -0.01 0.01 side out units box\n"
        for friction, spin in (("", 0.0), ("friction 0.5", speed / (R - AT_REST))):
            with self.subTest(friction):
                path = self.path(block, [((0.008, 0.0, 0.01 + R - AT_REST), (speed, 0, 0), (0, spin, 0))],
                                 f"{CONTACT} {HAMAKER} {friction} region shape", 4000, every=500)
                x, v, w = path[-1, 0, 1:4], path[-1, 0, 4:7], path[-1, 0, 7:]
                self.assertAlmostEqual(x[0], 0.01 + R, delta=1e-6)
                self.assertLess(x[2], 0.008)
                self.check_speeds(v, -speed, 2, w, spin, 1)

    def check_speeds(self, v, speed, along, w, spin, about):
        """Between spin and velocity the spring of friction swings by the overlap over the radius, 7e-4 of the speed, at
        each of four changes of the load, and 5/2 of that in the spin."""
        def energy(velocity, turning):
            return velocity**2 / 2 + (R * turning)**2 / 5
        swing = 4 * AT_REST / R if spin else 1.5e-4
        self.assertAlmostEqual(v[along] / speed, 1.0, delta=swing)
        self.assertAlmostEqual(w[about], spin, delta=2.5 * swing * abs(spin))
        now = energy(numpy.linalg.norm(v), numpy.linalg.norm(w))
        self.assertAlmostEqual(now / energy(speed, spin), 1.0, delta=3e-4)

    def test_round_the_rim_of_an_open_cylinder(self):
        """From inside the wall to outside it, through its open end: its contact is one, and it comes back along the
        outside. As above."""
        speed = 0.1
        tube = "region shape cylinder y 0 0 0.01 -0.01 0.01 open 1 open 2 units box\n"
        for friction, spin in (("", 0.0), ("friction 0.5", speed / (R - AT_REST))):
            with self.subTest(friction):
                path = self.path(tube, [((0.01 - R + AT_REST, 0.008, 0.0), (0, speed, 0), (0, 0, -spin))],
                                 f"{CONTACT} {HAMAKER} {friction} region shape", 4500, every=500)
                x, v, w = path[-1, 0, 1:4], path[-1, 0, 4:7], path[-1, 0, 7:]
                self.assertAlmostEqual(x[0], 0.01 + R, delta=1e-6)
                self.assertLess(x[1], 0.008)
                self.check_speeds(v, -speed, 1, w, -spin, 2)

    def test_centre_in_the_plane_of_an_open_end(self):
        """A sphere beside it in the corner of the closed end has two contacts. The contact with the side is along x: a
        shift along the axis, which round-off does not change, leaves motion along x the same bits."""
        tube = "region shape cylinder z 0 0 0.01 -0.01 0.01 open 1 units box\n"
        side, still = 0.01 - R + 1e-6, (0, 0, 0)
        found = [self.path(tube, [((0, side, side), still, still), ((side, 0, z), still, still)],
                           f"{CONTACT} region shape", 5)[:, 1] for z in (-0.01, -0.01 + 1e-12)]
        numpy.testing.assert_array_equal(found[0][:, 1:3], found[1][:, 1:3])
        numpy.testing.assert_array_equal(found[0][:, 4:], found[1][:, 4:])
        numpy.testing.assert_array_equal(found[0][:, 3], -0.01)
        # From rest, after half the contact time: w0 times the overlap, towards the axis. Half a step later or earlier
        # the velocity has the factor cos(pi/20) = 0.988.
        speed = 1e-6 * math.sqrt(STIFFNESS / MASS)
        self.assertAlmostEqual(found[0][-1, 4] / speed, -1.0, delta=0.013)

    def test_oblique_in_a_barrel_as_in_a_zcylinder(self):
        """Both see the turning of the normal, v.dn/dt: of this one from two normals, at first order of the step, of
        the cylinder at the end of it. The difference, v^2 dt/r of the turning v^2/r, is a velocity of (v dt/r)^2 v."""
        tube = "region shape cylinder z 0 0 0.01 -0.02 0.02 units box\n"
        found = [self.path(tube, [((0.01 - R - 1e-6, 0, 0), (0.1, 0.2, 0.05), (0, 0, 0))],
                           f"{CONTACT} {wall}", 15) for wall in ("region shape", "zcylinder 0.01")]
        difference = numpy.abs(found[0][:, 0, 4:7] - found[1][:, 0, 4:7]).max()
        turned = 0.2 * DT / (0.01 - R)
        self.assertLess(difference, 15 * turned**2 * 0.2)
        # Angular momentum about the axis.
        x, v = found[0][-1, 0, 1:4], found[0][-1, 0, 4:7]
        self.assertLess(v[0], 0.0)
        self.assertAlmostEqual((x[0] * v[1] - x[1] * v[0]) / ((0.01 - R - 1e-6) * 0.2), 1.0, delta=1e-11)

    def test_keeps_its_speed_in_a_barrel_and_a_sphere(self):
        """Along a concave or a convex face a sphere that adheres keeps its speed: 3 turns of 6283 steps and more."""
        for shape, place, outwards in (("cylinder z 0 0 0.01 -0.02 0.02", 0.01 - R, ""),
                                       ("sphere 0 0 0 0.01", 0.01 - R, ""),
                                       ("sphere 0 0 0 0.01", 0.01 + R, "side out"),
                                       ("cylinder z 0 0 0.01 -0.02 0.02", 0.01 + R, "side out")):
            with self.subTest(shape, side=outwards):
                path = self.path(f"region shape {shape} {outwards} units box\n",
                                 [((place, 0, 0), (0, 0.1, 0), (0, 0, 0))],
                                 f"{CONTACT} {HAMAKER} region shape", 20000, every=5000)
                radius = numpy.linalg.norm(path[:, 0, 1:3], axis=1)
                speed = numpy.linalg.norm(path[:, 0, 4:7], axis=1)
                numpy.testing.assert_allclose(radius, place, rtol=0, atol=2e-6)
                numpy.testing.assert_allclose(speed, 0.1, rtol=1.5e-4)

    DRUM = "region shape cylinder y 0 0 0.01 -0.01 0.01 units box\n"
    WORDS = f"stiffness {STIFFNESS} restitution 0.3 friction 0.3 rolling_friction 0.05 {HAMAKER} region shape"
    GRAVITY = "fix g all gravity 9.81 vector 0 0 -1"

    def test_ranks_and_restart(self):
        """Two ranks, and a run continued from a restart file, with contacts along the wall: the same bits."""
        cloud = self.cloud(size=0.006)
        whole = self.path(self.DRUM, cloud, self.WORDS, 3000, more=self.GRAVITY, every=100)
        force = thermo_end(self.output)["f_w[3]"]
        numpy.testing.assert_array_equal(
            self.path(self.DRUM, cloud, self.WORDS, 3000, more=self.GRAVITY, every=100, ranks=2), whole)
        self.assertAlmostEqual(thermo_end(self.output)["f_w[3]"] / force, 1.0, delta=1e-12)
        self.path(self.DRUM, cloud, self.WORDS, "1500\nwrite_restart half.rest\n", more=self.GRAVITY)
        for ranks in (1, 2):
            path = self.path(self.DRUM, cloud, self.WORDS, 1500, begin="read_restart half.rest", more=self.GRAVITY,
                             every=100, ranks=ranks)
            numpy.testing.assert_array_equal(path[-1], whole[-1])
        for other in (self.DRUM.replace("0.01 -", "0.0101 -"), self.DRUM.replace("y 0 0", "y 0 0.0001"),
                      self.DRUM.replace("units", "open 1 units"), self.BLOCK):
            self.refused_restart(other, self.WORDS)
        self.refused_restart(self.DRUM, self.WORDS.replace("region shape", "zplane -0.01 NULL"), "0 walls and 1 regions with")

    def refused_restart(self, region, wall, words="another ID"):
        self.stops(HEAD.format(begin="read_restart half.rest", more=region) +
                   f"pair_style zero 1e-3\npair_coeff * *\nfix w all wall/gran/hamaker {wall}\n",
                   "fix w wall/gran/hamaker", "restart file", words)

    def test_a_lifted_cylinder(self):
        """It moves as seen from a frame that moves with it: rounding of places, 4e-18 m in each step, times w0."""
        steps = 1500
        tube = "region shape cylinder z 0 0 0.01 -0.01 0.01 open 1 open 2 units box\n"
        cloud = self.cloud(size=0.0064)
        still = self.path(tube, cloud, self.WORDS, steps, every=steps)[-1]
        lifted = [(x, numpy.array(v) + (0, 0, 0.05), w) for x, v, w in cloud]
        moving = self.path(tube, lifted, self.WORDS + " translate z 0.05", steps, every=steps)[-1]
        frame = numpy.array([0, 0, 0.05])
        numpy.testing.assert_allclose(moving[:, 1:4], still[:, 1:4] + steps * DT * frame, rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(moving[:, 4:7], still[:, 4:7] + frame, rtol=0, atol=1e-8)
        # A sphere that hits the side loses at least its velocity u into it. If it is not faster than u across the side,
        # it comes back after 0.3 u 2 (0.01 - R)/(u^2 + 0.09 u^2) = 0.0052 m/u: with adhesion 0.0044 at 0.05 m/s.
        hits = 0
        for (x, v, _), end in zip(cloud, still):
            (along, square), ahead = (x[:2] @ v[:2], v[:2] @ v[:2]), (0.01 - R)**2 - x[:2] @ x[:2]
            time = (math.sqrt(along**2 + square * ahead) - along) / square
            into = (x[:2] + time * v[:2]) @ v[:2] / (0.01 - R)
            if time < (steps - 20) * DT < time + 0.004 / into and into > max(0.05, math.sqrt(square / 2)):
                hits += 1
                self.assertGreater(numpy.linalg.norm(end[4:6] - v[:2]), into)
        self.assertGreater(hits, 3)


class Input(ScriptTestCase):
    FIX = f"fix w all wall/gran/hamaker {CONTACT} "

    def script(self, region, wall, boundary="f f f", places=((0.0, 0.0, 0.0),), run="run 1"):
        made = "".join("create_atoms 1 single {} {} {} units box\n".format(*place) for place in places)
        begin = f"region box block -0.02 0.02 -0.02 0.02 -0.02 0.02 units box\ncreate_box 1 box\n{made}"
        return HEAD.format(begin=begin, more=region).replace("boundary f f f", f"boundary {boundary}") + f"""
set group all diameter {2 * R} density {DENSITY}
pair_style zero 1e-3
pair_coeff * *
{self.FIX} {wall}
fix move all nve/sphere
timestep 1e-6
{run}
"""

    def refused(self, region, wall, *words, **options):
        with self.subTest(region, wall=wall):
            self.stops(self.script(region, wall, **options), "fix w wall/gran/hamaker", *words)

    def test_refused(self):
        sphere = "region shape sphere 0 0 0 0.01 units box\n"
        self.refused("", "region shape", "region shape does not exist", "before the fix")
        self.refused(sphere, "region", "specify the ID of a region")
        self.refused(sphere, "region shape region shape", "shape twice")
        self.refused(sphere, "region shape shear x 1", "shear", "translate")
        self.refused(sphere, "region shape zcylinder 0.01 translate x 1", "zcylinder moves along z only")
        self.refused(sphere + "region both union 2 shape box\n", "region both", "union", "several 'region' keywords")
        self.refused("variable a equal step*1e-3\nregion shape sphere 0 0 0 0.01 move v_a NULL NULL units box\n",
                     "region shape", "variables", "translate of this fix")
        self.refused("variable a equal 0.01\nregion shape sphere 0 0 0 v_a units box\n", "region shape", "variables")
        self.refused("region shape block -0.01 0.01 -0.01 0.01 -0.01 0.01 open 6 units box\n", "region shape",
                     "open faces", "xplane")
        self.refused("region shape cylinder z 0 0 0.01 -0.01 0.01 open 1 side out units box\n", "region shape",
                     "both sides", "side in")
        self.refused("region shape cone y 0 0 0.01 0.015 -0.01 0.01 units box\n", "region shape", "wrong direction",
                     "along x or z")
        self.refused(sphere, "region shape", "periodic direction z", "boundary f", boundary="f f p")
        self.refused("region shape cylinder z 0 0 0.01 -0.01 EDGE units box\n", "region shape",
                     "periodic direction z", "INF INF", boundary="f f p")
        self.goes(self.script("region shape cylinder z 0 0 0.01 INF INF units box\n", "region shape",
                              boundary="f f p"))

    def test_between_runs(self):
        sphere = "region shape sphere 0 0 0 0.01 units box\n"
        gone = "region shape delete\n"
        for between, words in ((gone, "does not exist"),
                               (gone + "region shape sphere 0 0 0 0.011 units box\n", "use a new fix ID")):
            self.stops(self.script(sphere, "region shape", run=f"run 1\n{between}run 1"), words, after_a_run=True)
        self.goes(self.script(sphere, "region shape", run=f"run 1\n{gone}{sphere}run 1"))
        tall = "region shape block 0 10 0 10 0 50 units box\n"  # in cm
        text = self.script(tall, "region shape", places=[(0.01, 0.01, 0.01)], run=f"run 1\n{gone}{tall}run 1")
        text = text.replace("units si", "units cgs")
        self.goes(text)
        self.stops(text.replace(f"{gone}{tall}", gone + tall.replace("50", "60")), "use a new fix ID", after_a_run=True)
        self.stops(self.script(sphere, "region shape", run='run 4 every 2 "region shape delete"'), "does not exist",
                   after_a_run=True)

    def test_a_particle_that_goes_through(self):
        """A slow load presses it beyond K r, from one side of an open region or from the other."""
        for faces, place, load in (("", 0.0094, 1), ("open 1 open 2", 0.0094, 1), ("open 1 open 2", 0.0106, -1)):
            text = self.script(f"region shape cylinder z 0 0 0.01 -0.01 0.01 {faces} units box\n", "region shape",
                               places=[(place, 0, 0)], run="timestep 1e-5\nrun 20000")
            text = text.replace(CONTACT, "stiffness 1 restitution 0.1").replace(
                "timestep", f"variable f equal {load}*1e-3*step/20000\nfix f all addforce v_f 0 0\ntimestep", 1)
            self.stops(text, "particle 1 went through 'region shape'", "larger stiffness", after_a_run=True)

    def test_warnings(self):
        sphere = "region shape sphere 0 0 0 0.01 units box\n"
        output = self.goes(self.script(sphere, "region shape", places=[(0.012, 0, 0), (0.0097, 0, 0)]))
        self.assertIn("Particle 1 at (0.012 0 0) is 0.002 behind 'region shape'", output)
        self.assertIn("define region shape with the other 'side' if they are to be in front of it", output)
        self.assertIn("Particle 2 at (0.0097 0 0) reaches 0.0002 into 'region shape'", output)
        self.assertNotIn("curvature", output)
        for side, place, words in (("", 0.0035, "curvature 0.004."), ("side out", 0.0045, "curvature 0.004.")):
            output = self.goes(self.script(f"region shape sphere 0 0 0 0.004 {side} units box\n", "region shape",
                                           places=[(place, 0, 0)], run="run 1\nrun 1"))
            self.assertEqual(output.count("curvature"), 1, output)
            self.assertIn(words, output)
        self.stops(self.script("region shape cone z 0 0 0.0008 0.01 -0.01 0.01 open 1 open 2 units box\n",
                               "region shape", places=[(0, 0, -0.0104)]), "radius of curvature", "wider region")
        self.stops(self.script("region shape sphere 0 0 0 0.0009 units box\n", "region shape",
                               places=[(1e-4, 0, 0)]), "radius of curvature 0.0009", "wider region")


if __name__ == "__main__":
    unittest.main()
