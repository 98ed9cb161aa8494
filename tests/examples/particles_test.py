# SPDX-License-Identifier: BSD-3-Clause
"""The reading of mixing, movement, plugs and forces on tables whose answer is known."""

import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from cohesion_studies.bed import analyse, bed_case, geometry, particles


def write(case, name, kind, rows):
    """Table of the function object `name`."""
    folder = case / f"postProcessing/{name}/0"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{kind}.dat").write_text("# Time ...\n" + "".join("\t".join(map(str, row)) + "\n" for row in rows))


class MixingAndMovement(unittest.TestCase):
    """Of gas that falls from 0.9 m/s by 0.1 m/s each second, rests from 4 s on, and rises again at 5 s."""

    SCHEDULE = [(float(k), k + 1.0, velocity) for k, velocity in enumerate((0.9, 0.8, 0.7, 0.6, 0.0, 0.77))]

    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.case = Path(keeper.name)
        time = np.arange(0, 6, 0.001) + 0.0005
        velocity = np.array([v for _, _, v in self.SCHEDULE])[time.astype(int)]
        for name, value in (("read_schedule", self.SCHEDULE),
                            ("read_traces", types.SimpleNamespace(time=time, velocity=velocity))):
            change = mock.patch.object(particles, name, return_value=value)
            change.start()
            self.addCleanup(change.stop)

    def test_mixing_in_the_first_step_and_at_rest(self):
        write(self.case, "mixing", "mixingIndex", [(t, 0.05 + 0.4 * t, 30, 4000) for t in (0.1, 0.3, 0.4, 1.0)]
                   + [(1.1, 0.9, 30, 4000), (4.0, 0.1, 30, 4000), (4.2, 0.6, 30, 4000), (5.0, 0.7, 30, 4000),
                      (5.1, 0.8, 30, 4000)])
        rate, mixed = particles.mixing(self.case)
        # From 0.09 at the start: of what is left to 1.
        self.assertAlmostEqual(rate, 0.4 / 0.91, places=12)
        self.assertAlmostEqual(mixed, (0.65 - 0.09) / 0.91, places=12)

    def test_mixing_is_not_read_of_a_short_first_step(self):
        """Of 0.65 s without the 0.3 s of the start, and of 0.71 s."""
        rows = [(t, 0.5 * t**2 if t < 0.3 else 0.4 * t, 30, 4000) for t in np.arange(0, 0.7, 0.01)]
        write(self.case, "mixing", "mixingIndex", rows + [(4.5, 0.6, 30, 4000)])
        for end, expected in ((0.65, np.nan), (0.71, 0.4)):
            analyse_schedule = [(0.0, end, 0.9), *self.SCHEDULE[1:]]
            with mock.patch.object(particles, "read_schedule", return_value=analyse_schedule):
                rate, mixed = particles.mixing(self.case)
            np.testing.assert_allclose(rate, expected, rtol=1e-12)
            self.assertEqual(mixed, 0.6)

    def test_movement_where_the_falling_gas_has_the_velocity(self):
        # Mean velocities 0.85, 0.76, 0.7, 0.6; none on the rising branch, which has 0.77 itself.
        ends = ((1.5, 1.0), (2.4, 1.0), (3.0, 0.5), (4.0, 0.5), (5.8, 0.5))
        write(self.case, "movement", "particleMovement",
                   [(end, over, 0.001 * k, 0, 0, 0, 4000) for k, (end, over) in enumerate(ends)])
        found, velocity = particles.movement(self.case)
        self.assertEqual(found, 0.001)
        self.assertAlmostEqual(velocity, 0.76, places=10)

    def test_no_interval_on_the_falling_branch(self):
        write(self.case, "movement", "particleMovement", [(5.8, 0.5, 0.002, 0, 0, 0, 4000)])
        self.assertTrue(np.isnan(particles.movement(self.case)).all())
        write(self.case, "movement", "particleMovement", [])
        with self.assertWarns(UserWarning):
            self.assertTrue(np.isnan(particles.movement(self.case)).all())


class Plugs(unittest.TestCase):
    """Eight rows of three cells: written at 0.2 s, in the start-up, at 0.4 to 0.8 s, and at 1.5 s with little gas."""

    PACKED, GAP, SPRAY = [0.4, 0.5, 0.4], [1.0, 0.97, 0.95], [0.9, 0.95, 0.9]

    def share(self, *beds, read=particles.plugging):
        times = (0.2, 0.4, 0.6, 0.8, 1.5)
        time = np.arange(0, 2, 0.001)
        traces = types.SimpleNamespace(time=time, velocity=np.where(time < 1, 1.2, 0.5))
        with mock.patch.object(particles, "read_traces", return_value=traces), \
                mock.patch.object(analyse, "written_times", return_value=dict(zip(times, beds))), \
                mock.patch.object(analyse, "void_fraction", lambda _, bed: np.array(bed)):
            return read("case")

    def test_a_gap_across_below_a_row_of_the_bed(self):
        bed = 4 * [self.PACKED] + 4 * [[1.0, 1.0, 1.0]]
        split = 2 * [self.PACKED] + [self.GAP] + 2 * [self.PACKED] + 3 * [[1.0, 1.0, 1.0]]
        lifted = [self.GAP] + bed[:-1]
        bubble = 2 * [self.PACKED] + [[1.0, 1.0, 0.5]] + bed[3:]
        raining = 2 * [self.PACKED] + [self.SPRAY] + bed[3:]
        sprayed = 4 * [self.PACKED] + [self.GAP, self.SPRAY] + 2 * [[1.0, 1.0, 1.0]]
        self.assertEqual(self.share(split, bed, bubble, raining, split), 0.0)
        self.assertEqual(self.share(bed, split, lifted, bed, bed), 2 / 3)
        self.assertEqual(self.share(bed, sprayed, bed, split, split), 1 / 3)
        self.assertTrue(np.isnan(self.share(bed)))

    def test_the_widest_cavity_below_the_bed(self):
        """A bubble of one cell, a gap across of which a third is left, none: 1/3, 1 and 0 of the width."""
        bed = 4 * [self.PACKED] + 4 * [[1.0, 1.0, 1.0]]
        bubble = [self.PACKED, [0.4, 0.9, 0.5]] + bed[2:]
        gap = [self.PACKED, [0.9, 0.85, 0.95]] + bed[2:]
        self.assertAlmostEqual(self.share(bed, bubble, gap, bed, gap, read=particles.widest_cavity), 4 / 9, places=12)
        self.assertTrue(np.isnan(self.share(bed, read=particles.widest_cavity)))


class Forces(unittest.TestCase):
    def test_of_a_step_without_its_first_fifth(self):
        """Weight 2 N; drag, pressure and gain, and the walls' forces, differ in the first fifth and after the step."""
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder)
            # time, over, and gravity, drag, pressure, others, gain: x, y, z each.
            write(case, "forces", "forceBudget",
                  [(t, over, 7, -2, 7, 7, drag, 7, 7, 0.5, 7, 7, 7, 7, 7, gain, 7)
                   for t, over, drag, gain in ((1.2, 0.1, 50, 50), (1.5, 0.3, 1.0, 0.2), (2.0, 0.5, 1.8, 0.6),
                                               (2.1, 0.1, 50, 50))])
            steps = np.arange(1000, 2201, 50)  # of 1 ms; a row is the mean since the one before
            inside = (steps > 1200) & (steps <= 2000)
            walls = [np.where(inside, force, 9) for force in (0.3, -0.1, -0.7)]
            np.savetxt(case / "walls.dat", np.column_stack([steps, *walls]))
            with mock.patch.object(analyse, "particle_step", return_value=1e-3):
                found = particles.forces(case, analyse.Step(1.0, 1.0, 2.0, 1.0, 0.0, True))
                none = particles.forces(case, analyse.Step(1.0, 3.0, 4.0, 1.0, 0.0, True))
                np.savetxt(case / "walls.dat", np.column_stack([steps, *walls[:2]]))
                liggghts = particles.forces(case, analyse.Step(1.0, 1.0, 2.0, 1.0, 0.0, True))
        # Means over 0.3 and 0.5 s: drag 1.5, gain 0.45.
        for name, expected in {"drag": 0.75, "pressure": 0.25, "sides": -0.05, "plate": 0.2, "plate_pull": -0.35,
                               "gain": 0.225, "unclosed": -0.075}.items():
            self.assertAlmostEqual(found[name], expected, places=12)
        self.assertTrue(np.isnan(list(none.values())).all())
        self.assertTrue(np.isnan(liggghts.pop("plate_pull")))
        self.assertEqual(liggghts, {name: found[name] for name in liggghts})


class Width(unittest.TestCase):
    def test_the_case_is_what_its_geometry_writes(self):
        case = bed_case.CASE
        bed = geometry.Geometry.read(case)
        self.assertEqual((bed, bed.text()), (geometry.Geometry(), (case / geometry.FILE).read_text()))
        coupling = (case / "constant/couplingProperties").read_text()
        # The scripts' variables: width, and the node with four digits.
        self.assertEqual(coupling.count(f"width   {bed.width};"), 2)
        self.assertEqual(coupling.count(f"node    {1e3 * bed.node:.3f}e-3;"), 2)

    def test_another_is_read_as_written(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "constant").mkdir()
            for bed in (geometry.Geometry(0.04, 13, 30), geometry.Geometry(0.12, 41, 45)):
                (Path(folder) / geometry.FILE).write_text(bed.text())
                self.assertEqual(geometry.Geometry.read(folder), bed)
                self.assertEqual(bed.text().count("1e-4 1)"), (bed.across - 1) // 2)


if __name__ == "__main__":
    unittest.main()
