# SPDX-License-Identifier: BSD-3-Clause
"""Walls act on their front side only: a sphere that comes through one from behind keeps its energy and feels it once it
has been clear of it. Spheres that a run begins with behind a wall, or with a wall through them, are named."""
import math
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.small_box import box
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.thermo import thermo_end

R, DENSITY, SPEED, DT = 5e-4, 2650.0, 1.0, 1e-5
MASS = DENSITY * 4 / 3 * math.pi * R**3
CONTACT = "stiffness 800 restitution 1"
LAWS = {"hamaker": "hamaker 5e-19 cutoff 4e-10 1e-7", "squarewell": "well 1e-10 1.05",
        "liquidbridge": "bridge 2e-4 5e-5"}
HAMAKER = "hamaker 5e-19 cutoff 4e-10 1e-7"
HARD = "pair_style hard/squarewell\npair_coeff * * restitution 1 well 1e-10 1.05\n"
SOFT = [f"wall/gran/{law} {CONTACT} {words} scheme {scheme}" for law, words in LAWS.items()
        for scheme in ("exact", "sampled")]
HARD_WALL = "wall/hard/squarewell restitution 1"
OVERLAY = f"wall/hamaker {HAMAKER}"
BEHIND, THROUGH = "with their centres behind a wall", "that a wall cuts through"


def script(wall, places, runs, velocity=(SPEED, 0.0, 0.0), head="", boundary="f f f", more=""):
    """`wall`: words of a fix behind its group."""
    pair = HARD if "/hard/" in wall else f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
    if wall.startswith("wall/gran"):
        law = next(law for law in LAWS if law in wall)
        scheme = wall.split("scheme ")[1].split()[0]
        pair = f"pair_style gran/{law} scheme {scheme}\npair_coeff * * {CONTACT} {LAWS[law]}\n"
    made = "".join("create_atoms 1 single {} {} {} units box\n".format(*place) for place in places)
    begun = head or (box(size=(0.2, 0.02, 0.02), boundary=boundary).replace("region box block 0 0.2 0 0.02 0 0.02",
                     "region box block -0.02 0.2 -0.02 0.02 -0.02 0.02") + made +
                     f"set group all diameter {2 * R} density {DENSITY}\n" +
                     "velocity all set {} {} {}\n".format(*velocity) + pair)
    return f"""{begun}
neighbor 3e-3 bin
{more}
fix side all {wall}
fix move all nve/sphere
variable x equal xcm(all,x)
variable vx equal vcm(all,x)
compute motion all ke
thermo_style custom step v_x v_vx c_motion
thermo_modify norm no format float %.17g lost error
timestep {DT}
{runs}
"""


class FromBehind(ScriptTestCase):
    """Sphere 1 at first 2 mm behind, flying through at 1 m/s; with springs that store what they are pressed with and
    attractions that give back what they took, nothing changes its energy: 600 sums of numbers of its size, 1e-13. Of
    sampled forces, whose energy depends on where in the contact the steps are, less than 5 % at 9 steps per contact."""

    def fly(self, wall, **options):
        # A mirror in front would be the same wall's other plane: it comes back to the lower one 3 times.
        return thermo_end(self.goes(script(wall, [(0.008, 0.005, 0.01)], "thermo 100\nrun 1800", **options)))

    def check(self, end, wall, low, high):
        sampled = "sampled" in wall
        energy = MASS * SPEED**2 / 2
        self.assertLess(end["c_motion"], energy * (1.05 if sampled else 1 + 1e-10))
        if "bridge" not in wall:  # which costs a rupture
            self.assertGreater(end["c_motion"], energy * (0.95 if sampled else 1 - 1e-10))
        self.assertGreater(end["v_x"], low - R)
        self.assertLess(end["v_x"], high + R)

    def test_planes(self):
        """After the way through the lower plane the sphere stays between both."""
        for wall in (*SOFT, HARD_WALL):
            with self.subTest(wall):
                self.check(self.fly(f"{wall} xplane 0.01 0.015"), wall, 0.01, 0.015)

    def test_an_upper_plane(self):
        for wall in (*SOFT[:2], HARD_WALL):
            with self.subTest(wall):
                output = self.goes(script(f"{wall} xplane 0.004 0.01",
                                          [(0.012, 0.005, 0.01)], "run 1800", velocity=(-SPEED, 0, 0)))
                self.check(thermo_end(output), wall, 0.004, 0.01)

    def test_a_cylinder_from_outside(self):
        for wall in (*SOFT[:2], HARD_WALL):
            with self.subTest(wall):
                output = self.goes(script(f"{wall} zcylinder 0.004", [(-0.006, 0.0, 0.01)], "run 1800"))
                self.check(thermo_end(output), wall, -0.004, 0.004)

    def test_a_wall_that_moves_over_a_sphere_at_rest(self):
        for wall in (*SOFT[1:3], HARD_WALL):
            with self.subTest(wall):
                end = thermo_end(self.goes(script(f"{wall} xplane 0.01 NULL translate x -1", [(0.008, 0.005, 0.01)],
                                                  "run 600", velocity=(0, 0, 0))))
                self.assertAlmostEqual(end["v_x"], 0.008, delta=1e-17)
                self.assertEqual(end["v_vx"], 0.0)

    def test_attraction_alone(self):
        """The sphere flies on; the attraction would have held it back with 5e-19 J R/(6 H_cut^2) over a radius, a tenth
        of its energy."""
        end = self.fly(f"{OVERLAY} xplane 0.01 NULL")
        self.assertEqual(end["v_vx"], SPEED)
        self.stops(script(f"{OVERLAY} xplane 0.01 NULL", [(0.012, 0.005, 0.01)], "run 1800", velocity=(-SPEED, 0, 0)),
                   "fix side wall/hamaker", "particle 1", "went through a wall", after_a_run=True)

    def test_stopped_half_way(self):
        """Between two runs, or in a restart file, while the wall cuts through the sphere; and where another process
        takes it over."""
        for wall in (SOFT[0], SOFT[3], OVERLAY):
            whole = self.fly(f"{wall} xplane 0.01 NULL")
            for half in (170, 230):
                with self.subTest(wall, half=half):
                    first = f"run {half}\nwrite_restart half.rest\n"
                    output = self.goes(script(f"{wall} xplane 0.01 NULL", [(0.008, 0.005, 0.01)],
                                              f"{first}run {1800 - half}"))
                    self.assertEqual(thermo_end(output)["v_x"], whole["v_x"])
                    self.assertEqual(output.count(BEHIND), 1)
                    head = "plugin load ${plugin}\nnewton off\nread_restart half.rest\ncomm_modify vel yes\n"
                    if wall == OVERLAY:
                        head += f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
                    output = self.goes(script(f"{wall} xplane 0.01 NULL", [], f"run {1800 - half}", head=head))
                    self.assertEqual(thermo_end(output)["v_x"], whole["v_x"])
                    self.assertNotIn(BEHIND, output)
                    self.assertNotIn(THROUGH, output)
            ranks = self.goes(script(f"{wall} xplane 0.01 NULL", [(0.008, 0.005, 0.01)], "run 1800", more=
                                     "balance 1.0 x 0.14"), ranks=2)
            self.assertEqual(thermo_end(ranks)["v_x"], whole["v_x"])


class AtSetUp(ScriptTestCase):
    """One message of each kind, before the run, with the number and the place of one of the spheres."""
    PLACES = [(0.012, 0.005, 0.01), (0.008, 0.006, 0.011), (0.0095, 0.005, 0.013), (0.0102, 0.005, 0.015)]

    def message(self, output, words):
        self.assertEqual(output.count(words), 1, output)
        text = next(line for line in output.splitlines() if words in line)
        self.assertLess(output.index(words), output.index("Loop time"))
        return text

    def test_planes(self):
        for wall in (*SOFT[::2], SOFT[1], HARD_WALL, OVERLAY):
            with self.subTest(wall):
                output = self.goes(script(f"{wall} xplane 0.01 NULL", self.PLACES, "run 1\nrun 1", velocity=(0, 0, 0)))
                text = self.message(output, BEHIND)
                for part in (f"fix side {wall.split()[0]}", f"{BEHIND}: 2.", "Particle 2 at (0.008 0.006 0.011)",
                             "0.002 behind 'xplane 0.01 NULL'", "'xplane NULL 0.01'"):
                    self.assertIn(part, text)
                text = self.message(output, THROUGH)
                for part in (f"fix side {wall.split()[0]}", f"{THROUGH}: 1.", "Particle 4 at (0.0102 0.005 0.015)",
                             "30 % of its diameter", "Move"):
                    self.assertIn(part, text)

    def test_a_cylinder_and_a_wall_that_has_moved(self):
        output = self.goes(script(f"{SOFT[0]} zcylinder 0.005", self.PLACES[:1], "run 1", velocity=(0, 0, 0)))
        self.assertIn("0.008 behind 'zcylinder 0.005'", self.message(output, BEHIND))
        wall = f"{SOFT[0]} xplane 0.005 NULL translate x 1"
        output = self.goes(script(wall, [(0.1, 0.0, 0.0)], "run 700\ncreate_atoms 1 single 0.008 0.006 0.011 units box\n"
                                  f"set group all diameter {2 * R} density {DENSITY}\nrun 1", velocity=(0, 0, 0)))
        self.assertIn("0.004 behind 'xplane 0.012 NULL'", next(line for line in output.splitlines() if BEHIND in line))

    def test_thousands_on_two_processes(self):
        """All of a lattice but those in front of the wall; of the number that has the lowest place."""
        atoms = [{"type": 1, "diameter": 2 * R, "density": DENSITY,
                  "x": (0.003 + 0.0015 * (n // 100), 0.0015 * (n // 10 % 10), 0.0015 * (n % 10))} for n in range(3000)]
        engine.write_spheres(self.folder, atoms, [(-0.02, 0.2), (-0.02, 0.02), (-0.02, 0.02)], 1)
        behind = sum(atom["x"][0] <= 0.0302 for atom in atoms)
        head = ("plugin load ${plugin}\nunits si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
                f"read_data data.spheres\npair_style gran/hamaker\npair_coeff * * {CONTACT}\n")
        for ranks in (1, 2):
            output = self.goes(script(f"{SOFT[0]} xplane 0.0302 NULL", [], "run 0", head=head), ranks=ranks)
            text = self.message(output, BEHIND)
            self.assertIn(f"{BEHIND}: {behind}. Particle 1 at (0.003 0 0)", text)

    def test_what_is_in_its_place_is_not_named(self):
        """A sphere that rests on the wall, and one that nothing moves; those of other groups; and between two runs one
        in the middle of an impact."""
        for wall in (*SOFT[::2], OVERLAY):
            rests = script(f"{wall} xplane 0.01 NULL", [(0.0104995, 0.005, 0.01), (0.005, 0.005, 0.01)], "run 1",
                           velocity=(0, 0, 0), more="group held id 2\nfix hold held freeze")
            with self.subTest(wall):
                output = self.goes(rests)
                self.assertNotIn(BEHIND, output)
                self.assertNotIn(THROUGH, output)
        for half in (50, 55):
            output = self.goes(script(f"{SOFT[0]} xplane 0.01 NULL", [(0.011, 0.005, 0.01)], f"run {half}\nrun 50",
                                      velocity=(-SPEED, 0, 0)))
            self.assertNotIn(THROUGH, output)


if __name__ == "__main__":
    unittest.main()
