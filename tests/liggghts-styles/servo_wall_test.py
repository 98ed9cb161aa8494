# SPDX-License-Identifier: BSD-3-Clause
"""A wall whose velocity changes from step to step, as that of a servo, acts as a wall with that motion: grains below a
servo lid come to rest under its force, and a controller that overshoots moves them no more than a sampled force does."""
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import stl
from cohesion_tests.liggghts_scenes.scene import RADIUS, contact, hamaker, liquid_bridge, script, sphere, surface_energy

TARGET = 5e-3  # of the lid, [N]
LID = [((-4e-3, -4e-3, 1.2e-3), (0.0, 6e-3, 1.2e-3), (4e-3, -4e-3, 1.2e-3))]
CONTACTS = contact().replace("0.9", "0.7")  # restitution
LAWS = {"hamaker": hamaker(2e-19, cut=4e-10, out=1e-7), "jkr": surface_energy(1e-4),
        "liquid_bridge": liquid_bridge(1e-5, 5e-5)}


def settle(models, properties, gain):
    """Height of a grain between a floor and a lid, and the force of the lid, in the last 20 of 3000 steps."""
    lid = (f"fix lid all mesh/surface/stress/servo file lid.stl type 2 com 0 0 1.2e-3 ctrlPV force axis 0 0 -1 "
           f"target_val {TARGET} vel_max 0.2 kp {gain}")
    walls = [lid, f"fix top all wall/gran {models[0]} mesh n_meshes 1 meshes lid {models[1]}",
             f"fix floor all wall/gran {models[0]} primitive type 2 zplane 0 {models[1]}"]
    run = Run(script([sphere((3e-4, 2e-4, RADIUS - 5e-7))], " ".join(models), properties, walls, dt=5e-6, contacts=CONTACTS, run=(
        "fix weight all gravity 9.81 vector 0 0 -1\nvariable z equal z[1]\nthermo_style custom step v_z f_lid[3]\n"
        "thermo_modify norm no\nthermo 3000\nrun 3000\nthermo 1\nrun 20\n")), inputs={"lid.stl": stl(LID)})
    assert run.code == 0, run.output[-2000:]
    rows = [line.split() for line in run.output.splitlines()]
    last = {int(row[0]): [float(word) for word in row[1:]] for row in rows
            if len(row) == 3 and row[0].isdigit() and 3001 <= int(row[0]) <= 3020}
    assert len(last) == 20, run.output[-2000:]
    return list(last.values())


class ServoLid(unittest.TestCase):
    def test_a_grain_comes_to_rest(self):
        for normal in ("hertz", "hooke"):
            for law, properties in LAWS.items():
                if (normal, law) == ("hooke", "jkr"):
                    continue
                models = f"model {normal} tangential history cohesion {law}", "scheme exact"
                with self.subTest(normal=normal, law=law):
                    for z, force in settle(models, properties, 1.0):
                        self.assertAlmostEqual(force, TARGET, delta=1e-3 * TARGET)
                        self.assertLess(z, RADIUS)
                        self.assertGreater(z, 0.96 * RADIUS)

    def test_an_overshooting_controller(self):
        # At this gain its velocity reaches the limit in every step, also with sampled forces.
        for scheme in ("sampled", "exact"):
            rows = settle(("model hertz tangential history cohesion hamaker", "scheme " + scheme), LAWS["hamaker"], 5.0)
            with self.subTest(scheme=scheme):
                for z, force in rows:
                    self.assertAlmostEqual(force, TARGET, delta=0.5 * TARGET)
                    self.assertAlmostEqual(z, 0.968 * RADIUS, delta=2e-3 * RADIUS)


if __name__ == "__main__":
    unittest.main()
