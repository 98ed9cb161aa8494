# SPDX-License-Identifier: BSD-3-Clause
"""Momentum through planes across the gradient of a sheared box, counted one by one from the dump and the
event file, against the stress that compute shear/profile and compute hard/stress give for the volume.

Between two snapshots the recorded events are replayed with the laws of the square well, knowing nothing
but who met and when: the replay must end where the next snapshot is."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.thermo import thermo_columns

SIDE, FRACTION, E, DEPTH, RATIO = 16, 0.3, 0.9, 1.0, 1.1
LENGTH = SIDE * math.sqrt(math.pi / 4 / FRACTION)
DT, STEPS, EVERY = 0.01, 4000, 20
FIRST = 500  # step from which on it counts
PLANES = numpy.arange(10) * LENGTH / 10 + 0.3
BLOCKS = 12

SCRIPT = """
plugin load ${plugin}
units lj
dimension 2
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
read_data data.spheres
neighbor 1.5 bin
neigh_modify delay 0 every 1 check yes
pair_style hard/squarewell record events.txt
pair_coeff * * restitution %g well %g %g
fix shear all deform/shear rate 1 profile yes
fix move all nve/sphere disc
fix flat all enforce2d
timestep %g
compute flow all shear/profile
compute stress all hard/stress
variable own atom vx-(y-0.5*ly)
variable carried atom v_own*vy
variable across atom vy*vy
compute sums all reduce sum v_across v_carried
variable yy equal c_stress[1][2]+c_stress[2][2]+c_stress[3][2]+c_stress[4][2]
variable xy equal c_stress[1][4]+c_stress[2][4]+c_stress[3][4]+c_stress[4][4]
thermo 1
thermo_style custom step atoms c_sums[1] c_sums[2] v_yy v_xy
thermo_modify norm no lost error format float %%.17g
dump path all custom %d path.txt id x y z vx vy vz
dump_modify path format float %%.17g sort id
run %d
""" % (E, DEPTH, RATIO, DT, EVERY, STEPS)


def write_start(folder):
    random = numpy.random.default_rng(3)
    places = numpy.array(numpy.meshgrid(range(SIDE), range(SIDE))).reshape(2, -1).T + 0.5
    v = random.normal(0, 2, (SIDE**2, 2))
    atoms = [hard.atom((*(place * LENGTH / SIDE), 0.0), (*w, 0.0)) for place, w in zip(places, v)]
    engine.write_spheres(folder, atoms, [(0.0, LENGTH), (0.0, LENGTH), (-0.5, 0.5)], 1,
                         tilt=(0.0, 0.0, 0.0))


def through(low, high):
    """How often a way from one height to another leads up through each plane and its images."""
    return numpy.floor((high - PLANES) / LENGTH) - numpy.floor((low - PLANES) / LENGTH)


class Replay:
    """Discs from a snapshot on, and what they carry up through the planes: y- and x-momentum, of x that
    beyond the mean flow at the plane."""

    def __init__(self):
        self.up = numpy.zeros(2)

    def start(self, table, time):
        self.x, self.v = table[:, 1:3].copy(), table[:, 4:6].copy()
        self.time = numpy.full(len(table), time)

    def fly(self, i, time):
        before = self.x[i, 1]
        self.x[i] += (time - self.time[i]) * self.v[i]
        self.time[i] = time
        times = through(before, self.x[i, 1])
        if not times.any():
            return
        vx, vy = self.v[i]
        # The image of the plane that lies on the way (a way of less than a box).
        at = PLANES + LENGTH * numpy.floor((max(before, self.x[i, 1]) - PLANES) / LENGTH)
        self.up += times.sum() * vy, (times * (vx - (at - LENGTH / 2))).sum()

    def meet(self, i, j, time, kind):
        self.fly(i, time)
        self.fly(j, time)
        d, w = self.x[j] - self.x[i], self.v[j] - self.v[i]
        images = numpy.rint(d[1] / LENGTH)
        d = d - images * numpy.array([time * LENGTH, LENGTH])
        w = w - images * numpy.array([LENGTH, 0.0])
        d[0] -= LENGTH * numpy.rint(d[0] / LENGTH)
        R = math.hypot(*d)
        k, m = d / R, 0.5
        u = -(k @ w)
        J = {"collision": lambda: m * (1 + E) * u,
             "approach": lambda: m * (u - math.sqrt(u * u + 2 * DEPTH / m)),
             "escape": lambda: m * (u + math.sqrt(u * u - 2 * DEPTH / m)),
             "capture": lambda: 2 * m * u}[kind]()
        self.v[i] -= J * k
        self.v[j] += J * k
        self.up += through(self.x[i, 1], self.x[i, 1] + d[1]).sum() * J * k[::-1]
        return abs(R - (1 if kind == "collision" else RATIO))


class PlaneFlux(unittest.TestCase):
    def test_momentum_through_planes_is_the_stress(self):
        with engine.temporary_folder() as folder:
            write_start(folder)
            code, output = engine.run_text(SCRIPT, folder)
            self.assertEqual(code, 0, output[-3000:])
            table = thermo_columns(output)
            tables, events = engine.dumps(folder, "path.txt"), hard.recorded(folder)
        self.assertGreater(len(events), 50000)
        replay, n, carried, worst = Replay(), 0, [], 0.0
        for number, (now, then) in enumerate(zip(tables, tables[1:])):
            replay.start(now, number * EVERY * DT)
            before = replay.up.copy()
            while n < len(events) and events[n].step <= (number + 1) * EVERY:
                event = events[n]
                off = replay.meet(event.i - 1, event.j - 1, (event.step - 1 + event.fraction) * DT,
                                  event.kind)
                worst, n = max(worst, off), n + 1
            end = (number + 1) * EVERY * DT
            for i in range(len(now)):
                replay.fly(i, end)
            carried.append(replay.up - before)
            away = replay.x - then[:, 1:3]
            images = numpy.rint(away[:, 1] / LENGTH)
            away -= images[:, None] * numpy.array([end * LENGTH, LENGTH])
            away[:, 0] -= LENGTH * numpy.rint(away[:, 0] / LENGTH)
            worst = max(worst, abs(away).max())
        # Rounding of places, 4e-15, grows by some 10 at each of the few meetings between snapshots.
        self.assertLess(worst, 1e-8)

        # Per block, by the planes and by the volume. Kinetic: trapezoidal rule.
        plane = numpy.array(carried[FIRST // EVERY:]) / (LENGTH * len(PLANES) * EVERY * DT)
        kinetic = numpy.array([table["c_sums[1]"], table["c_sums[2]"]]).T
        impulsive = numpy.array([table["v_yy"], table["v_xy"]]).T
        by_step = (0.5 * (kinetic[1:] + kinetic[:-1]) + numpy.diff(impulsive, axis=0) / DT) / LENGTH**2
        volume = by_step[FIRST:].reshape(-1, EVERY, 2).mean(axis=1)
        length = len(plane) // BLOCKS
        plane, volume = (a[-BLOCKS * length:].reshape(BLOCKS, length, 2).mean(axis=1)
                         for a in (plane, volume))
        stress = volume.mean(axis=0)
        self.assertGreater(stress[0], 0)
        self.assertLess(stress[1], 0)
        error = (plane - volume).std(axis=0, ddof=1) / math.sqrt(BLOCKS)
        # Student's t of eleven degrees: beyond 4.5 once in a thousand.
        self.assertLess(abs((plane - volume).mean(axis=0) / error).max(), 4.5)
        self.assertLess(abs(error / stress).max(), 0.015)


if __name__ == "__main__":
    unittest.main()
