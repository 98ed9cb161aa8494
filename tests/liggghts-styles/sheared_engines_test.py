# SPDX-License-Identifier: BSD-3-Clause
"""The same sheared cohesive gas in LAMMPS and in LIGGGHTS: the same path, profile, stress and
agglomerates for as long as rounding allows, then the same statistics. Without friction, of which the
two engines have different laws."""

import sys
import unittest

import numpy

from cohesion_tests import lammps
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import DAMPING, DENSITY, STIFFNESS, script, sphere, square_well
from cohesion_tests.theory.sheared_images import ShearedImages
from cohesion_tests.thermo import thermo_lines

BOX = numpy.array([10e-3, 8e-3, 6e-3])
RATE, DT, STEPS, EVERY = 200.0, 5e-6, 16000, 20
RADIUS, DEPTH, RATIO = 0.45e-3, 4e-9, 1.02
OUTPUT = f"""fix shear all deform/shear rate {RATE}
fix set all agglomerates {EVERY}
compute flow all shear/profile layers 4
compute heat all temp
compute contact all pressure heat pair
thermo {EVERY}
thermo_style custom step f_shear {' '.join(f'c_flow[{k}]' for k in range(1, 11))} \
{' '.join(f'c_contact[{k}]' for k in range(1, 7))} {' '.join(f'f_set[{k}]' for k in range(1, 9))}
thermo_modify norm no format float %.17g
"""
PROFILE, KINETIC, CONTACT, SETS = slice(2, 6), slice(6, 12), slice(12, 18), slice(18, 26)
LAMMPS = """plugin load {plugin}
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
read_data data.spheres
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
pair_style gran/squarewell scheme sampled
pair_coeff * * stiffness {stiffness} damping {damping} well {depth} {ratio}
fix move all nve/sphere
timestep {dt}
{output}dump out all custom {every} out.txt id x y z vx vy vz f_set[1] f_set[2]
dump_modify out format float %.17g sort id
run {steps}
"""


def start():
    random = numpy.random.default_rng(5)
    grid = [numpy.arange(n) + 0.5 for n in (8, 6, 5)]
    places = numpy.array(numpy.meshgrid(*grid)).reshape(3, -1).T * BOX / [8, 6, 5]
    return places, random.normal(0, 0.2, places.shape)


def run_lammps(places, velocities):
    with lammps.temporary_folder() as folder:
        lammps.write_spheres(folder, [{"type": 1, "diameter": 2 * RADIUS, "density": DENSITY, "x": x,
                                       "v": v} for x, v in zip(places, velocities)],
                             [(0, side) for side in BOX], 1, tilt=(0.0, 0.0, 0.0))
        code, printed = lammps.run_text(
            LAMMPS.format(plugin=lammps.plugin(), stiffness=STIFFNESS, damping=DAMPING, depth=DEPTH,
                          ratio=RATIO, dt=DT, every=EVERY, output=OUTPUT, steps=STEPS), folder)
        if code:
            raise AssertionError(printed)
        return numpy.array(thermo_lines(printed)[1]), numpy.array(lammps.dumps(folder,
                                                                               "out.txt"))[:, :, 1:]


def run_liggghts(places, velocities):
    run = Run(script([sphere(x, v, radius=RADIUS) for x, v in zip(places, velocities)],
                     "model hooke/stiffness tangential off cohesion square_well absolute_damping on "
                     "tangential_damping off", square_well(DEPTH, ratio=RATIO), dt=DT, steps=STEPS,
                     every=EVERY, skin=2e-4, boundary="p p p",
                     box="0 {!r} 0 {!r} 0 {!r} 0 0 0".format(*BOX.tolist()), extra=OUTPUT,
                     columns="x y z vx vy vz f_set[1] f_set[2]".split()))
    frames = run.frames("out.txt")
    return (numpy.array(thermo_lines(run.output)[1]),
            numpy.array([[frame[n] for n in sorted(frame)] for frame in frames]))


class SameGas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scene = start()
        cls.rows, cls.frames = zip(run_lammps(*scene), run_liggghts(*scene))

    def test_same_path_and_outputs(self):
        one, other = self.frames
        self.assertEqual(one.shape, other.shape)
        images = ShearedImages(BOX, RATE)
        apart = numpy.array([numpy.abs(images.nearest(b[:, :6] - a[:, :6], n * EVERY * DT)[:, :3]).max()
                             for n, (a, b) in enumerate(zip(one, other))]) / (2 * RADIUS)
        beyond = numpy.flatnonzero(apart > 1e-10)
        agree = int(beyond[0]) if len(beyond) else len(apart)
        strain = (agree - 1) * EVERY * DT * RATE
        print(f"within 1e-10 d for a strain of {strain:.2f}; {apart[-1]:.1e} d at the end",
              file=sys.stderr)
        # Rounding, 1e-16 of the box, grows tenfold per impact. At speeds of 0.3 m/s and free paths of
        # 0.6 mm five impacts take 10 ms, a strain of 2; the most struck sphere has twice as many.
        self.assertGreater(strain, 1.0)
        off = numpy.abs(self.rows[1] - self.rows[0])[:agree]
        # Places within 1e-10 d make velocities that differ by w0 = 3.4e4 1/s times that.
        place = 1e-10 * 2 * RADIUS
        speed, fastest = 3.4e4 * place, numpy.abs(one[:agree, :, 3:6]).max()
        self.assertLess(off[:, 1].max(), 1e-13)
        # Slope: twice a difference of velocities over half the box.
        self.assertLess(off[:, 2].max(), 4 * speed / BOX[1])
        self.assertLess(off[:, 3].max(), speed)
        self.assertLess(off[:, 4].max(), 2 * fastest * speed)
        self.assertLess(off[:, 5].max(), 2 * speed)
        mass = DENSITY * len(one[0]) * 4 / 3 * numpy.pi * RADIUS**3
        self.assertLess(off[:, KINETIC].max(), 2 * fastest * speed * mass / BOX.prod())
        # Each sphere in contact with two others at the most; all differences add.
        force = 2 * STIFFNESS * place + 2 * DAMPING * speed
        self.assertLess(off[:, CONTACT].max(), force * len(one[0]) * 2 * RADIUS / BOX.prod())
        self.assertGreater(numpy.abs(self.rows[0][:agree, CONTACT]).max(), 1.0)
        numpy.testing.assert_array_equal(one[:agree, :, 6:], other[:agree, :, 6:])
        # Numbers and sizes of agglomerates, their largest, durations to rounding of the time.
        self.assertLess(off[:, [18, 19, 21, 23, 25]].max(), 1e-12)
        self.assertLess(off[:, [20, 22, 24]].max(), 1e-9)
        self.assertGreater(self.rows[0][agree - 1, 23], 10)  # durations that have ended

    def test_same_statistics(self):
        """Temperature, kinetic and contact stress xx, yy, xy, number and mean size of agglomerates:
        means of blocks of a strain of 2 from a strain of 4 on."""
        columns = [4, 6, 7, 9, 12, 13, 15, 18, 20]
        blocks = []
        for rows in self.rows:
            sheared = rows[rows[:, 1] > 4.0 + 1e-9][:, columns]
            blocks.append(sheared.reshape(6, -1, len(columns)).mean(axis=1))
        means = [b.mean(axis=0) for b in blocks]
        error = numpy.sqrt(sum(b.var(axis=0, ddof=1) / 6 for b in blocks))
        print(numpy.array([*means, (means[1] - means[0]) / error]), file=sys.stderr)
        # Student's t of twice six blocks, ten degrees of freedom; nine numbers, none beyond its 1e-4.
        self.assertTrue((numpy.abs(means[1] - means[0]) < 6.2 * error).all())
        # A part that is missing or counted twice would be seen.
        self.assertTrue((6.2 * error < numpy.abs(means[0])).all())


if __name__ == "__main__":
    unittest.main()
