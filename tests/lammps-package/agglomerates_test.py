# SPDX-License-Identifier: BSD-3-Clause
"""fix agglomerates: connected sets across faces and ranks against a search over all pairs; how long
particles belong to one, against straight flights."""
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.refusals import assert_refused
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory.agglomerate_search import BOX, RANGE, Search, constructed, in_box, passing
from cohesion_tests.thermo import thermo_end, thermo_lines

# The attraction is none to speak of at the gaps of the flights: 1e-12/(24 0.1^2) = 4e-12.
LAW = (f"pair_style gran/hamaker scheme sampled\npair_coeff * * stiffness 800 restitution 1 hamaker "
       f"1e-12 cutoff 1e-3 {RANGE}\n")
HEAD = """
plugin load ${plugin}
units lj
atom_style sphere
newton off
boundary p p p
box tilt large
comm_modify vel yes
neighbor 0.3 bin
neigh_modify delay 0 every 1 check yes
read_data data.spheres
""" + LAW
FIELDS = "f_set " + " ".join(f"f_set[{k}]" for k in range(1, 9))


class Agglomerates(FolderTestCase):
    def write(self, x, v=None, tilt=0.0, folder=None):
        v = numpy.zeros_like(x) if v is None else v
        engine.write_spheres(folder or self.folder, [
            {"type": 1, "diameter": 1.0, "density": 1.0, "x": a, "v": b} for a, b in zip(x, v)],
            [(0.0, side) for side in BOX], 1, tilt=(tilt, 0.0, 0.0))

    def run_script(self, text, folder=None, **options):
        code, output = engine.run_text(text, folder or self.folder, **options)
        self.assertEqual(code, 0, output[-3000:])
        return output

    def check_all(self, cases):
        """The cases side by side: a start is mostly waiting."""
        with ThreadPoolExecutor(4) as pool:
            return list(pool.map(lambda case: self.check_sets(*case), cases))

    def check_sets(self, x, tilt, ranks):
        with engine.temporary_folder() as folder:
            return self.check_sets_in(folder, x, tilt, ranks)

    def check_sets_in(self, folder, x, tilt, ranks):
        x = in_box(x, tilt)
        self.write(x, tilt=tilt, folder=folder)
        output = self.run_script(
            HEAD + "fix set all agglomerates 1 sizes 5\nfix move all nve/sphere\ntimestep 0.001\n"
            "dump out all custom 1 out.txt id f_set[1] f_set[2] f_set[3]\ndump_modify out format float %.15g\n"
            f"thermo_style custom step {FIELDS} f_set[1][1] f_set[2][1] f_set[3][1] f_set[4][1] "
            "f_set[5][1]\nthermo_modify format float %.15g\nrun 0\n", folder, ranks=ranks)
        found = Search(x, tilt)
        values = thermo_lines(output)[1][0][1:]
        # Sums of 300 squares of places in the box, below 1e5, over radii of 1 and more.
        numpy.testing.assert_allclose(values[:9], found.vector(), rtol=0, atol=1e-9)
        self.assertEqual(values[9:], found.sizes_up_to(5))
        table = engine.dump(folder, "out.txt")
        numpy.testing.assert_array_equal(table[:, 1:3], found.of_each())
        # Mean squares below 200, rounded to 1e-13, over twice a radius of 0.5 and more.
        numpy.testing.assert_allclose(table[:, 3], found.gyration_of_each(), rtol=0, atol=1e-12)
        return found

    def test_constructed(self):
        """A chain through all three faces, a ring around a corner, one bound to its own image along
        the flow and one along the gradient, a pair, a single one."""
        x = constructed()
        for found in self.check_all([(x, 0.0, 1), (x, 2.0, 2), (x, -4.5, 4), (x, 4.5, 1)]):
            self.assertEqual(sorted(found.sizes[found.sizes > 0]), [1, 2, 5, 6, 10])
            self.assertEqual(len(found.wraps), 1)
        # Straight up through the sheared face, back to itself only where the images stand above.
        up = numpy.array([[5.0, 1.0 * k, 3.0] for k in range(8)])
        straight, shifted = self.check_all([(up, 0.0, 2), (up, 3.0, 2)])
        self.assertEqual((len(straight.wraps), len(shifted.wraps)), (1, 0))

    def test_random(self):
        random = numpy.random.default_rng(3)
        cases = [(random.uniform(0, 1, (number, 3)) * BOX, 3.3, ranks)
                 for number, ranks in ((60, 2), (110, 1), (110, 4))]
        for found in self.check_all(cases):
            self.assertGreater(len(set(found.sizes)), 4)

    FLIGHT = HEAD + "fix set all agglomerates 1\nfix move all nve/sphere\ntimestep 0.001\n"

    def test_durations_and_mean_size_over_time(self):
        x, v, first, second = passing()
        self.write(x, v)
        last = (first[0], second[1])
        dt, end = 0.005, 3.5
        durations = [b - a for a, b in (first, second, last)]
        for ranks, each in ((1, 1), (2, 1), (1, 10)):
            with self.subTest(ranks=ranks, each=each):
                output = self.run_script(
                    self.FLIGHT.replace("agglomerates 1", f"agglomerates {each}") + f"timestep {dt}\n"
                    f"thermo 20\nthermo_style custom step {FIELDS} f_set[3][2] f_set[1][2]\n"
                    f"thermo_modify format float %.15g\nrun {round(end / dt)}\n", ranks=ranks)
                names, rows = thermo_lines(output)
                row = dict(zip(names, rows[-1]))
                self.assertEqual(row["f_set[6]"], 3)
                # Entry and exit are each seen at the next look: off by less than the time between.
                unit = each * dt
                self.assertLess(abs(row["f_set[5]"] - numpy.mean(durations)), unit)
                self.assertAlmostEqual(row["f_set[5]"] * 3 / unit,
                                       round(row["f_set[5]"] * 3 / unit), 6)
                three = first[1] - second[0]
                mean = 2.0 + three / (last[1] - last[0])
                self.assertLess(abs(row["f_set[3]"] - mean), 3 * unit / (last[1] - last[0]))
                self.assertLess(abs(row["f_set[3][2]"] - three / end), 2 * unit / end)
                self.assertEqual(row["f_set[1]"], 0)
                sizes = [r[names.index("f_set[2]")] for r in rows]
                self.assertEqual(sizes[18], 2)
                self.assertEqual(sizes[21], 3)
                self.assertEqual(sizes[26], 2)
                fractions = [r[names.index("f_set[4]")] for r in rows]
                self.assertAlmostEqual(fractions[0], 1 / 3)
                self.assertAlmostEqual(fractions[21], 1.0)

    def test_duration_of_a_collision(self):
        """In and out again in the exact scheme: half a swing of the spring, and twice the way through the attraction,
        up to H_out."""
        self.write(numpy.array([[4.0, 4.0, 3.0], [5.5, 4.0, 3.0]]),
                   numpy.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]]))
        end = thermo_end(self.run_script(
            self.FLIGHT.replace(LAW, "pair_style gran/hamaker\npair_coeff * * stiffness 800 "
                                "restitution 1 hamaker 1e-9 cutoff 1e-3 1e-2\n") +
            f"thermo_style custom step {FIELDS}\nthermo_modify format float %.15g\nrun 700\n"))
        # Adhesion 1e-9/(24 1e-6) = 4e-5 against a force of 14: it changes the time by 1e-5 of it.
        duration = numpy.pi / numpy.sqrt(800 / (numpy.pi / 12)) + 2 * 1e-2
        self.assertEqual(end["f_set[6]"], 2)
        self.assertLess(abs(end["f_set[5]"] - duration), 0.001)

    def test_one_that_splits_in_a_step(self):
        """A row of five through a face, of which the last two leave together: one agglomerate at one look,
        two at the next, nobody without partner in between."""
        for axis, ranks in ((0, 1), (0, 2), (1, 2)):
            with self.subTest(axis=axis, ranks=ranks):
                x, v = numpy.full((5, 3), 3.0), numpy.zeros((5, 3))
                x[:, axis] = BOX[axis] - 2.05 + 1.05 * numpy.arange(5)
                v[3:, axis] = 1.0
                # The gap of 0.0505 passes the range of 0.2 in the middle of step 150.
                x[3:, axis] += 0.0005
                self.write(x % BOX, v)
                output = self.run_script(
                    self.FLIGHT + "dump out all custom 1 out.txt id f_set[1] f_set[2]\n"
                    f"thermo 1\nthermo_style custom step {FIELDS} f_set[2][1] f_set[3][1] f_set[5][1]\n"
                    "thermo_modify format float %.15g\nrun 200\n", ranks=ranks)
                names, rows = thermo_lines(output)
                table = dict(zip(names, numpy.array(rows).T))
                one = numpy.arange(201) < 150
                numpy.testing.assert_array_equal(table["f_set[1]"], numpy.where(one, 1, 2))
                numpy.testing.assert_array_equal(table["f_set[2]"], numpy.where(one, 5, 2.5))
                for size, of_two in ((2, 1), (3, 1)):
                    numpy.testing.assert_array_equal(table[f"f_set[{size}][1]"],
                                                     numpy.where(one, 0, of_two))
                numpy.testing.assert_array_equal(table["f_set[5][1]"], one)
                self.assertEqual(abs(table["f_set[6]"]).max(), 0)  # no duration has ended
                sets = numpy.array(engine.dumps(self.folder, "out.txt"))
                numpy.testing.assert_array_equal(sets[149, :, 1:], [[1, 5]] * 5)
                numpy.testing.assert_array_equal(sets[150, :, 1:], [[1, 3]] * 3 + [[4, 2]] * 2)

    def test_runs_that_are_split_or_restarted(self):
        x, v, _, _ = passing()
        self.write(x, v)
        tail = f"thermo_style custom step {FIELDS} f_set[3][2]\nthermo_modify format float %.15g\n"
        whole = thermo_end(self.run_script(
            self.FLIGHT + tail + "restart 2100 half.*\nrun 3500\n"))
        split = thermo_end(self.run_script(self.FLIGHT + tail + "run 1700\nrun 1800\n"))
        self.assertEqual(split, whole)
        for ranks in (1, 2):
            again = thermo_end(self.run_script(
                "plugin load ${plugin}\nnewton off\nread_restart half.2100\ncomm_modify vel yes\n"
                "neighbor 0.3 bin\nneigh_modify delay 0 every 1 check yes\n" + LAW +
                "fix set all agglomerates 1\nfix move all nve/sphere\ntimestep 0.001\n" + tail +
                "run 1400\n", ranks=ranks))
            self.assertEqual(again, whole)

    def test_steps_of_restart_files(self):
        """A sphere is hit just below a face and leaves through it in the very step that a restart file is
        written, for which it is put back into the box: its partner is still beside it. With restitution
        0.1 the two are held from then on, with 1 never, whatever velocity the image has."""
        law = "pair_style hard/squarewell\npair_coeff * * restitution {} well 0.05 1.2\n"
        columns = [f"f_{name}[{k}]" for name in ("set", "held") for k in (1, 7, 8)]

        def rows(axis, restitution, ranks, more):
            x, v = numpy.full((2, 3), 3.0), numpy.zeros((2, 3))
            x[:, axis] = BOX[axis] - numpy.array([0.002, 1.005])  # the cores meet after 0.003
            v[1, axis] = 1.0
            with engine.temporary_folder() as folder:
                self.write(x, v, folder=folder)
                output = self.run_script(
                    HEAD.replace(LAW, law.format(restitution)) + "fix set all agglomerates 1\n"
                    "fix held all agglomerates 1 partners held\n"
                    "fix shear all deform/shear rate 0.05 profile no\nfix move all nve/sphere\n"
                    f"timestep 0.01\nthermo 1\nthermo_style custom step {' '.join(columns)}\n"
                    f"thermo_modify format float %.15g\n{more}run 5\n", folder, ranks=ranks)
            return numpy.array(thermo_lines(output)[1])[:, 1:]

        # Each axis, of which two ranks cut one, with both restitutions, on one rank or on two.
        cases = [(axis, e, 1 + (axis + (e < 1)) % 2) for axis in range(3) for e in (0.1, 1)]
        with ThreadPoolExecutor(4) as pool:
            found = list(pool.map(lambda case: [rows(*case, more) for more in
                                                ("", "restart 1 a.restart b.restart\n")], cases))
        for (axis, e, ranks), (without, with_files) in zip(cases, found):
            with self.subTest(axis=axis, restitution=e, ranks=ranks):
                held = numpy.array([0, *5 * [e < 1]])
                numpy.testing.assert_array_equal(without[:, [0, 2, 5]],
                                                 numpy.array([1 + 0 * held, 0 * held, 0 * held]).T)
                numpy.testing.assert_array_equal(without[:, 3], held)
                # Half the distance, which is 1 to 1.05.
                self.assertLess(abs(without[:, 1] - 0.51).max(), 0.02)
                # Places are rounded to 2^-44 of the box for the restart file, 5e-13.
                numpy.testing.assert_allclose(with_files, without, rtol=0, atol=1e-11)

    def test_frozen_pairs_without_and_with_depth(self):
        """No contact is resolved between particles that nothing moves, whether the well is deep or D = 0: of a
        frozen row of three and a sphere that overlaps its end, only the latter two are bound."""
        x = numpy.array([[4.0 + 0.99 * k, 4.0, 3.0] for k in range(4)])
        law = ("pair_style squarewell\npair_coeff * * well {} 1.2\n"
               "group frozen id 1 2 3\ngroup free id 4\n")
        for depth in (0, 1e-9):
            for ranks in (1, 2):
                with self.subTest(depth=depth, ranks=ranks):
                    self.write(x)
                    self.run_script(
                        HEAD.replace(LAW, law.format(depth)) +
                        "fix set all agglomerates 1\nfix move free nve/sphere\ntimestep 0.001\n"
                        "dump out all custom 5 out.txt id f_set[1] f_set[2]\nrun 10\n", ranks=ranks)
                    for table in engine.dumps(self.folder, "out.txt"):
                        numpy.testing.assert_array_equal(table[:, 1:], [[0, 1], [0, 1], [3, 2], [3, 2]])

    def test_range_of_the_hamaker_attraction(self):
        """Grains at rest are bound up to a gap of H_out, in either scheme, though H_cut is far below. Rows of three, the
        third across a periodic face from the first: three, two and two are bound, and none."""
        d, out, side = 75e-6, 1e-7, 1e-3
        rows = ((0.2, 0.2), (0.99, 1.01), (1.01, 0.99), (1.01, 1.01))  # gaps over H_out
        grains = "".join(f"create_atoms 1 single {x:.17g} {(k + 0.5) * side / 4} 0.5e-3\n"
                         for k, (near, across) in enumerate(rows)
                         for x in (d / 4, d / 4 + d + near * out, side + d / 4 - d - across * out))
        for scheme in ("exact", "sampled"):
            for ranks in (1, 2):
                with self.subTest(scheme=scheme, ranks=ranks):
                    output = self.run_script(f"""plugin load ${{plugin}}
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
region box block 0 {side} 0 {side} 0 {side}
create_box 1 box
neighbor 2e-5 bin
{grains}set group all diameter {d}
set group all density 1500
pair_style gran/hamaker scheme {scheme}
pair_coeff * * stiffness 50 restitution 0.5 hamaker 1e-19 cutoff 4e-10 {out}
fix move all nve/sphere
fix set all agglomerates 1 sizes 3
timestep 1e-9
thermo 1
thermo_style custom step f_set[1] f_set[2][1] f_set[3][1]
run 1
""", ranks=ranks)
                    for row in thermo_lines(output)[1]:
                        self.assertEqual(row[1:], [3, 2, 1])

    def test_one_that_was_there_at_the_start_is_not_counted(self):
        x = numpy.array([[5.0, 4.0, 3.0], [6.1, 4.0, 3.0]])
        self.write(x, numpy.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]))
        end = thermo_end(self.run_script(
            self.FLIGHT + f"thermo_style custom step {FIELDS}\nrun 200\n"))
        self.assertEqual((end["f_set[1]"], end["f_set[6]"]), (0, 0))

    def test_held_pairs_of_a_square_well(self):
        """A pair that flies through each other's well beside the core is bound for a while and never held;
        one that meets head on and keeps (0.1)^2 of its energy is held from the collision on."""
        x = numpy.array([[4.0, 2.0, 3.0], [6.0, 3.1, 3.0], [4.0, 6.0, 3.0], [6.0, 6.0, 3.0]])
        v = numpy.array([[1.0, 0, 0], [-1.0, 0, 0], [1.0, 0, 0], [-1.0, 0, 0]])
        self.write(x, v)
        head = HEAD.replace(LAW, "pair_style hard/squarewell\npair_coeff * * restitution 0.1 well 0.05 1.2\n")
        for ranks in (1, 2):  # of two ranks each has one of each pair at first
            with self.subTest(ranks=ranks):
                output = self.run_script(
                    head + "fix set all agglomerates 1\nfix held all agglomerates 1 partners held\n"
                    "fix move all nve/sphere\ntimestep 0.01\nthermo 1\n"
                    "thermo_style custom step f_set f_held f_held[2]\nrun 150\n", ranks=ranks)
                table = {int(row[0]): row[1:] for row in thermo_lines(output)[1]}
                # Edge at 1.2: the head-on pair enters it at t = (2 - 1.2)/2 = 0.4, faster inside, and collides
                # before 0.5; the other is in while the way along x is below sqrt(1.2^2 - 1.1^2) = 0.48, near
                # t = 1; the well bends it to 1.05 from the other centre, not on to the core.
                self.assertEqual(table[41][:2], [1, 0])
                self.assertEqual(table[55][:2], [1, 1])
                self.assertEqual(table[100], [2, 1, 2])
                self.assertEqual(table[150], [1, 1, 2])

    def test_hybrid_and_refusals(self):
        self.write(numpy.array([[5.0, 4.0, 3.0], [6.1, 4.0, 3.0]]))
        tail = "fix move all nve/sphere\ntimestep 0.001\n"
        hybrid = HEAD.replace("pair_style gran/hamaker", "pair_style hybrid/overlay zero 1.0 "
                              "gran/hamaker").replace("* * stiffness", "* * gran/hamaker stiffness")
        output = self.run_script(hybrid + "pair_coeff * * zero\nfix set all agglomerates 1\n" + tail +
                                 "thermo_style custom step f_set\nrun 0\n")
        self.assertEqual(thermo_end(output)["f_set"], 1)
        zero = HEAD.replace(LAW, "pair_style zero 1.0\npair_coeff * *\n")
        cases = (
            (zero + "fix set all agglomerates 1\n" + tail + "run 0\n", ["no pair_style", "gran/hamaker"]),
            (HEAD + "fix set all agglomerates 0\n", ["N is 0", "1 or more"]),
            (HEAD + "fix set all agglomerates 1 sizes 1\n", ["sizes 1", "2 or more"]),
            (HEAD + "fix set all agglomerates 1 gap 1\n", ["gap 1", "sizes M"]),
            (HEAD + "fix set all agglomerates 1 partners some\n", ["partners some", "partners held"]),
            (HEAD + "fix set all agglomerates 1 sizes\n", ["sizes M"]),
            (zero.replace("newton off", "newton on") + "fix set all agglomerates 1\n" + tail +
             "run 0\n", ["newton off"]))

        def refused(case):
            with engine.temporary_folder() as folder:
                self.write(numpy.array([[5.0, 4.0, 3.0], [6.1, 4.0, 3.0]]), folder=folder)
                return engine.run_text(case[0], folder)
        with ThreadPoolExecutor(4) as pool:
            outputs = list(pool.map(refused, cases))
        for (_, words), (code, output) in zip(cases, outputs):
            assert_refused(self, code, output, *words)


if __name__ == "__main__":
    unittest.main()
