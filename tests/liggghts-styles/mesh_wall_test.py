# SPDX-License-Identifier: BSD-3-Clause
"""A wall made of triangles attracts as the primitive wall of the same shape, however many triangles
it is made of, and once where a particle is above a border of them."""

import math
import unittest

from cohesion_tests.liggghts import EPSILON
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import (CUT, MASS, OUT, RADIUS, RATIO, STIFFNESS, frames, hamaker, part,
                                                  sphere, square_well)

A, DEPTH = 1e-14, 1e-10
WIDTH = (RATIO - 1) * RADIUS
FLAT = {1: [((-0.03, -0.03, 0), (0.03, -0.03, 0), (0.0, 0.03, 0))],
        2: rectangle((-0.009, -0.009, 0), (0.018, 0, 0), (0, 0.018, 0)),
        200: rectangle((-0.009, -0.009, 0), (0.018, 0, 0), (0, 0.018, 0), 10)}
CELL = 0.0018  # of the 200
MODELS = "model hooke/stiffness tangential history cohesion "
# The engine takes the plane from the nodes, sides of triangles and normals, each rounded at the size of
# the mesh; the distance from it is then good to a few roundings of 0.03 m, and of H_cut at the least.
PLACE = 8 * EPSILON * 0.03


def attraction(gap):
    return A * RADIUS / (6 * max(gap, CUT)**2) if gap < OUT else 0.0


def both(triangles, spheres, cohesion, properties, primitive, **options):
    """Frames with the mesh, and with primitive walls."""
    models = MODELS + cohesion
    yield frames(spheres, models, properties, walls=wall(models), inputs={"plate.stl": stl(triangles)},
                 **options)
    yield frames(spheres, models, properties, walls=[f"primitive type 2 {p}" for p in primitive],
                 **options)


class Planes(unittest.TestCase):
    def test_at_rest_on_faces_borders_and_nodes(self):
        places = [(0, 0), (CELL, CELL), (-2 * CELL, CELL),  # nodes of the 200
                  (0.5 * CELL, 3 * CELL), (-3 * CELL, 0.3 * CELL),  # their straight sides
                  (2.4 * CELL, 2.4 * CELL), (-2.5 * CELL, 1.5 * CELL),  # and diagonals
                  (1.3e-3, -3.1e-3), (-2.77e-3, 4.1e-3)]
        models = MODELS + "hamaker"
        for gap in (-2e-6, 0.5 * CUT, 3e-6, 0.9 * OUT):
            spheres = [sphere((x, y, RADIUS + gap)) for x, y in places]
            plane = frames(spheres, models, hamaker(A), walls=["primitive type 2 zplane 0"])
            for cells, triangles in FLAT.items():
                with self.subTest(triangles=cells, gap=gap):
                    mesh, own = (frames(spheres, models, hamaker(constant), walls=wall(models),
                                        inputs={"plate.stl": stl(triangles)}) for constant in (A, 0))
                    slope = 2 * attraction(gap) / max(gap, CUT) + STIFFNESS
                    for number in plane[0]:
                        ours, spring = (part(f[0][number], "f") for f in (mesh, own))
                        self.assertEqual(ours[:2], spring[:2])
                        self.assertAlmostEqual(ours[2] - spring[2], -attraction(gap),
                                               delta=slope * PLACE)
                        if gap > 0 or cells < 200:  # on a node the engine may count its spring twice
                            for f, expected in zip(ours, part(plane[0][number], "f")):
                                self.assertAlmostEqual(f, expected, delta=slope * PLACE)

    def sliding(self, cohesion, properties, gap, velocity, steps, dt):
        """Frames of spheres that start at different places of a cell and cross borders and nodes;
        largest deviations of force and velocity from the primitive wall's, and the forces."""
        starts = [(-4e-3, -4e-3), (-4e-3, 0.0), (-3 * CELL + 0.2e-3, 2 * CELL + 1e-7)]
        spheres = [sphere((x, y, RADIUS + gap), velocity) for x, y in starts]
        for cells in FLAT:
            mesh, plane = both(FLAT[cells], spheres, cohesion, properties, ["zplane 0"], dt=dt,
                               steps=steps, every=1)
            self.assertEqual(len(mesh), steps + 1)
            yield cells, mesh, plane

    def deviation(self, mesh, plane, what):
        return max(math.dist(part(m[n], what), part(p[n], what))
                   for m, p in zip(mesh, plane) for n in p)

    def test_sliding_over_borders_across_a_gap(self):
        # 4 mm, two cells, at a height where hardly anything but the attraction acts.
        for cells, mesh, plane in self.sliding("hamaker", hamaker(A), 8e-6, (4.0, 2.0, 0.0), 1000, 1e-6):
            with self.subTest(triangles=cells):
                force = max(abs(part(p[1], "f")[2]) for p in plane)
                self.assertGreater(force, 0.5 * attraction(8e-6))
                self.assertLess(self.deviation(mesh, plane, "f"), 1e-6 * force)
                self.assertLess(self.deviation(mesh, plane, "v"), 1e-6 * 1e-3)

    def test_sliding_in_contact(self):
        for cells, mesh, plane in self.sliding("hamaker", hamaker(1e-12), -1e-6, (4.0, 2.0, 0.0), 1000,
                                               1e-6):
            with self.subTest(triangles=cells):
                force = max(abs(part(p[1], "f")[2]) for p in plane)
                self.assertLess(self.deviation(mesh, plane, "f"), 1e-6 * force)
                self.assertLess(self.deviation(mesh, plane, "v"), 1e-6)

    def test_two_ranks_equal_one(self):
        # The triangles around x = 0, and the sphere, are on both ranks.
        for cohesion, properties in (("hamaker", hamaker(A)), ("square_well", square_well(0, DEPTH))):
            models = MODELS + cohesion
            one, two = (frames([sphere((-1e-3, 3e-3, RADIUS + 3e-6), (4.0, 2.0, -5e-3))], models,
                               properties, walls=wall(models), steps=500, ranks=ranks,
                               inputs={"plate.stl": stl(FLAT[200])}) for ranks in (1, 2))
            self.assertGreater(one[-1][1][0], 0.5e-3)
            for a, b in zip(one, two):
                for value, other in zip(part(a[1], "v"), part(b[1], "v")):
                    self.assertAlmostEqual(value, other, delta=1e-6 * 5e-3)

    def test_across_a_periodic_boundary(self):
        # The mesh ends at x = 0.01, where its image begins.
        floor = rectangle((-0.01, -0.009, 0), (0.02, 0, 0), (0, 0.018, 0), 10)
        flights = [sphere((0.0095, y, RADIUS + 4e-6), (4.0, 2.0, -5e-3)) for y in (-4e-3, 0.0, 1.1e-3)]
        for cohesion, properties in (("hamaker", hamaker(A)), ("square_well", square_well(0, DEPTH))):
            mesh, plane = both(floor, flights, cohesion, properties, ["zplane 0"], boundary="p f f",
                               steps=500)
            self.assertLess(plane[-1][1][0], -5e-3)
            self.assertLess(self.deviation(mesh, plane, "v"), 1e-6 * 5e-3)

    def test_in_the_well_over_borders(self):
        # Captured: up and down between floor and edge on the way over two cells.
        for cells, mesh, plane in self.sliding("square_well", square_well(0.0, DEPTH), 3e-6,
                                               (4.0, 2.0, -5e-3), 2000, 1e-6):
            with self.subTest(triangles=cells):
                turns = sum(a[1][5] < 0 < b[1][5] for a, b in zip(plane, plane[1:]))
                self.assertGreater(turns, 0)
                self.assertLess(self.deviation(mesh, plane, "v"), 1e-6 * 5e-3)


class Corners(unittest.TestCase):
    SIDES = (rectangle((-8e-3, -8e-3, 0), (16e-3, 0, 0), (0, 16e-3, 0))
             + rectangle((-8e-3, -8e-3, 0), (16e-3, 0, 0), (0, 0, 8e-3))
             + rectangle((-8e-3, -8e-3, 0), (0, 16e-3, 0), (0, 0, 8e-3)))
    PLANES = ["xplane -8e-3", "yplane -8e-3", "zplane 0"]

    def test_in_an_edge_and_a_corner_each_side_attracts(self):
        near = -8e-3 + RADIUS + 3e-6
        spheres = [sphere((near, near, RADIUS + 4e-6)), sphere((near, 1e-3, RADIUS + 4e-6)),
                   sphere((2e-3, near, RADIUS - 1e-6)), sphere((5e-3, 5e-3, RADIUS + 4e-6))]
        mesh, planes = both(self.SIDES, spheres, "hamaker", hamaker(A), self.PLANES, steps=0)
        for number, sides in zip(planes[0], (3, 2, 2, 1)):
            ours, expected = part(mesh[0][number], "f"), part(planes[0][number], "f")
            self.assertEqual(sum(f != 0 for f in expected), sides)
            for k in range(3):
                self.assertAlmostEqual(ours[k], expected[k], delta=1e-6 * max(map(abs, expected)))

    def test_a_well_in_a_corner(self):
        near = -8e-3 + RADIUS
        spheres = [sphere((near + 8e-6, near + 9e-6, RADIUS + 7e-6), (-0.02, -0.03, -0.04)),
                   sphere((near + 8e-6, 1e-3, RADIUS + 7e-6), (-0.02, -1.0, -0.04))]
        mesh, planes = both(self.SIDES, spheres, "square_well", square_well(0, DEPTH), self.PLANES,
                            steps=1500)
        for number in planes[0]:
            # They turn back from the wall at x, which they meet at 0.02 m/s or more.
            start = spheres[number - 1]["velocity"]
            self.assertGreater(max(math.dist(part(f[number], "v"), start) for f in planes), 0.02)
            for k in range(3):
                self.assertAlmostEqual(part(mesh[-1][number], "v")[k],
                                       part(planes[-1][number], "v")[k], delta=1e-6 * 0.05)


class Ridges(unittest.TestCase):
    """Two rectangles that meet at y = 0 in a ridge, the sides falling off at an angle."""

    ANGLE = math.radians(20)
    DOWN = (math.cos(ANGLE), -math.sin(ANGLE))
    LEFT = rectangle((-8e-3, 0, 0), (16e-3, 0, 0), (0, -8e-3 * DOWN[0], 8e-3 * DOWN[1]), 3)
    RIGHT = rectangle((-8e-3, 0, 0), (16e-3, 0, 0), (0, 8e-3 * DOWN[0], 8e-3 * DOWN[1]), 3)

    def distance(self, y, z):
        """Of a point above the ridge, and the direction from the nearest point."""
        for sign in (-1, 1):
            along = sign * y * self.DOWN[0] + z * self.DOWN[1]
            if along > 0:
                normal = (sign * -self.DOWN[1], self.DOWN[0])
                return y * normal[0] + z * normal[1], normal
        r = math.hypot(y, z)
        return r, (y / r, z / r)

    def test_once_above_a_side_and_above_the_ridge(self):
        # Places at the same gap, around the ridge; both orders of the triangles in the file.
        heights = RADIUS + 3e-6
        spheres = []
        for k in range(-10, 11):
            turn = k / 10 * 2 * self.ANGLE  # beyond ANGLE: above a side, near the ridge
            inside = max(abs(turn) - self.ANGLE, 0.0)
            along = RADIUS * inside * math.copysign(1, turn)
            turn = max(-self.ANGLE, min(self.ANGLE, turn))
            y = heights * math.sin(turn) + along * self.DOWN[0]
            z = heights * math.cos(turn) + abs(along) * self.DOWN[1]
            spheres.append(sphere((-7e-3 + 0.7e-3 * (k + 10) * 1.0, y, z)))
        spheres = [s for n, s in enumerate(spheres) if n % 2 == 0], spheres[1::2]
        for triangles in (self.LEFT + self.RIGHT, self.RIGHT + self.LEFT):
            for some in spheres:
                models = MODELS + "hamaker"
                got = frames(some, models, hamaker(A), walls=wall(models),
                             inputs={"plate.stl": stl(triangles)})[0]
                for number, s in enumerate(some, 1):
                    r, normal = self.distance(*s["place"][1:])
                    expected = attraction(r - RADIUS)
                    f = part(got[number], "f")
                    tolerance = 2 * expected / 3e-6 * PLACE
                    self.assertAlmostEqual(f[0], 0, delta=tolerance)
                    self.assertAlmostEqual(f[1], -expected * normal[0], delta=tolerance)
                    self.assertAlmostEqual(f[2], -expected * normal[1], delta=tolerance)

    def test_the_well_is_kept_from_side_to_ridge_to_side(self):
        # Along one side inside its well, over the ridge, and out of it on the other side: the energy
        # changes once, by the depth, and in the other direction, or inwards, too.
        speed, start = 0.5, 30e-6
        place = (-start * self.DOWN[0], start * self.DOWN[1])
        up = (-self.DOWN[1], self.DOWN[0])  # normal of the right side
        for triangles in (self.LEFT + self.RIGHT, self.RIGHT + self.LEFT):
            for sign in (-1, 1):
                y = sign * (place[0] - up[0] * (RADIUS + 2e-6))
                z = place[1] + up[1] * (RADIUS + 2e-6)
                flight = sphere((1e-3, y, z), (0, sign * speed * self.DOWN[0], -speed * self.DOWN[1]))
                models = MODELS + "square_well"
                got = frames([flight], models, square_well(0, DEPTH), walls=wall(models), dt=1e-6,
                             steps=300, inputs={"plate.stl": stl(triangles)})
                energy = [0.5 * MASS * sum(v * v for v in part(f[1], "v")) for f in got]
                start_gap, end_gap = (self.distance(*got[k][1][1:3])[0] - RADIUS for k in (0, -1))
                self.assertLess(start_gap, WIDTH)
                self.assertGreater(end_gap, WIDTH)
                changed = [e for e in energy if abs(e - energy[0]) > 1e-6 * DEPTH]
                self.assertAlmostEqual(energy[-1] - energy[0], -DEPTH, delta=1e-6 * DEPTH)
                self.assertTrue(all(e < energy[0] for e in changed))


if __name__ == "__main__":
    unittest.main()
