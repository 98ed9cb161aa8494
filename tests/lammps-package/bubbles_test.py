# SPDX-License-Identifier: BSD-3-Clause
"""fix bubbles in the real LAMMPS: the flow of the nozzles, counts and volumes that add up, mergers and breaks that keep
momentum and centre of mass, the same to the last digit on any number of ranks and over a restart, and what bad input
gets."""
import re
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from cohesion_tests import lammps as engine
from cohesion_tests.refusals import assert_refused

VOLUME = np.pi / 6 * 0.08**3
HEAD = """plugin load ${plugin}
units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
comm_modify vel yes
region box block 0 1 0 1 0 3
create_box 1 box
pair_style zero 0.25
pair_coeff * *
neighbor 0.02 bin
neigh_modify delay 0 every 1 check yes
timestep 2e-3
fix move all nve/sphere
"""
# No forces between bubbles, so that nothing depends on an order of sums; they weave, larger ones as fast as small ones.
PATHS = """variable fx atom mass*6*sin(3*id+9*z)
variable fy atom mass*6*cos(5*id+7*z)
fix weave all addforce v_fx v_fy 0
fix rise all gravity 4 vector 0 0 1
variable drag atom -4*mass*vz
variable dragx atom -4*mass*vx
variable dragy atom -4*mass*vy
fix drag all addforce v_dragx v_dragy v_drag
"""
BUBBLES = ("fix bubbles all bubbles 5 nozzles 5 5 0.5 0.5 0.1 0.13 0.05 0.08 density 0.4 velocity 0.5 top 2.7 merge 0.16 "
           "break 0.14 0.3 grow 0.11\n")
ASK = "print 'sums {}'\n".format(" ".join(f"$(f_bubbles[{k}]:%.17g)" for k in range(1, 10)))
DUMP = ("dump all all custom 1 last.dump id x y z vx vy vz radius mass\ndump_modify all sort id format float %.17g\n"
        "run 0 post no\n")


def sums(output):
    return [np.array(line.split(), float) for line in re.findall(r"^sums (.*)$", output, re.M)]


def run(folder, text, ranks=1):
    code, output = engine.run_text(text, folder, ranks=ranks)
    assert code == 0, output[-3000:]
    return output


class Population(unittest.TestCase):
    def test_adds_up_on_any_ranks(self):
        found = {}
        for ranks in (1, 2, 4):
            with engine.temporary_folder() as folder:
                output = run(folder, HEAD + PATHS + BUBBLES + "run 2000\n" + ASK + DUMP, ranks)
                found[ranks] = sums(output)[0], engine.dump(folder, "last.dump")
        injected, volume, removed, removed_volume, merged, broken, pending, inside, inside_volume = found[1][0]
        self.assertGreater(merged, 20)
        self.assertGreater(broken, 5)
        self.assertGreater(removed, 50)
        self.assertEqual(inside, injected - removed - merged + broken)
        # Some 1e3 sums and cube roots of numbers that are rounded to 1e-16.
        self.assertAlmostEqual((inside_volume + removed_volume) / volume, 1, delta=1e-12)
        # Some that had to wait are larger.
        self.assertGreater(volume, injected * VOLUME * (1 + 1e-6))
        self.assertLess(volume, injected * VOLUME * (0.11 / 0.08)**3)
        # Injected volume: the flow, less the pending volume, with the start that the nozzles had, 25 parts of a bubble.
        self.assertAlmostEqual(volume + pending, 0.05 * 4, delta=25 * VOLUME)
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                # The sums of volumes inside are over ranks.
                np.testing.assert_array_equal(found[ranks][0][:8], found[1][0][:8])
                self.assertAlmostEqual(found[ranks][0][8] / inside_volume, 1, delta=1e-13)
                np.testing.assert_array_equal(found[ranks][1], found[1][1])

    def test_over_a_restart(self):
        with engine.temporary_folder() as folder:
            whole = run(folder, HEAD + PATHS + BUBBLES + "run 703\nrun 497\n" + ASK + DUMP)
            there = engine.dump(folder, "last.dump")
            run(folder, HEAD + PATHS + BUBBLES + "run 703\nwrite_restart half.restart\n")
            again = ("plugin load ${plugin}\nnewton off\ncomm_modify vel yes\nread_restart half.restart\n"
                     "timestep 2e-3\nneighbor 0.02 bin\nneigh_modify delay 0 every 1 check yes\nfix move all nve/sphere\n")
            second = run(folder, again + PATHS + BUBBLES + "run 497\n" + ASK + DUMP)
            np.testing.assert_array_equal(sums(second)[0][:8], sums(whole)[0][:8])
            np.testing.assert_array_equal(engine.dump(folder, "last.dump"), there)
            code, other = engine.run_text(again + PATHS + BUBBLES.replace("5 5 0.5", "5 4 0.5") + "run 1\n", folder)
            assert_refused(self, code, other, "is of 25 nozzles", "the script has 20")

    def test_pair_merges_and_breaks(self):
        """Two that meet: volume, momentum and centre of mass, and the same of the halves when it is too large."""
        atoms = [{"type": 1, "diameter": 0.1, "density": 0.4, "x": (0.5, 0.45, 1.0), "v": (0.0, 0.3, 0.2)},
                 {"type": 1, "diameter": 0.06, "density": 0.4, "x": (0.5, 0.55, 1.0), "v": (0.1, -0.3, 0.1)}]
        masses = np.array([0.4 * np.pi / 6 * a["diameter"]**3 for a in atoms])
        momentum = masses @ np.array([a["v"] for a in atoms])
        for rule, number in (("merge 0.2", 1), ("merge 0.2 break 0.1 1", 2), ("merge 0.103", 2)):
            for ranks in (1, 2):
                with self.subTest(rule=rule, ranks=ranks), engine.temporary_folder() as folder:
                    engine.write_spheres(folder, atoms, [(0, 1), (0, 1), (0, 3)], 1)
                    head = HEAD.replace("region box block 0 1 0 1 0 3\ncreate_box 1 box\n", "read_data data.spheres\n")
                    output = run(folder, head + f"fix bubbles all bubbles 1 {rule}\nrun 100\n" + ASK + DUMP, ranks)
                    last = engine.dump(folder, "last.dump")
                    mass, x, v = last[:, 8], last[:, 1:4], last[:, 4:7]
                    self.assertEqual(len(mass), number)
                    # Rounding of 100 steps of positions and velocities up to 1.
                    np.testing.assert_allclose(mass @ v, momentum, atol=1e-15 * masses.sum())
                    start = masses @ np.array([a["x"] for a in atoms])
                    np.testing.assert_allclose(mass @ x, start + momentum * 0.2, atol=1e-13 * masses.sum())
                    self.assertAlmostEqual(sums(output)[0][8] / (masses.sum() / 0.4), 1, delta=1e-14)
                    self.assertEqual(sums(output)[0][4], 0 if rule == "merge 0.103" else 1)


class Refusals(unittest.TestCase):
    def test_words(self):
        good = "nozzles 5 5 0.5 0.5 0.1 0.13 0.05 0.08 density 0.4"
        cases = [("0 " + good, "N is 0"), ("5 nozzles 5 5 0.5", "'nozzles' takes 'NX NY x y z spacing Q d'"),
                 ("5 " + good.replace("density 0.4", ""), "need the 'density'"),
                 ("5 " + good.replace("0.08", "-0.08"), "diameter of the bubbles = -0.08"),
                 ("5 " + good.replace("5 5", "0 5"), "nozzles along x = 0"),
                 ("5 " + good + " merge 0", "merge 0; it must be greater than zero"),
                 ("5 " + good + " break 0.1 -1", "break rests -1"), ("5 " + good + " melt 3", "unknown keyword 'melt'"),
                 ("5 " + good + " top", "keyword 'top' takes a value"), ("5 " + good + " type 2", "type 2"),
                 ("5 " + good + " grow 0.05", "volume that bubbles grow to"),
                 ("5 merge 1 grow 0.1", "'grow' is of the bubbles of nozzles"),
                 ("5 " + good + " grow 0.3", "is not within the box"),
                 ("5 " + good + " top 1 top 2", "'top' is there twice"),
                 ("5 " + good.replace("0.5 0.5 0.1 0.13", "0.5 0.5 0.01 0.13"), "is not within the box")]

        def one(case):
            with engine.temporary_folder() as folder:
                return engine.run_text(HEAD + f"fix bubbles all bubbles {case[0]}\nrun 1\n", folder)
        with ThreadPoolExecutor(2) as pool:
            for case, (code, output) in zip(cases, pool.map(one, cases)):
                with self.subTest(case=case):
                    assert_refused(self, code, output, *case[1:])


if __name__ == "__main__":
    unittest.main()
