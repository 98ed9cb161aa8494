# SPDX-License-Identifier: BSD-3-Clause
"""compute gran/stress: pairs pressed together, turning and colliding in closed form; many against the
pressure that the engine works out from the pair style's virial."""
import math
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.sheared_script import BOX, HEAD as SHEARED_HEAD, sides_of
from cohesion_tests.refusals import assert_refused
from cohesion_tests.thermo import thermo_lines

MASS = math.pi / 6  # of a sphere of diameter 1 and density 1
MU = MASS / 2
HEAD = SHEARED_HEAD + "pair_style %(style)s\npair_coeff * * %(pair)s\n"
PARTS = " ".join(f"c_stress[{row}][{k}]" for row in (1, 2) for k in range(1, 7))
TAIL = """
compute stress all gran/stress
thermo_style custom step ke %(more)s """ + PARTS + """
thermo_modify norm no format float %%.17g
thermo %(every)d
dump path all custom %(every)d path.txt id x y z vx vy vz
dump_modify path format float %%.17g sort id
timestep %(dt).17g
run %(steps)d
"""


def hooke(stiffness, restitution):
    """Contact time."""
    decay = -math.log(restitution)
    return math.sqrt((math.pi**2 + decay**2) * MU / stiffness)


def run(atoms, style, pair, dt, steps, every=1, dimension=3, fixes="", more="", ranks=1, box=BOX,
        skin=0.3):
    """Totals (lines, 2, 6), columns of the thermo output, snapshots."""
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, atoms, sides_of(box, dimension), 1, tilt=(0.0, 0.0, 0.0))
        code, output = engine.run_text(
            HEAD % {"dimension": dimension, "style": style, "pair": pair, "skin": skin} + fixes +
            "fix move all nve/sphere\n" + ("fix flat all enforce2d\n" if dimension == 2 else "") +
            TAIL % {"more": more, "every": every, "dt": dt, "steps": steps}, folder, ranks=ranks)
        if code != 0:
            raise RuntimeError(output[-3000:])
        names, rows = thermo_lines(output)
        table = dict(zip(names, numpy.array(rows).T))
        totals = numpy.array([[table[f"c_stress[{row}][{k}]"] for k in range(1, 7)]
                              for row in (1, 2)]).transpose(2, 0, 1)
        return totals, table, numpy.array(engine.dumps(folder, "path.txt"))


def sphere(x, v=(0.0, 0.0, 0.0), omega=(0.0, 0.0, 0.0)):
    return {"type": 1, "diameter": 1.0, "density": 1.0, "x": numpy.array(x), "v": numpy.array(v),
            "omega": omega}


class Pairs(unittest.TestCase):
    # Attraction of touching spheres: A (d/4)/(6 H_cut^2).
    HAMAKER, CUT = 2.4e-5, 1e-3
    ADHESION = HAMAKER * 0.25 / (6 * CUT**2)

    def words(self, restitution):
        return (f"stiffness 800 restitution {restitution} hamaker {self.HAMAKER} "
                f"cutoff {self.CUT} 1e-2")

    def test_pressed_together(self):
        """Two spheres at rest under a force along x (any other direction is unstable): R F in all,
        -R F_ad of it by adhesion, whatever the step. The scheme holds them at rest on the grid by a
        velocity and the shift that goes against it; R is where the step found them. Rounding: the
        totals of which a step is the difference are sums of so many terms."""
        force = 3.0
        atoms = [sphere([5.0 + side * 0.499, 4.0, 3.0]) for side in (-1, 1)]
        push = "".join(f"group g{k} id {k}\nfix f{k} g{k} addforce {x} 0 0\n"
                       for k, x in ((1, force), (2, -force)))
        for scheme, division in (("exact", 5), ("exact", 20), ("sampled", 50)):
            with self.subTest(scheme, division=division):
                dt, steps = hooke(800, 0.2) / division, 40 * division
                totals, _, path = run(atoms, f"gran/hamaker scheme {scheme}", self.words(0.2), dt,
                                      steps, fixes=push)
                between = path[-2:, 1, 1:7] - path[-2:, 0, 1:7]
                self.assertLess(numpy.ptp(between, axis=0).max(), 1e-14)
                self.assertEqual(abs(between[:, [1, 2]]).max(), 0.0)
                R = between[-1, 0] + dt * between[-1, 3]
                step = totals[-1] - totals[-2]
                room = steps * 2e-16 * abs(totals[-1]).max() + 800 * 4e-15 * dt
                self.assertLess(room, 1e-8 * force * dt)
                self.assertLess(abs(step[0, 0] - dt * (force + self.ADHESION) * R), room)
                self.assertLess(abs(step[1, 0] + dt * self.ADHESION * R), room)
                self.assertEqual(abs(step[:, 1:]).max(), 0.0)

    def test_pair_that_turns(self):
        """Bound by adhesion and turning about each other: kinetic energy and both parts keep the
        virial theorem, 2 E + contact + adhesion = 0, in the mean over a turn; each part is that of the
        spring where the spheres stand."""
        spin = 1.0
        # K x = F_ad - mu w^2 R at R = 1 - x; the centrifugal force is taken at touch.
        x = (self.ADHESION - MU * spin**2) / 800
        R = 1.0 - x
        atoms = [sphere([5.0 + side * R / 2, 4.0, 3.0], [0.0, side * spin * R / 2, 0.0])
                 for side in (-1, 1)]
        dt = hooke(800, 0.2) / 10
        settle, turn = 1000, int(2 * math.pi / spin / dt)
        totals, table, path = run(atoms, "gran/hamaker", self.words(0.2), dt, settle + turn)
        trace = totals[:, :, :3].sum(axis=2)
        gained = (trace[-1] - trace[settle]) / (turn * dt)
        distance = numpy.linalg.norm(path[settle:, 1, 1:4] - path[settle:, 0, 1:4], axis=1)
        self.assertLess(numpy.ptp(distance), 1e-6)  # it is a circle
        R, kinetic = distance.mean(), table["KinEng"][settle:].mean()
        # The grid stands half a step of straight flight from the circle, (w dt)^2/8 of R outside and
        # as much off the direction; the centrifugal force at touch: 3 x of it.
        room = (spin * dt)**2 * self.ADHESION + 3 * x * MU * spin**2
        self.assertLess(room, 0.01 * kinetic)
        self.assertLess(abs(gained.sum() + 2 * kinetic), room)
        self.assertLess(abs(gained[1] + R * self.ADHESION), room)
        self.assertLess(abs(gained[0] - R * (self.ADHESION - MU * spin**2 * R)), room)
        # Round and round: xx and yy the same, no xy; all but a hundredth of a turn.
        one = totals[-1] - totals[settle]
        self.assertLess(abs(one[:, 0] - one[:, 1]).max(), 0.05 * abs(one).max())
        self.assertEqual(abs(one[:, [2, 4, 5]]).max(), 0.0)

    def test_through_a_well(self):
        """Head on, in, against each other and out again; impulses from the square well's laws."""
        depth, ratio, e, v = 0.02, 1.005, 0.9, 1.0
        atoms = [sphere([5.0 + side * 0.52, 4.0, 3.0], [-side * v / 2, 0.0, 0.0])
                 for side in (-1, 1)]
        dt = hooke(5000, e) / 8
        within = math.sqrt(v**2 + 2 * depth / MU)
        out = math.sqrt((e * within)**2 - 2 * depth / MU)
        for more, words in ((0, "gran/squarewell"), (1, "squarewell")):
            with self.subTest(words):
                totals, _, path = run(atoms, words if not more else
                                      "hybrid/overlay gran/hamaker squarewell",
                                      f"stiffness 5000 restitution {e} well {depth} {ratio}"
                                      if not more else
                                      f"gran/hamaker stiffness 5000 restitution {e}\n"
                                      f"pair_coeff * * squarewell well {depth} {ratio}", dt, 200)
                self.assertGreater(path[-1, 1, 1] - path[-1, 0, 1], 1.02)
                contact, adhesion = totals[-1, 0, 0], totals[-1, 1, 0]
                # Where the grid stands when an impulse acts: within the well or the overlap of a
                # contact of 1/20, v t_c/pi, and half a step.
                off = ratio - 1 + within * (hooke(5000, e) / math.pi + dt / 2)
                self.assertLess(off, 0.02)
                impulse = MU * (1 + e) * within
                self.assertLess(abs(contact - impulse), off * impulse)
                edges = MU * (within - v), MU * (e * within - out)
                self.assertLess(abs(adhesion + sum(edges)), off * sum(edges))
                self.assertEqual(abs(totals[:, :, 1:]).max(), 0.0)

    def test_where_nothing_attracts(self):
        atoms = [sphere([5.0, 4.0, 3.0], [1.0, 0.0, 0.0]),
                 sphere([6.1, 4.5, 3.2], [-1.0, 0.0, 0.0], (0.0, 3.0, 1.0))]
        for scheme in ("exact", "sampled"):
            totals, _, _ = run(atoms, f"gran/hamaker scheme {scheme}",
                               "stiffness 800 restitution 0.9 friction 0.3", 0.002, 300)
            self.assertGreater(totals[-1, 0, 0], 0.1)
            self.assertEqual(abs(totals[:, 1]).max(), 0.0)


class Many(unittest.TestCase):
    LAWS = {
        "exact": ("gran/hamaker", "stiffness 5000 restitution 0.8 friction 0.3 hamaker 1e-5 "
                                  "cutoff 1e-3 1e-2"),
        "sampled": ("gran/hamaker scheme sampled", "stiffness 5000 restitution 0.8 friction 0.3 "
                                                   "hamaker 1e-5 cutoff 1e-3 1e-2"),
        "well": ("gran/squarewell", "stiffness 5000 restitution 0.8 friction 0.3 well 0.05 1.02"),
    }

    def atoms(self, dimension):
        random = numpy.random.default_rng(5)
        grid = [numpy.arange(n) + 0.5 for n in (9, 7, 5)]
        if dimension == 2:
            grid[2] = numpy.array([0.0])
        places = numpy.array(numpy.meshgrid(*grid)).reshape(3, -1).T * BOX / [9, 7, 5]
        flat = numpy.array([1, 1, dimension - 2])
        return [{**sphere(x * flat, flat * random.normal(0, 2, 3),
                          (1 - flat * (3 - dimension)) * random.normal(0, 2, 3)),
                 "diameter": random.uniform(0.9, 1.1)} for x in places]

    def check(self, law, dimension, ranks):
        dt, steps, rate = 0.002, 100, 0.5
        style, pair = self.LAWS[law]
        atoms = self.atoms(dimension)
        whole = " ".join(f"c_{name}[{k}]" for name in ("whole", "pair") for k in range(1, 7))
        kinetic = " ".join(f"c_flow[{k}]" for k in range(5, 11))
        totals, table, path = run(
            atoms, style, pair, dt, steps, dimension=dimension, ranks=ranks, more=f"{whole} {kinetic}",
            fixes=f"fix shear all deform/shear rate {rate}\ncompute flow all shear/profile\n"
                  "compute t all temp\ncompute pair all pressure NULL pair\n"
                  "compute whole all pressure t\n")
        volume = BOX.prod() if dimension == 3 else BOX[:2].prod()
        taken = [0, 1, 3] if dimension == 2 else list(range(6))

        def six(name, first=1):
            return numpy.array([table[f"c_{name}[{k}]"] for k in range(first, first + 6)]).T

        by_steps = numpy.diff(totals, axis=0)
        # Some 100 contacts of a step with R J of some 0.1, in two orders, and totals of up to 1e3.
        room = 2e-15 * (100 * 0.1 + abs(totals).max())
        self.assertGreater(abs(by_steps[:, 0]).max(), 1e6 * room)
        self.assertGreater(abs(by_steps[:, 1]).max(), 1e6 * room)
        both = by_steps.sum(axis=1)[:, taken]
        self.assertLess(abs(both - volume * dt * six("pair")[1:, taken]).max(), room)
        # With the kinetic part about the fitted flow, all of the engine's pressure but for the flow:
        # sums of m v v of up to 1e4.
        mass = math.pi / 6 * numpy.array([atom["diameter"]**3 for atom in atoms])
        flow = numpy.array([of_the_flow(table_at, mass, rate) for table_at in path[1:]])
        parts = both / dt / volume + six("flow", 5)[1:, taken] + flow[:, taken] / volume
        self.assertLess(abs(parts - six("whole")[1:, taken]).max(), room / dt / volume + 1e-11)
        self.assertGreater(abs(flow[:, 0]).max(), 1.0)

    def test_sum_of_parts_is_the_engines_pressure(self):
        cases = [("exact", 3, 1), ("exact", 3, 2), ("sampled", 3, 1), ("well", 3, 2), ("well", 2, 1)]
        with ThreadPoolExecutor(4) as pool:
            for case, done in [(case, pool.submit(self.check, *case)) for case in cases]:
                with self.subTest(case):
                    done.result()

    def test_totals_are_those_of_a_run_that_is_read_seldom(self):
        style, pair = self.LAWS["exact"]
        often = run(self.atoms(3), style, pair, 0.002, 60)[0][-1]
        seldom = run(self.atoms(3), style, pair, 0.002, 60, every=60)[0][-1]
        numpy.testing.assert_array_equal(seldom, often)


def of_the_flow(table, mass, rate):
    """Sum of m (v v - v' v'), v' about the fitted profile of what is in the box."""
    x, v = table[:, 1:4], table[:, 4:7]
    y = x[:, 1] - BOX[1] / 2
    count = numpy.floor(y / BOX[1] + 0.5)
    u = v.copy()
    u[:, 0] -= count * rate * BOX[1]
    y = y - count * BOX[1]
    slope, intercept = numpy.polyfit(y, u[:, 0], 1, w=numpy.sqrt(mass))
    own = u - mass @ u / mass.sum()
    own[:, 0] = u[:, 0] - intercept - slope * y
    difference = numpy.einsum("i,ij,ik->jk", mass, v, v) - numpy.einsum("i,ij,ik->jk", mass, own, own)
    return difference[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]


class Input(unittest.TestCase):
    def test_wrong_words(self):
        head = ("plugin load ${plugin}\natom_style sphere\nregion r block 0 9 0 9 0 9\n"
                "create_box 1 r\n")
        with engine.temporary_folder() as folder:
            for words, expected in (("all gran/stress block 3", "takes no further arguments"),
                                    ("one gran/stress", "must be 'all'")):
                code, output = engine.run_text(f"{head}group one type 1\ncompute s {words}\n", folder)
                assert_refused(self, code, output, expected)

    def test_pair_styles_that_it_does_not_know(self):
        hooke = "gran/hooke/history 800 228 0 NULL 0 0"
        cases = [(hooke, "", "gran/hooke/history"),
                 ("hard/squarewell", "restitution 1", "hard/squarewell"),
                 (f"hybrid/overlay {hooke} zero 1.0", None, "hybrid/overlay"),
                 (f"hybrid/overlay {hooke} squarewell", None, None)]
        members = {"gran/hooke/history": "", "squarewell": "well 0.05 1.1", "zero": ""}
        for style, words, foreign in cases:
            pairs = (f"pair_coeff * * {words}\n" if words is not None else
                     "".join(f"pair_coeff * * {name} {members[name]}\n" for name in members
                             if name in style.split()))
            with self.subTest(style), engine.temporary_folder() as folder:
                engine.write_spheres(folder, [sphere([5.0, 4.0, 3.0])], [(0.0, side) for side in BOX], 1)
                code, output = engine.run_text(
                    "plugin load ${plugin}\nunits lj\natom_style sphere\nnewton off\ncomm_modify vel yes\n"
                    f"read_data data.spheres\npair_style {style}\n{pairs}compute s all gran/stress\n"
                    "fix move all nve/sphere\ntimestep 0.001\nrun 0\n", folder)
                self.assertEqual(code, 0 if foreign is None else 1, output[-3000:])
                if foreign:
                    self.assertIn(f"does not know what pair_style {foreign} carries", output)


if __name__ == "__main__":
    unittest.main()
