# SPDX-License-Identifier: BSD-3-Clause
"""'scheme event', the former name of 'scheme exact': the run warns of it in one line and is otherwise the same."""
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import RADIUS, hamaker, liquid_bridge, script, sphere, square_well

LAWS = {"hamaker": hamaker(1e-18), "square_well": square_well(1e-11), "liquid_bridge": liquid_bridge(1e-4, 1e-5)}
LINE = "scheme 'event' is now called 'exact'; write 'exact', since from version 0.4.0 on the old word stops the run"
# A pair that approaches, and a sphere that presses on a floor.
SPHERES = [sphere((0, 0, 0), (0.1, 0, 0)), sphere((1.98 * RADIUS, 0, 0)), sphere((0.005, 0, -0.0095), (0, 0, -0.1))]
FLOOR = "primitive type 2 zplane -0.01"


class SchemeEvent(unittest.TestCase):
    def end(self, law, of_pairs, of_walls, ranks=0):
        """What was printed, and the frames of the dump."""
        models = f"model hooke/stiffness tangential off cohesion {law}"
        walls = [f"fix {name} all wall/gran {models} {plane} {of_walls}"
                 for name, plane in (("floor", FLOOR), ("lid", FLOOR.replace("-0.01", "0.01")))]
        run = Run(script(SPHERES, f"{models} {of_pairs}", LAWS[law], walls=walls, run="run 10\nrun 10\n"), ranks=ranks)
        self.assertEqual(run.code, 0, run.output[-2000:])
        return " ".join(run.output.split()), run.files["out.txt"]

    def test_taken_with_one_line(self):
        for law in LAWS:
            for ranks in (0, 2) if law == "hamaker" else (0,):
                with self.subTest(law, ranks=ranks):
                    right, expected = self.end(law, "scheme exact", "scheme exact", ranks)
                    self.assertNotIn("is now called", right)
                    self.assertIn(f"cohesion model {law}, scheme exact: what to expect", right)
                    output, found = self.end(law, "scheme event", "scheme event", ranks)
                    self.assertEqual(output.count("is now called"), 1, output)
                    self.assertIn(f"WARNING: cohesion model {law}: {LINE}", output)
                    self.assertEqual(found, expected)

    def test_of_a_wall_alone(self):
        output, _ = self.end("hamaker", "scheme exact", "scheme event")
        self.assertEqual(output.count("is now called"), 1, output)

    def test_the_default(self):
        default, found = self.end("hamaker", "", "")
        self.assertIn("cohesion model hamaker, scheme sampled: what to expect", default)
        self.assertEqual(found, self.end("hamaker", "scheme sampled", "scheme sampled")[1])
        self.assertNotEqual(found, self.end("hamaker", "scheme exact", "scheme exact")[1])


if __name__ == "__main__":
    unittest.main()
