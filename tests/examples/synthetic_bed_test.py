# SPDX-License-Identifier: BSD-3-Clause
"""The reading of a whole case whose tables are made here, with means that are known: all of figures.evaluate(), what
of it depends on entries of the case, and the curves of a study. No entry is that of the example's own case."""

import dataclasses
import json
import math
import sys
import tempfile
import unittest
import warnings
from pathlib import Path
from unittest import mock

import numpy as np

import curves
import run
import study
from cohesion_studies.bed import analyse, bed_case, figures
from cohesion_studies.bed.verdict import Study
from cohesion_studies.case_entries import EntryError
from cohesion_studies.study_table import TableError, write_summary

# Gas velocities and the ends of their steps, each changed within 1 ms.
DOWN = [(1.2, 0.8), (0.9, 0.9), (0.7, 1.0), (0.6, 1.1), (0.5, 1.2), (0.4, 1.3), (0.3, 1.4), (0.2, 1.5)]
UP = [(0.2, 1.7), (0.3, 1.8), (0.4, 1.9), (0.5, 2.0), (0.6, 2.1), (0.7, 2.2), (0.9, 2.3), (1.2, 2.6)]
STEPS = [*DOWN, (0.0, 1.6), *UP]
MINIMUM = {False: 0.72, True: 0.81}  # of falling and rising branch
FLUIDISED = {(0.9, False): 0.96, (1.2, False): 0.96, (0.9, True): 1.08, (1.2, True): 1.04}
AT_FIRST = 7.0  # in the first fifth of a step without bubbles, which is left out
SPREAD = 0.01  # of the five blocks of such a step: -2, -1, 0, 1, 2 times that
NOISE = 0.03  # up and down from sample to sample in the first step
WIDTH, HEIGHT, DEPTH, ACROSS, UP_CELLS, SHARE = 0.05, 0.1, 2e-3, 5, 10, 0.4
DENSITY, GRAVITY, PARTICLE_STEP = 2.0, 10.0, 1e-3
WEIGHT = 2.0  # N, until 0.8 s; from there it grows to 2.4 N at 2.6 s
ROUNDING = 1e-11  # of p, 1e4 m2/s2 with 16 digits, and sums of some 1000


def packed(velocity, rising):
    u = velocity / MINIMUM[rising]
    return 0.4 * u + 0.6 * u**2


def weight(time):
    return np.interp(time, (0.0, 0.8, 2.6), (WEIGHT, WEIGHT, 1.2 * WEIGHT))


def traces():
    """Times of a sample per ms, superficial velocity and pressure drop over the weight."""
    time = np.arange(1, 2601)
    velocity, ratio = np.zeros(len(time)), np.zeros(len(time))
    begin = 0
    for of, end in STEPS:
        rising = end > 1.6
        last = round(1000 * end)
        inside = (time > begin) & (time <= last)
        velocity[inside] = of
        if (of, rising) in FLUIDISED:
            ratio[inside] = FLUIDISED[of, rising]
        else:  # 20 ms, and 5 blocks of 16 ms
            blocks = SPREAD * np.repeat((-2, -1, 0, 1, 2), 16)
            ratio[inside] = np.concatenate((np.full(20, AT_FIRST), packed(of, rising) + blocks))
        begin = last
    ratio[time <= 800] += NOISE * np.where(time[time <= 800] % 2, 1, -1)
    return time / 1000, velocity, ratio


def field(rows):
    """A void fraction, rows from the plate up."""
    values = "\n".join(str(value) for row in rows for value in row)
    return f"internalField   nonuniform List<scalar> \n{ACROSS * UP_CELLS}\n(\n{values}\n)\n;\n"


def table(rows):
    return "# heading\n" + "".join(" ".join(map(repr, map(float, row))) + "\n" for row in rows)


def files():
    """{path in the case: its text}."""
    time, velocity, ratio = traces()
    ends = [0.0] + [end for _, end in STEPS]
    points = "".join(f"    ({begin + 0.001 * (begin > 0):.3f} (0 {of} 0))\n    ({end:.3f} (0 {of} 0))\n"
                     for (of, end), begin in zip(STEPS, ends))
    drop = ratio * weight(time) / (WIDTH * DEPTH)
    p = drop / DENSITY + GRAVITY * (HEIGHT - HEIGHT / UP_CELLS / 2)
    steps = np.arange(0, 2601, 100)  # of the particles
    written = weight(steps * PARTICLE_STEP)
    corners = "\n".join(f"({x} {y} {z})" for z in (-DEPTH / 2, DEPTH / 2) for y in (0, HEIGHT) for x in (0.01, 0.06))
    # At rest six full rows, of which the lowest and the highest do not count, nor the columns at the sides.
    rest = np.full((UP_CELLS, ACROSS), 0.9)
    rest[1:5, 1:4] = np.array([[0.40], [0.42], [0.44], [0.46]])
    plug = np.full((UP_CELLS, ACROSS), 0.5)
    plug[2], plug[6:] = 0.99, 1.0
    found = {
        "constant/bed": f"width 50;\nacross {ACROSS};\nup {UP_CELLS};\njetShare {SHARE};  // of the plate\n",
        "constant/polyMesh/points": f"8\n(\n{corners}\n)\n",
        "constant/transportProperties": f"rho {DENSITY};\nnu 1e-5;   // [m2/s]\n",
        "constant/g": f"dimensions [0 1 -2 0 0 0 0];\nvalue (0 -{GRAVITY} 0);\n",
        "constant/couplingProperties": f'demEngine lammps;\nliggghtsCoeffs\n{{\n    script "no";\n    dt 7;\n}}\n'
        f'lammpsCoeffs\n{{\n    script "$FOAM_CASE/in.bed";\n    variables\n    {{\n        dt {PARTICLE_STEP};\n'
        "        d 2e-3;\n    }\n}\n",
        "in.bed": "variable d index 1e-3\nvariable density equal 1500 # [kg/m3]\nvariable m equal PI/6*${d}^3\n",
        "constant/schedule": f"superficialVelocity table\n(\n{points});\nendTime 2.6;\n",
        "postProcessing/lowestPressure/0/volFieldValue.dat": table(zip(time, p)),
        "postProcessing/jetVelocity/0/surfaceFieldValue.dat": "# Time areaAverage(U)\n" + "".join(
            f"{t:.3f} (0 {v / SHARE!r} 0)\n" for t, v in zip(time.tolist(), velocity.tolist())),
        "bed.dat": table(zip(steps, written, np.full(len(steps), 0.062))),
        "walls.dat": table(zip(steps, 0.04 * written, -0.01 * written, -0.02 * written)),
        "postProcessing/mixing/0/mixingIndex.dat": table(
            (t, 0.2 if t == 0.1 else 9 if t < 0.3 else 0.4 * t if t < 1 else 0.65 if 1.501 < t <= 1.6 else 0.1, 0, 0)
            for t in np.arange(1, 26) / 10),
        # Mean velocities 1.05 and 0.7; an interval of the rising branch.
        "postProcessing/movement/0/particleMovement.dat": table(((0.9, 0.2, 0.005, 0, 0, 0, 0),
                                                                 (1.0, 0.1, 0.003, 0, 0, 0, 0),
                                                                 (2.25, 0.1, 0.009, 0, 0, 0, 0))),
        "postProcessing/forces/0/forceBudget.dat": table(
            (t, 0.01, 7, -2, 7, 7, 1.2, 7, 7, 0.7, 7, 7, 0.4, 7, 7, 0.3, 7) for t in np.arange(1, 261) / 100),
        "log.cohesiveBedFoam": "\nTime = 1" * 4 + "\n    particles  6.5 s, 65 %\n    exchange   0.02 s, 0.2 %\n"
        "    all        10 s, 100 %\n",
        "0.5/voidFraction": "internalField   uniform 1;\n",
        "0.7/voidFraction": field(plug),
        "1.5/voidFraction": field(plug),  # before the rest, and with little gas
        "1.52/voidFraction": field(plug),  # not the last at rest
        "1.59/voidFraction": field(rest),
    }
    return found


class Synthetic(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)
        self.case = self.make("case")

    def make(self, name):
        case = self.folder / name
        for file, text in files().items():
            (case / file).parent.mkdir(parents=True, exist_ok=True)
            (case / file).write_text(text)
        return case

    def change(self, file, old, new):
        text = (self.case / file).read_text()
        self.assertIn(old, text)
        (self.case / file).write_text(text.replace(old, new))

    def near(self, found, expected):
        np.testing.assert_allclose(found, expected, rtol=ROUNDING, atol=ROUNDING)


class Reading(Synthetic):
    def test_curve(self):
        """Each step without its first fifth, with the error of five blocks; what comes after the rest rises."""
        found = analyse.curve(self.case)
        self.assertEqual([(step.velocity, step.end) for step in found], STEPS)
        self.assertEqual([step.rising for step in found], 9 * [False] + len(UP) * [True])
        self.assertEqual([step.start for step in found], [0.0] + [round(end + 0.001, 3) for _, end in STEPS[:-1]])
        bubbling = [(step.velocity, step.rising) in FLUIDISED for step in found]
        self.near([step.ratio for step in found], [FLUIDISED.get((step.velocity, step.rising),
                                                                 packed(step.velocity, step.rising)) for step in found])
        # Deviation of -2, -1, 0, 1, 2: sqrt(10/4), of their mean over sqrt(5).
        self.near([step.ratio_error for step in found],
                  [0 if bubbles else SPREAD * math.sqrt(10 / 4 / 5) for bubbles in bubbling])

    def test_figures(self):
        found = figures.evaluate(self.case)
        single = figures.single(found)
        self.near([single[name] for name in ("U_mf_df", "U_mf_th")], [MINIMUM[False], MINIMUM[True]])
        # Above 1.1 x 0.81 m/s: from 0.301 to 0.9 s, and from 2.201 to 2.6 s; blocks of 0.2 s.
        blocks = (0.96, 0.96, 0.96, (1.08 + 1.04) / 2, 1.04)
        error = np.std(blocks, ddof=1) / math.sqrt(5)
        self.near(found["plateau"], (np.mean(blocks), error))
        self.near(found["balance"], (np.mean(blocks) + 0.04, error))
        # 0.40, 0.42, 0.44 and 0.46, three times each.
        self.near(found["void_fraction"], (0.43, math.sqrt(12 * 5e-4 / 11), math.sqrt(5e-4 / 11)))
        self.near([single[name] for name in ("mixing", "mixed", "movement", "movement_at")],
                  (0.4 / 0.8, 0.45 / 0.8, 0.003, 0.7))  # of an index that is 0.2 at the start
        # An empty bed at 0.5 s, a gap from wall to wall at 0.7 s.
        self.assertEqual((single["plugging"], single["widest_cavity"]), (0.5, 0.5))
        # What a sample differs by from its neighbours is twice the noise.
        self.near(found["noise"], 2 * NOISE / 0.96)
        self.near(found["forces"]["gain"], 0.3 / 2)
        self.assertEqual((found["seconds"], found["exchange_ms"]), ((10, 6.5), 5))

    def test_traces(self):
        time, velocity, ratio = traces()
        found = analyse.read_traces(self.case)
        self.assertEqual(found.time.tolist(), time.tolist())
        self.near(found.velocity, velocity)
        self.near(found.ratio, ratio)
        for name, expected in (("weight", weight(time)), ("height", 0.062), ("carried", 0.04 * weight(time)),
                               ("sides", -0.01 * weight(time)), ("plate_pull", -0.02 * weight(time)),
                               ("area", WIDTH * DEPTH)):
            self.near(getattr(found, name), expected)

    def test_an_engine_that_does_not_tell_the_pull(self):
        rows = np.loadtxt(self.case / "walls.dat")[:, :3]
        (self.case / "walls.dat").write_text(table(rows))
        found = analyse.read_traces(self.case)
        self.assertTrue(np.isnan(found.plate_pull).all())
        self.near(found.carried, 0.04 * found.weight)

    def test_bed_is_that_of_the_case(self):
        """The diameter is what the case sets, the density what the script has; mu = 2 x 1e-5 Pa s."""
        bed = analyse.Bed.read(self.case)
        self.near([bed.gas_density, bed.gas_viscosity, bed.gravity, bed.diameter, bed.density, bed.width, bed.height,
                   bed.depth, bed.node, bed.jet_share],
                  [DENSITY, 2e-5, GRAVITY, 2e-3, 1500, WIDTH, HEIGHT, DEPTH, 0.005, SHARE])
        self.assertEqual((bed.across, bed.up), (ACROSS, UP_CELLS))
        velocity = bed.minimum_fluidisation(0.43)
        gradient = (150 * 0.57**2 / 0.43**3 * 2e-5 / 4e-6 * velocity + 1.75 * 0.57 / 0.43**3 * 2 / 2e-3 * velocity**2)
        self.near(gradient / (0.57 * 1498 * 10), 1)

    def test_what_a_case_lacks_is_named(self):
        for file, old, new, says in (
                ("constant/transportProperties", "rho", "density", "transportProperties: no number 'rho'"),
                ("constant/g", "(0 -10", "($down", "g: no vector 'value'"),
                ("in.bed", "equal 1500", "string heavy", "in.bed: no number 'density'"),
                ("constant/couplingProperties", "lammpsCoeffs", "otherCoeffs", "no dictionary 'lammpsCoeffs'"),
                ("constant/couplingProperties", "demEngine", "engine", "no entry 'demEngine'"),
                ("log.cohesiveBedFoam", "all ", "some ", "log.cohesiveBedFoam: no summary 'all .*run to its end"),
                ("log.cohesiveBedFoam", "particles ", "some ", "log.cohesiveBedFoam: no summary 'particles "),
                ("log.cohesiveBedFoam", "exchange ", "some ", "log.cohesiveBedFoam: no summary 'exchange "),
                ("log.cohesiveBedFoam", "Time", "Step", "log.cohesiveBedFoam: no line 'Time = ...'"),
                ("constant/schedule", "0))", "0)", "schedule: no step of the gas velocity: two points")):
            with self.subTest(says):
                before = (self.case / file).read_text()
                self.change(file, old, new)
                with self.assertRaisesRegex(EntryError, says):
                    figures.evaluate(self.case)
                (self.case / file).write_text(before)

    def test_tables_of_another_run_are_refused(self):
        """Of each that is read: one that OpenFOAM wrote beside it, a folder of a later start, and none."""
        for name, file in (("lowestPressure", "volFieldValue"), ("jetVelocity", "surfaceFieldValue"),
                           ("mixing", "mixingIndex"), ("movement", "particleMovement"), ("forces", "forceBudget")):
            table = self.case / f"postProcessing/{name}/0/{file}.dat"
            again, later = table.with_name(f"{file}_0.dat"), self.case / f"postProcessing/{name}/1.5"
            with self.subTest(name):
                again.write_text(table.read_text())
                with self.assertRaisesRegex(EntryError, rf"{name}/0: {file}_0.dat beside {file}.dat: .*run it again"):
                    figures.evaluate(self.case)
                again.unlink()
                later.mkdir()
                with self.assertRaisesRegex(EntryError, f"{name}: tables from the starts 0, 1.5; .*from 0"):
                    figures.evaluate(self.case)
                later.rmdir()
                text = table.read_text()
                table.unlink()
                with self.assertRaisesRegex(EntryError, f"{file}.dat: no such table"):
                    figures.evaluate(self.case)
                table.write_text(text)
        # What else stands there is no table of another run.
        (self.case / "postProcessing/movement/places").mkdir()
        (self.case / "postProcessing/mixing/0/mixingIndex_old.dat").touch()
        figures.evaluate(self.case)


class Programs(unittest.TestCase):
    def test_differences_of_the_engines_stand_below_their_names(self):
        table = {engine: bed_case.parameters(engine) for engine in bed_case.ENGINES}
        results = {"lammps": [dict.fromkeys(study.PRINTED, 1.0 + k) for k in range(2)],
                   "liggghts": [dict.fromkeys(study.PRINTED, 3.0 + k) for k in range(2)]}
        *_, heads, line = study.text(table, results, dict.fromkeys(table, 0),
                                     dict.fromkeys(table, {"v_esc": 0.1})).splitlines()
        self.assertEqual(heads.split()[-len(study.COLUMNS):], list(study.COLUMNS))
        for name, digits in study.COLUMNS.items():
            self.assertTrue(line[heads.index(f"  {name}") + 2:].startswith(f"{2:+{digits}} ("), name)

    def test_a_seed_that_liggghts_would_not_take_is_refused_before_all(self):
        with mock.patch.object(sys, "argv", ["run.py", "--engine", "liggghts", "--seed", "5"]), \
                mock.patch.object(run, "environment", side_effect=AssertionError("begun")), \
                self.assertRaisesRegex(TableError, "LIGGGHTS takes primes above 10000, and 5 is none"):
            run.main()


class Plateau(Synthetic):
    def test_one_of_the_velocities_is_enough(self):
        """Whichever it is; without one, or with one that the gas is never above, there is no plateau, and no
        warning."""
        none, one = (math.nan, math.nan), (0.81, 0.0)

        def found(falling, rising):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                return analyse.plateau(self.case, analyse.Velocities(falling, rising, none, none, None))

        both = found(one, one)
        self.assertTrue(np.isfinite(both).all())
        self.assertEqual(found(one, none), both)
        self.assertEqual(found(none, one), both)
        # 1.1 x 0.815 m/s is below 0.9 m/s, 1.1 x 0.82 m/s above: 0.301 to 0.8 s and 2.301 to 2.6 s.
        self.assertEqual(found((0.815, 0.0), one), both)
        self.near(found(one, (0.82, 0.0))[0][0], np.mean((0.96, 0.96, (0.96 + 1.04) / 2, 1.04)))
        for without in (found(none, none), found((1.1, 0.0), none)):
            self.assertTrue(np.isnan(without).all())


class Curves(Synthetic):
    """Of a study whose folder has runs of other parameters and of another build as well."""

    TABLE = {"base": {"engine": "lammps", "A": 0, "law": "hamaker"}, "A-1": {"engine": "lammps", "A": 1e-19}}

    def run_of(self, name, build="this", unread=False, **settings):
        row, _, seed = name.rpartition("-")
        case = self.make(f"runs/{name}")
        (case / "result.json").write_text(json.dumps(
            {"settings": {**self.TABLE[row], "seed": int(seed), "fingerprint": build, **settings},
             **({"unread": True} if unread else {})}))
        return case

    def study(self, seeds):
        """Whose rows have so many."""
        results = {name: seeds * [{"processor_seconds": 3.0}] for name in self.TABLE}
        write_summary(self.folder / "summary.csv", self.TABLE, results)
        return Study(self.folder / "summary.csv")

    def test_runs_are_those_of_the_summary(self):
        ours = [self.run_of("base-7"), self.run_of("base-9")]
        self.run_of("base-11", A=1e-19)
        self.run_of("base-13", build="other")
        self.run_of("base-17", unread=True)
        self.run_of("A-1-7")
        self.assertEqual(curves.runs(self.folder, self.study(2), "base"), sorted(ours))
        self.assertEqual(curves.runs(self.folder, self.study(0), "base"), [])
        with self.assertRaisesRegex(curves.CurvesError, "the 3 runs of row 'base' in summary.csv"):
            curves.runs(self.folder, self.study(3), "base")
        # As many of the other build.
        self.run_of("base-15", build="other")
        with self.assertRaisesRegex(curves.CurvesError, "run study.py again"):
            curves.runs(self.folder, self.study(2), "base")

    def test_picture_has_means_in_bands(self):
        """The second run has 1.1 times the pressure of the first, of a gas of 1.1 times the density."""
        for name in ("base-7", "base-9", "A-1-7", "A-1-9"):
            self.run_of(name)
        drops = curves.curves(self.folder, self.study(2), "base")
        self.near(drops[1][0], [velocity for velocity, _ in UP])
        self.near(drops[1][1][1], drops[1][1][0])
        bed = analyse.Bed.read

        def denser(of):
            found = bed(of)
            factor = 1.1 if of.name.endswith("-9") else 1
            return dataclasses.replace(found, gas_density=factor * found.gas_density)

        with mock.patch.object(analyse.Bed, "read", denser), mock.patch.object(curves, "save") as save:
            curves.draw(self.folder, "picture.png")
        axes, = save.call_args.args[0].axes
        falling, rising, *_ = axes.lines
        self.near(rising.get_xdata(), drops[1][0])
        self.near(rising.get_ydata(), 1.05 * drops[1][1][0])
        self.assertEqual(falling.get_label(), "base: 3 s, 2 seeds")
        band = axes.collections[1].get_paths()[0].vertices[:, 1]
        self.near((band.min(), band.max()), (drops[1][1].min(), 1.1 * drops[1][1].max()))


if __name__ == "__main__":
    unittest.main()
