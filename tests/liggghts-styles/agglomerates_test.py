# SPDX-License-Identifier: BSD-3-Clause
"""fix agglomerates in LIGGGHTS: connected sets across faces and ranks against a search over all pairs;
how long particles belong to one, against straight flights; restarts; what is refused."""

import unittest

import numpy

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.scene import DENSITY, STIFFNESS, contact, hamaker, script, sphere, square_well
from cohesion_tests.theory.agglomerate_search import BOX, RANGE, Search, constructed, in_box, passing
from cohesion_tests.thermo import thermo_lines

MODELS = "model hooke/stiffness tangential off cohesion hamaker absolute_damping on"
# The attraction is none to speak of: the sum of the gaps' forces, 1e-12/(24 0.1^2), moves 1400 kg.
LAW = hamaker(1e-12, cut=1e-3, out=RANGE)
# Spheres of a ton that pass each other: a spring that would hold them.
STIFF = contact(stiffness=1e7)
FIELDS = "f_set " + " ".join(f"f_set[{k}]" for k in range(1, 9))


def scene(x, v=None, tilt=0.0, each=1, more="", fields=FIELDS, models=MODELS, properties=LAW,
          run="run 0\n", every=1, contacts=STIFF, more_columns=()):
    v = numpy.zeros_like(x) if v is None else v
    return script([sphere(a, b, radius=0.5) for a, b in zip(x, v)], models, properties, dt=1e-3,
                  skin=0.3, boundary="p p p", every=every, run=run,
                  box="0 {!r} 0 {!r} 0 {!r} {!r} 0 0".format(*BOX.tolist(), tilt),
                  columns=["f_set[1]", "f_set[2]", *more_columns],
                  contacts=contacts,
                  extra=f"fix set all agglomerates {each} {more}\n"
                  f"thermo_style custom step {fields}\nthermo_modify format float %.15g\n"
                  "thermo 100\n")


def rows(text, ranks=0):
    run = Run(text, ranks=ranks)
    if run.code:
        raise AssertionError(run.output[-3000:])
    return numpy.array(thermo_lines(run.output)[1])[:, 1:], run


class Sets(unittest.TestCase):
    def check(self, x, tilt, ranks):
        x = in_box(x, tilt)
        found = Search(x, tilt)
        values, run = rows(scene(x, tilt=tilt, more="sizes 5", fields=FIELDS + "".join(
            f" f_set[{size}][1]" for size in range(1, 6)), more_columns=["f_set[3]"]), ranks)
        # Sums of 300 squares of places in the box, below 1e5, over radii of 1 and more.
        numpy.testing.assert_allclose(values[0, :9], found.vector(), rtol=0, atol=1e-9)
        self.assertEqual(values[0, 9:].tolist(), found.sizes_up_to(5))
        frame = run.frames("out.txt")[0]
        table = numpy.array([frame[n] for n in sorted(frame)])
        numpy.testing.assert_array_equal(table[:, :2], found.of_each())
        # Mean squares below 200, rounded to 1e-13, over twice a radius of 0.5 and more.
        numpy.testing.assert_allclose(table[:, 2], found.gyration_of_each(), rtol=0, atol=1e-12)
        return found

    def test_constructed(self):
        for tilt, ranks in ((0.0, 0), (2.0, 2), (-4.5, 4), (4.5, 0)):
            with self.subTest(tilt=tilt, ranks=ranks):
                found = self.check(constructed(), tilt, ranks)
                self.assertEqual(sorted(found.sizes[found.sizes > 0]), [1, 2, 5, 6, 10])
                self.assertEqual(len(found.wraps), 1)
        # Straight up through the sheared face, back to itself only where the images stand above.
        up = numpy.array([[5.0, 1.0 * k, 3.0] for k in range(8)])
        self.assertEqual([len(self.check(up, tilt, 2).wraps) for tilt in (0.0, 3.0)], [1, 0])

    def test_types_without_attraction_are_not_bound(self):
        # 1 and 2 attract; 2 and 3 do not, nor do 3 and 4, of the other type.
        x = numpy.array([[1.0, 4.0, 3.0], [2.05, 4.0, 3.0], [3.1, 4.0, 3.0], [4.15, 4.0, 3.0]])
        law = LAW.replace("1e-12 1e-12 1e-12 1e-12", "1e-12 0 0 0")
        self.assertNotEqual(law, LAW)
        text = scene(x, properties=law)
        text = text.replace("fix set all", "set atom 3*4 type 2\nfix set all")
        self.assertEqual(Search(x, 0.0).sizes.tolist(), [4, 0, 0, 0])
        _, run = rows(text)
        frame = run.frames("out.txt")[0]
        numpy.testing.assert_array_equal([frame[n] for n in sorted(frame)], [[1, 2], [1, 2], [0, 1], [0, 1]])

    def test_range_of_the_hamaker_attraction(self):
        """Grains at rest are bound up to a gap of H_out, in either scheme, though H_cut is far below, as in LAMMPS. Rows of
        three, the third across a periodic face from the first: three, two and two are bound, and none."""
        d, out, side = 75e-6, 1e-7, 1e-3
        gaps = ((0.2, 0.2), (0.99, 1.01), (1.01, 0.99), (1.01, 1.01))  # over H_out
        grains = [sphere((x, (k + 0.5) * side / 4, side / 2), radius=d / 2) for k, (near, across) in enumerate(gaps)
                  for x in (d / 4, d / 4 + d + near * out, side + d / 4 - d - across * out)]
        for scheme in ("exact", "sampled"):
            for ranks in (0, 2):
                with self.subTest(scheme=scheme, ranks=ranks):
                    text = script(grains, MODELS + f" scheme {scheme}", hamaker(1e-19, cut=4e-10, out=out), dt=1e-9,
                                  skin=2e-5, boundary="p p p", box=f"0 {side} 0 {side} 0 {side}", run="run 1\n",
                                  contacts=contact(stiffness=50.0),
                                  extra="fix set all agglomerates 1 sizes 3\nthermo 1\n"
                                  "thermo_style custom step f_set[1] f_set[2][1] f_set[3][1]\n")
                    for row in rows(text, ranks)[0]:
                        self.assertEqual(row.tolist(), [3, 2, 1])

    def test_random(self):
        random = numpy.random.default_rng(3)
        for number, ranks in ((60, 2), (110, 0), (110, 4)):
            with self.subTest(number=number, ranks=ranks):
                found = self.check(random.uniform(0, 1, (number, 3)) * BOX, 3.3, ranks)
                self.assertGreater(len(set(found.sizes)), 4)


class Durations(unittest.TestCase):
    FIELDS = FIELDS + " f_set[3][2]"

    def test_durations_and_mean_size_over_time(self):
        x, v, first, second = passing()
        dt, end, last = 1e-3, 3.5, (first[0], second[1])
        durations = [b - a for a, b in (first, second, last)]
        for ranks, each in ((0, 1), (2, 1), (0, 10)):
            with self.subTest(ranks=ranks, each=each):
                table, _ = rows(scene(x, v, each=each, fields=self.FIELDS, run="run 3500\n", every=3500),
                                ranks)
                unit, final = each * dt, table[-1]
                self.assertEqual((final[1], final[6]), (0, 3))
                # Entry and exit are each seen at the next look: off by less than the time between.
                self.assertLess(abs(final[5] - numpy.mean(durations)), unit)
                three = first[1] - second[0]
                mean = 2.0 + three / (last[1] - last[0])
                self.assertLess(abs(final[3] - mean), 3 * unit / (last[1] - last[0]))
                self.assertLess(abs(final[9] - three / end), 2 * unit / end)
                self.assertEqual(table[[18, 21, 26], 2].tolist(), [2, 3, 2])

    def test_one_that_splits_in_a_step(self):
        """A row of five through a face, of which the last two leave together: one agglomerate at one look, two at
        the next, nobody without partner in between."""
        for axis, ranks in ((0, 0), (0, 2), (1, 2)):
            with self.subTest(axis=axis, ranks=ranks):
                x, v = numpy.full((5, 3), 3.0), numpy.zeros((5, 3))
                x[:, axis] = BOX[axis] - 2.05 + 1.05 * numpy.arange(5)
                v[3:, axis] = 1.0
                # The gap of 0.0505 passes the range of 0.2 in the middle of step 150.
                x[3:, axis] += 0.0005
                text = scene(x % BOX, v, fields=FIELDS + " f_set[2][1] f_set[3][1] f_set[5][1]", run="run 200\n")
                table, run = rows(text.replace("thermo 100\n", "thermo 1\n"), ranks)
                one = numpy.arange(201) < 150
                for column, before, after in ((1, 1, 2), (2, 5, 2.5), (9, 0, 1), (10, 0, 1), (11, 1, 0)):
                    numpy.testing.assert_array_equal(table[:, column], numpy.where(one, before, after))
                self.assertEqual(abs(table[:, 6]).max(), 0)  # no duration has ended
                sets = [[frame[n] for n in sorted(frame)] for frame in run.frames("out.txt")]
                numpy.testing.assert_array_equal(sets[149], [[1, 5]] * 5)
                numpy.testing.assert_array_equal(sets[150], [[1, 3]] * 3 + [[4, 2]] * 2)

    def test_one_that_was_there_at_the_start_is_not_counted(self):
        x = numpy.array([[3.0, 4.0, 3.0], [4.1, 4.0, 3.0]])
        v = numpy.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
        table, _ = rows(scene(x, v, run="run 300\n"))
        self.assertEqual(table[0, 1], 1)
        self.assertEqual(table[-1, [1, 6]].tolist(), [0, 0])

    def test_runs_that_are_split_or_restarted(self):
        x, v, _, _ = passing()
        text = scene(x, v, fields=self.FIELDS, run="", every=3500)
        again = ("clear\nunits si\natom_style granular\natom_modify map array\nboundary p p p\n"
                 "newton off\ncommunicate single vel yes\nread_restart half\nneighbor 0.3 bin\n"
                 "neigh_modify delay 0\n" + text[text.index("fix E all"):])
        whole = rows(text + "run 3500\n")[0][-1].tolist()
        for name, ranks, tail in (
                ("split", 0, "run 1700\nrun 1800\n"),
                ("command", 0, f"run 2100\nwrite_restart half\n{again}run 1400\n"),
                ("file", 2, f"restart 2100 half.*\nrun 2100\nshell mv half.2100 half\n{again}run 1400\n")):
            with self.subTest(name):
                self.assertEqual(rows(text + tail, ranks)[0][-1].tolist(), whole)

    def test_in_a_well(self):
        """Through the gap of the well, a half swing of the spring, and out again, faster inside."""
        stiffness, ratio = 8e6, 1.2
        words = "model hooke/stiffness tangential off cohesion square_well absolute_damping on scheme "
        x = numpy.array([[3.0, 4.0, 3.0], [4.5, 4.0, 3.0]])
        v = numpy.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
        reduced = DENSITY * numpy.pi / 12
        # Without depth no edge is resolved.
        for depth, scheme in ((100.0, "sampled"), (100.0, "exact"), (0.0, "sampled"), (0.0, "exact")):
            with self.subTest(depth=depth, scheme=scheme):
                duration = (2 * (ratio - 1) / numpy.sqrt(1 + 2 * depth / reduced)
                            + numpy.pi * numpy.sqrt(reduced / stiffness))
                final = rows(scene(x, v, models=words + scheme, properties=square_well(depth, ratio=ratio),
                                   contacts=contact().replace(repr(STIFFNESS), repr(stiffness)),
                                   run="run 1000\n", every=1000))[0][-1]
                self.assertEqual((final[1], final[6]), (0, 2))
                # Each edge is met up to a step late, at up to twice the speed.
                self.assertLess(abs(final[5] - duration), 3e-3)


class Refusals(unittest.TestCase):
    def stops(self, text, *words):
        assert_refused(self, Run(text), *words)

    def test_refused(self):
        x = numpy.array([[5.0, 4.0, 3.0], [6.1, 4.0, 3.0]])
        self.stops(scene(x, each=0), "N is 0", "1 or more")
        self.stops(scene(x, more="sizes 1"), "sizes 1", "2 or more")
        self.stops(scene(x, more="gap 1"), "gap 1", "sizes M")
        self.stops(scene(x, models="model hooke tangential off", properties=""),
                   "no pair_style says which pairs are bound", "cohesion models hamaker, jkr, liquid_bridge, square_well")


if __name__ == "__main__":
    unittest.main()
