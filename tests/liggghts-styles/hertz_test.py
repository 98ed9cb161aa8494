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

    def test_strength(self):
        # The lag of the ramp and how it is read: slow_ramp.py, pull_off.py.
        for partner in pull_off.PARTNERS:
            for division in (10, 20):
                found = pull_off.HertzGrain(5e6, 0.9, partner=partner).load_at_parting(division)
                print(f"{partner}, t_c/{division}: {found:.4f} F_ad", file=sys.stderr)
                self.assertAlmostEqual(found, 1.0, delta=0.01)

    def test_a_tangential_spring_that_stiffens_gives_no_energy(self):
        # Elastic impacts that stick: the engine alone (sampled), and its tangential model under scheme exact.
        for scheme in ("sampled", "exact"):
            for degrees in (5, 20, 45, 70, 85):
                left = self.left_after_sticking(scheme, degrees)
                print(f"{scheme}, {degrees} degrees: {left - 1:.2e}", file=sys.stderr)
                if scheme == "exact":
                    self.assertLess(left, 1 + 1e-3)

    def left_after_sticking(self, scheme, degrees, division=20):
        """The most energy that is left after an impact, over that before, of eight positions in the step."""
        pair, speed, angle = HertzPair(5e6, 1 - 1e-12, DIAMETER, poisson=0.3), 0.1, math.radians(degrees)
        dt, spheres = pair.contact_time(speed) / division, []
        for position in range(8):
            late = (1 + position / 8) * dt
            v = (-speed * math.cos(angle), speed * math.sin(angle), 0)
            y = -8e-3 + 2e-3 * position
            spheres += [sphere((0, y, 0)), sphere((DIAMETER - v[0] * late, y - v[1] * late, 0), v)]
        models = "model hertz tangential history cohesion hamaker"
        text = script(spheres, f"{models} tangential_damping off scheme {scheme}", hamaker(0, cut=CUT, out=OUT), dt=dt,
                      steps=5 * division, every=5 * division, contacts=contacts(1.0, friction=1e6))
        end = Run(text).frames("out.txt")[-1]
        most = 0.0
        for n in range(1, 17, 2):
            after = sum(math.hypot(*end[k][3:6])**2 + 0.4 * RADIUS**2 * math.hypot(*end[k][6:9])**2 for k in (n, n + 1))
            most = max(most, after / speed**2)
        return most


if __name__ == "__main__":
    unittest.main()
