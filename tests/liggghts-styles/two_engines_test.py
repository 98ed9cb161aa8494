# SPDX-License-Identifier: BSD-3-Clause
"""The same cohesive scene of 210 spheres in LAMMPS and in LIGGGHTS: the same path for as long as
rounding allows, then the same statistics. Without friction, of which the two engines have different
laws."""

import math
import sys
import unittest

import numpy

from cohesion_tests import lammps
from cohesion_tests.liggghts_scenes.scene import (CUT, DAMPING, DENSITY, MASS, OUT, RADIUS, RATIO, STIFFNESS, capillary,
                                                  frames, hamaker, liquid_bridge, sphere, square_well)

COUNT, CELLS, PITCH = 210, 6, 1.4e-3
SIZE = CELLS * PITCH
SPEED = 0.1
A, DEPTH = 1e-11, 4e-9  # a pair gains 8e-10 and 4e-9 J; it approaches with 5e-9 J
FORCE, GAP = 4e-4, 1e-5  # of bridges, which take 4e-9 J
TENSION, VOLUME = 0.15, 1e-13  # of bridges of a liquid, which take 4e-9 J
DT, STEPS, EVERY = 2e-6, 20000, 200
LAMMPS = """plugin load {plugin}
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
read_data data.spheres
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
{pair}
fix move all nve/sphere
timestep {dt!r}
dump out all custom {every} out.txt id x y z vx vy vz
dump_modify out format float %.17g sort id
run {steps}
"""
SCENES = {
    "hamaker": (
        f"pair_style hybrid/overlay gran/hooke {STIFFNESS} NULL {2 * DAMPING / MASS!r} NULL 0 0 "
        f"hamaker {CUT!r} {OUT!r}\npair_coeff * * gran/hooke\npair_coeff * * hamaker hamaker {A!r}",
        hamaker(A)),
    "square_well": (
        "pair_style gran/squarewell scheme sampled\npair_coeff * * "
        f"stiffness {STIFFNESS} damping {DAMPING!r} well {DEPTH!r} {RATIO!r}",
        square_well(DEPTH)),
    "liquid_bridge": (
        "pair_style gran/liquidbridge scheme sampled\npair_coeff * * "
        f"stiffness {STIFFNESS} damping {DAMPING!r} bridge {FORCE!r} {GAP!r}",
        liquid_bridge(FORCE, GAP)),
    "liquid_bridge capillary on": (
        "pair_style gran/liquidbridge scheme sampled\npair_coeff * * "
        f"stiffness {STIFFNESS} damping {DAMPING!r} capillary {TENSION!r} 0.6 {VOLUME!r}",
        capillary(TENSION, 0.6, VOLUME))}


def start(seed):
    random = numpy.random.default_rng(seed)
    nodes = numpy.indices((CELLS,) * 3).reshape(3, -1).T
    places = (random.permutation(nodes)[:COUNT] + 0.5) * PITCH
    places += random.uniform(-0.15e-3, 0.15e-3, places.shape)
    velocities = random.normal(0, SPEED / math.sqrt(3), places.shape)
    return places, velocities - velocities.mean(axis=0)


def run_lammps(cohesion, places, velocities):
    with lammps.temporary_folder() as folder:
        lammps.write_spheres(folder, [{"type": 1, "diameter": 2 * RADIUS, "density": DENSITY, "x": x,
                                       "v": v} for x, v in zip(places, velocities)],
                             [(0, SIZE)] * 3, 1)
        code, output = lammps.run_text(LAMMPS.format(plugin=lammps.plugin(), pair=SCENES[cohesion][0],
                                                     dt=DT, every=EVERY, steps=STEPS), folder)
        if code:
            raise AssertionError(output)
        return numpy.array(lammps.dumps(folder, "out.txt"))[:, :, 1:]


def run_liggghts(cohesion, places, velocities):
    name, _, settings = cohesion.partition(" ")
    path = frames([sphere(x, v) for x, v in zip(places, velocities)],
                  f"model hooke/stiffness tangential off cohesion {name} absolute_damping on "
                  f"tangential_damping off scheme sampled {settings}", SCENES[cohesion][1], dt=DT, steps=STEPS, every=EVERY,
                  skin=2e-4, boundary="p p p", box=f"0 {SIZE!r} 0 {SIZE!r} 0 {SIZE!r}")
    return numpy.array([[frame[n][:6] for n in sorted(frame)] for frame in path])


def apart(one, other):
    """Largest distance of a particle's places, in snapshots of both; over the diameter."""
    step = (one - other)[:, :, :3]
    step -= SIZE * numpy.round(step / SIZE)
    return numpy.linalg.norm(step, axis=2).max(axis=1) / (2 * RADIUS)


def numbers(snapshot):
    """Kinetic energy over that of the start, and pairs in the range of the attraction, per sphere."""
    x = snapshot[:, :3]
    step = x[:, None] - x[None]
    step -= SIZE * numpy.round(step / SIZE)
    gaps = numpy.linalg.norm(step, axis=2)[numpy.triu_indices(COUNT, 1)] - 2 * RADIUS
    return ((snapshot[:, 3:]**2).sum() / (COUNT * SPEED**2),
            (gaps < 2 * (RATIO - 1) * RADIUS).sum() / COUNT)


class TwoEngines(unittest.TestCase):
    def test_same_path_then_same_statistics(self):
        for cohesion in SCENES:
            with self.subTest(cohesion=cohesion):
                ends = []
                for seed in range(4):
                    scene = start(seed)
                    one, other = run_lammps(cohesion, *scene), run_liggghts(cohesion, *scene)
                    self.assertEqual(one.shape, other.shape)
                    apart_then = apart(one, other)
                    beyond = numpy.flatnonzero(apart_then > 1e-10)
                    agree = int(beyond[0]) if len(beyond) else len(apart_then)
                    self.assertGreater(agree, 0, "apart from the start")
                    collided = [(numpy.abs(s[:, 3:] - one[0][:, 3:]).max(axis=1) > 1e-6).mean()
                                for s in (other[agree - 1], other[-1])]
                    ends.append([numbers(one[-1]), numbers(other[-1])])
                    print(f"{cohesion}, seed {seed}: within 1e-10 d for {(agree - 1) * EVERY} steps, in "
                          f"which {100 * collided[0]:.0f} % of the spheres felt another; {apart_then[-1]:.1e}"
                          f" d at {STEPS}; energy {ends[-1][0][0]:.4f} and {ends[-1][1][0]:.4f} of the "
                          f"start, pairs {ends[-1][0][1]:.3f} and {ends[-1][1][1]:.3f} per sphere",
                          file=sys.stderr)
                    # Rounding, 1e-16 of the box, grows tenfold per impact: 1e-10 allows about five.
                    self.assertGreater(collided[0], 0.5)
                ends = numpy.array(ends)
                difference = ends[:, 0] - ends[:, 1]
                # Of four: Student's t at 1 %, both sides, is 5.8.
                error = difference.std(axis=0, ddof=1) / 2
                self.assertTrue((numpy.abs(difference.mean(axis=0)) <= 5.8 * error).all(), difference)
                # Cohesion acts in this scene. A gas without it, n spheres in the volume, has 2 pi n d^2 times the
                # range, 0.022, in range per sphere, and in the mean of four 0.005 more or less by chance.
                self.assertGreater(ends[..., 1].mean(), 0.07)


if __name__ == "__main__":
    unittest.main()
