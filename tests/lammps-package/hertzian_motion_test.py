# SPDX-License-Identifier: BSD-3-Clause
"""Columns, rows, oblique impacts and gases of `normal hertz`, with a Hamaker attraction, and of gran/jkr
(cohesion_tests/hertzian_motion.py)."""
import unittest

from cohesion_tests import hertzian_motion, lammps
from cohesion_tests.lammps_scenes import cohesive_gas
from cohesion_tests.theory import hertzian_laws as laws

SCRIPT = """plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data data.spheres
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
pair_style {style}
pair_coeff * * {words}
{more}
fix move all nve/sphere
timestep {dt!r}
thermo {steps}
run {steps}
write_dump all custom end.txt id x y z vx vy vz omegaz modify format float %.17g sort id
"""


class Lammps(hertzian_motion.Motion, unittest.TestCase):
    def end(self, law, restitution, dt, steps, places, velocities, more="", friction=""):
        style, words = laws.lammps(law)
        words += f" restitution {restitution!r} {friction}"
        script = SCRIPT.format(style=style, words=words, dt=dt, steps=steps,
                               more=more and f"fix plate all wall/{style} {words} zplane 0 NULL\n{more}")
        with lammps.temporary_folder() as folder:
            lammps.write_spheres(folder, [{"type": 1, "diameter": laws.DIAMETER, "density": 2650.0, "x": x, "v": v}
                                          for x, v in zip(places, velocities)], 3 * [(-0.01, 0.01)], 1)
            code, output = lammps.run_text(script, folder)
            self.assertEqual(code, 0, output[-2000:])
            return lammps.dump(folder, "end.txt")

    def column(self, law, dt, steps, heights):
        end = self.end(law, hertzian_motion.RESTITUTION, dt, steps, [(0.0, 0.0, z) for z in heights],
                       len(heights) * [(0.0, 0.0, 0.0)], f"fix down all gravity {hertzian_motion.GRAVITY} vector 0 0 -1")
        return end[:, [3, 6]]

    def row(self, law, restitution, dt, steps, starts, velocities):
        return self.end(law, restitution, dt, steps, [(x, 0.0, 0.0) for x in starts],
                        [(v, 0.0, 0.0) for v in velocities])[:, 4]

    def oblique(self, dt, steps, start, velocity):
        end = self.end("hertz", 1.0, dt, steps, [(0.0, 0.0, 0.0), (start, 0.0, 0.0)], [(0.0, 0.0, 0.0), velocity],
                       friction="friction 1e6 tangential_damping 0")
        return end[1, 5] - end[0, 5] - 0.5 * laws.DIAMETER * (end[0, 7] + end[1, 7])

    def gas(self, law, restitution, friction, division, collisions):
        _, _, speed = laws.gases(law)[0]
        with lammps.temporary_folder() as folder:
            cohesive_gas.write(folder, 5, 0.5, speed, seed=1)
            table, _ = cohesive_gas.follow(folder, division, collisions / cohesive_gas.collision_rate(0.5, speed), law=law,
                                           time=cohesive_gas.contact_time(law, speed), e=restitution, mu=friction)
        return abs(table[:, 2]).max() / table[0, 3], (table[0, 1] - table[-1, 1]) / table[0, 3]


if __name__ == "__main__":
    unittest.main()
