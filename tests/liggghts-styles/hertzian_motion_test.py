# SPDX-License-Identifier: BSD-3-Clause
"""Columns, rows, oblique impacts and gases of model hertz with the cohesion models hamaker and jkr (cohesion_tests/hertzian_motion.py)."""
import unittest

from cohesion_tests import hertzian_motion
from cohesion_tests.lammps_scenes import cohesive_gas
from cohesion_tests.liggghts_scenes.elastic_gas import hertzian, tallied_gas
from cohesion_tests.liggghts_scenes.scene import RADIUS, frames, sphere
from cohesion_tests.theory import hertzian_laws as laws


class Liggghts(hertzian_motion.Motion, unittest.TestCase):
    def end(self, law, restitution, dt, steps, spheres, extra="", plate=""):
        models, attraction, contacts = hertzian(law, restitution, 0.0)
        model, keywords = models.split(" tangential_damping")
        walls = [f"fix plate all wall/gran {model} {plate} tangential_damping{keywords}"] if plate else []
        rows = frames(spheres, models, attraction, dt=dt, steps=steps, every=steps, contacts=contacts, walls=walls,
                      extra=extra, skin=2e-4)[-1]
        return [rows[n + 1] for n in range(len(spheres))]

    def column(self, law, dt, steps, heights):
        end = self.end(law, hertzian_motion.RESTITUTION, dt, steps, [sphere((0, 0, z)) for z in heights],
                       f"fix down all gravity {hertzian_motion.GRAVITY} vector 0 0 -1\n", "primitive type 1 zplane 0")
        return [(row[2], row[5]) for row in end]

    def row(self, law, restitution, dt, steps, starts, velocities):
        end = self.end(law, restitution, dt, steps, [sphere((x, 0, 0), (v, 0, 0)) for x, v in zip(starts, velocities)])
        return [row[3] for row in end]

    def oblique(self, dt, steps, start, velocity):
        models, attraction, contacts = hertzian("hertz", 1.0, 1e6)
        rows = frames([sphere((0, 0, 0)), sphere((start, 0, 0), velocity)],
                      models.replace("tangential_damping on", "tangential_damping off"), attraction, dt=dt, steps=steps,
                      every=steps, contacts=contacts, skin=2e-4)[-1]
        return rows[2][4] - rows[1][4] - RADIUS * (rows[1][8] + rows[2][8])

    def gas(self, law, restitution, friction, division, collisions):
        _, _, speed = laws.gases(law)[0]
        rows = tallied_gas(5, 0.5, 0.0, speed, restitution, friction, law=law,
                           dt=cohesive_gas.contact_time(law, speed) / division,
                           duration=collisions / cohesive_gas.collision_rate(0.5, speed))
        return rows[-1][11] / rows[0][2], (rows[0][1] - rows[-1][1]) / rows[0][2]


if __name__ == "__main__":
    unittest.main()
