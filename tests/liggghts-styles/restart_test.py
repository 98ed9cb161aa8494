# SPDX-License-Identifier: BSD-3-Clause
"""Files of `restart N`: a run from one continues as the run that wrote it, with stretched necks and bridges, springs of
friction, and walls, at steps at which no lists of neighbours are due."""
import itertools
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import (hamaker, liquid_bridge, part, script, sphere, square_well,
                                                  surface_energy)

RADIUS = 5e-4
PLATE = stl(rectangle((-8e-3, -8e-3, -5e-3), (1.6e-2, 0, 0), (0, 1.6e-2, 0), 1))
LINEAR, HERTZ = (f"model {normal} tangential history cohesion " for normal in ("hooke/stiffness", "hertz"))
# models, scheme, properties, speed of the couples that stick [m/s], step [s]
MODELS = {
    "jkr": (HERTZ + "jkr", "scheme exact", surface_energy(0.05), 0.05, 2e-6),
    "hamaker": (HERTZ + "hamaker", "scheme sampled", hamaker(2e-12), 0.02, 2e-6),
    "hamaker, exact": (LINEAR + "hamaker", "scheme exact", hamaker(2e-12), 0.02, 1e-5),
    "bridge": (LINEAR + "liquid_bridge", "scheme sampled", liquid_bridge(1e-3, 2e-5), 0.1, 5e-6),
    "bridge, exact": (LINEAR + "liquid_bridge", "scheme exact", liquid_bridge(1e-3, 2e-5), 0.1, 2e-5),
    "well": (LINEAR + "square_well", "scheme exact", square_well(5e-9), 0.05, 1e-5)}


def couples(speed):
    """Couples across the border between two ranks, at a plane and at a mesh, with slip and spin; each at another phase
    of its motion."""
    spheres = []
    for k in range(8):
        gap = 1e-7 + 2e-6 * k
        slip, y = 0.1 * speed * (k + 1), -7e-3 + 1.8e-3 * k
        spheres += [sphere((-RADIUS - gap, y, 0), (speed, slip, 0), (0, 10 * k, 5)),
                    sphere((RADIUS, y, 0), (-speed / 2, 0, slip)),
                    sphere((-4e-3, y, -5e-3 + RADIUS + gap), (slip, 0, -speed)),
                    sphere((-9e-3 + RADIUS + gap, y, 4e-3), (-speed, slip, 0))]
    return spheres


class Continued(unittest.TestCase):
    STEPS = 240

    def script(self, name, run, tangential="history"):
        models, scheme, properties, speed, dt = MODELS[name]
        models = models.replace("history", tangential)
        walls = ["fix plate all mesh/surface file plate.stl type 2",
                 f"fix floor all wall/gran {models} mesh n_meshes 1 meshes plate {scheme}",
                 f"fix side all wall/gran {models} primitive type 2 xplane -9e-3 {scheme}"]
        return script(couples(speed), f"{models} {scheme}", properties, dt=dt, walls=walls, run=run)

    def end(self, text, ranks, dump="out.txt"):
        return Run(text, ranks=ranks, inputs={"plate.stl": PLATE}).frames(dump)[-1]

    def continued(self, name, step, ranks, *models):
        """The end of a run from the file that `restart` wrote at this step of a longer run."""
        whole = self.script(name, f"restart {step} a.*\nrun {self.STEPS}\n", *models)
        again = (whole[:whole.index("region box")] + f"read_restart a.{step}\n" +
                 whole[whole.index("neighbor "):whole.index("create_atoms")] +
                 whole[whole.index("fix E all"):whole.index("restart ")]).replace("out.txt", "more.txt")
        return self.end(f"{whole}clear\n{again}run {self.STEPS - step}\n", ranks, "more.txt")

    def assert_same(self, one, other):
        """Places are rounded by 1e-18 m, speeds by that over the step, in some hundred steps; spins have the lever of a
        radius. Contacts of the step before are off by 1e-9 m and 1e-5 m/s or more."""
        self.assertEqual(one.keys(), other.keys())
        for what, room in (("x", 1e-15), ("v", 1e-11), ("omega", 1e-11 / RADIUS)):
            for i in one:
                for a, b in zip(part(one[i], what), part(other[i], what)):
                    self.assertAlmostEqual(a, b, delta=room, msg=f"{what} of {i}")

    def test_a_run_from_a_file_of_restart_is_a_second_run(self):
        for name, step, ranks in itertools.product(MODELS, (61, 118), (0, 2)):
            with self.subTest(name, step=step, ranks=ranks):
                # The file is written by both: lists are built at that step.
                split = self.script(name, f"restart {step} b.*\nrun {step}\nrun {self.STEPS - step}\n")
                self.assert_same(self.end(split, ranks), self.continued(name, step, ranks))

    def test_without_the_dashpots_of_the_engine_it_is_the_unbroken_run(self):
        """At a set-up these have the velocities of another time: those of friction, and of the scheme sampled."""
        for name, step in itertools.product(MODELS, (61, 118)):
            if MODELS[name][1] == "scheme exact":
                with self.subTest(name, step=step):
                    whole = self.script(name, f"run {self.STEPS}\n", "off")
                    self.assert_same(self.end(whole, 0), self.continued(name, step, 0, "off"))


if __name__ == "__main__":
    unittest.main()
