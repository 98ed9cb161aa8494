# SPDX-License-Identifier: BSD-3-Clause
"""model hertz with scheme exact: capture of pairs and at walls, restitution, strength and tangential springs, against an
integration that knows nothing of the engine."""
import math
import sys
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes import pull_off
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import RADIUS, contact, hamaker, script, sphere
from cohesion_tests.theory import slow_ramp
from cohesion_tests.theory.hertz_contact import CUT, OUT, HertzPair

A, DIAMETER = 7.49e-19, 2 * RADIUS
START = 1.001 * OUT
POSITIONS = 8
MODELS = "model hertz tangential off cohesion hamaker"
EXACT = " tangential_damping off scheme exact"
PLANE = ("primitive type 1 xplane -8.5e-3", [], {})


def mesh(cells):
    """A square plate of 2 cells^2 triangles."""
    plate = rectangle((-8.5e-3, -9.5e-3, -9.5e-3), (0, 1.9e-2, 0), (0, 0, 1.9e-2), cells)
    return ("mesh n_meshes 1 meshes square", [f"fix square all mesh/surface file square{cells}.stl type 1"],
            {f"square{cells}.stl": stl(plate)})


def contacts(restitution, friction=0.3):
    """E 5e6 Pa, nu 0.3."""
    text = contact()
    for name, before, now in (("Restitution", 0.9, restitution), ("Friction", 0.3, friction)):
        old = f"fix coefficient{name} all property/global coefficient{name} peratomtypepair 2" + 4 * f" {before}"
        assert old in text
        text = text.replace(old, old.replace(str(before), str(float(now))))
    return text


class Hertz(unittest.TestCase):
    def parted(self, restitution, division, factors, degrees, wall):
        pair = HertzPair(5e6, restitution, DIAMETER, A, poisson=0.3, plane=bool(wall))
        angle = math.radians(degrees)
        speed = pair.escape_velocity(angle, START)
        dt = pair.contact_time(pair.touching_speed(pair.escape_velocity(0.0, START))) / division
        spheres, columns = [], 8
        for n, (factor, position) in enumerate((f, p) for f in factors for p in range(POSITIONS)):
            late = dt * position / POSITIONS
            inwards, across = factor * speed, factor * speed * math.tan(angle)
            gap = START + inwards * late
            y, z = -8e-3 + 2e-3 * (n % columns), -8e-3 + 2e-3 * (n // columns)
            if wall:
                spheres.append(sphere((-8.5e-3 + RADIUS + gap, y, z), (-inwards, across, 0)))
            else:
                spheres += [sphere((-8.5e-3, y, z), (inwards / 2, -across / 2, 0)),
                            sphere((-8.5e-3 + DIAMETER + gap, y - across * late, z), (-inwards / 2, across / 2, 0))]
        shape, before, inputs = wall or ("", [], {})
        walls = [*before, f"fix plate all wall/gran {MODELS} {shape}{EXACT}"] if wall else []
        steps = 30 * division
        text = script(spheres, MODELS + EXACT, hamaker(A, cut=CUT, out=OUT), dt=dt, steps=steps, every=steps, skin=2e-4,
                      contacts=contacts(restitution), walls=walls)
        end = Run(text, inputs=inputs).frames("out.txt")[-1]
        if wall:
            gaps = [end[n][0] + 8.5e-3 - RADIUS for n in range(1, len(spheres) + 1)]
        else:
            gaps = [math.dist(end[n][:3], end[n + 1][:3]) - DIAMETER for n in range(1, len(spheres), 2)]
        out = [gap > START for gap in gaps]
        return {f: out[k * POSITIONS:(k + 1) * POSITIONS] for k, f in enumerate(factors)}

    def test_capture(self):
        # Within 1e-3 of the escape velocity at t_c/20, 2e-3 at t_c/10 for a restitution above 0.7.
        for restitution, division, grade in ((0.5, 20, 1e-3), (0.9, 20, 1e-3), (0.9, 10, 2e-3)):
            for name, wall, angles in (("pair", None, (0, 40, 80)), ("plane", PLANE, (0, 80)), ("2 triangles", mesh(1), (0, 80)),
                                       ("200 triangles", mesh(10), (0, 80))):
                for degrees in angles:
                    answers = self.parted(restitution, division, (0.99, 1 - grade, 1 + grade, 1.01), degrees, wall)
                    slowest = min((f for f, out in answers.items() if any(out)), default=math.inf)
                    fastest = max((f for f, out in answers.items() if not all(out)), default=0.0)
                    print(f"e {restitution}, t_c/{division}, {name}, {degrees} degrees: slowest parted {slowest}, fastest "
                          f"captured {fastest}", file=sys.stderr)
                    self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))


if __name__ == "__main__":
    unittest.main()
