# SPDX-License-Identifier: BSD-3-Clause
"""bed_study.py BUILD_FOLDER: run.py and study.py of examples/fluidised-bed with beds of 0.018 s: the
parameters of a row reach its case, what is done is not made again."""

import contextlib
import csv
import io
import math
import re
import shutil
import subprocess
import unittest
from pathlib import Path
from unittest import mock

import run
import study
from cohesion_studies.bed import bed_case, figures, geometry
from cohesion_studies.bed.analyse import read_columns
from cohesion_studies.bed.bed_case import parameters
from cohesion_studies.foam_case import CaseError, environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.lammps_run import launcher
from cohesion_tests.narrow_bed import make_narrow
from small_beds import BUILD, SmallBeds, variables

TABLE = ("name, A, cohesion_side, settle, scheme\n"
         "none, 0, , 0.01, sampled\nno-side, 7.49e-19, 0, 0.01, sampled\n")
OTHERS = ("name, A, settle, voidFraction, smoothingWidth, scheme, law, D, ratio\n"
          "smooth, 0, 0.01, sphereOverlap, 1e-3, sampled, , ,\nexact, 7.49e-19, 0.01, , , , , ,\n"
          "well, , 0.01, , , exact, square_well, 5e-11, 1.02\n")


def restitution(stiffness, damping, mass):
    """Of a linear spring and dashpot whose contact ends where the surfaces part."""
    beta = damping / 2 / mass
    return math.exp(-math.pi * beta / math.sqrt(stiffness / mass - beta**2))


class Beds(SmallBeds):
    def setUp(self):
        super().setUp()
        make_narrow(self.folder / "case")

    def test_a_table_of_beds(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text(TABLE)
        words = (study, table, "--seeds", 1, 3, "--out", out)
        self.assertIn("no-side", self.call(*words))
        for name, A, side in (("none", 0, 1), ("no-side", 7.49e-19, 0)):
            for seed in (1, 3):
                case = out / "runs" / f"{name}-{seed}"
                found = variables(case)
                self.assertEqual({**found, "A": A, "cohesion_side": side, "cohesion_plate": 1,
                                  "settle": 0.01, "seed": seed}, found)
                told = (case / "log.lammps").read_text()
                self.assertEqual("\nfix side_adhesion" in told, False)
                self.assertEqual("\nfix plate_adhesion" in told, A > 0)
        with open(out / "summary.csv") as file:
            rows = {row["name"]: row for row in csv.DictReader(file)}
        self.assertEqual(list(rows), ["none", "no-side"])
        # Seeds 1 and 3: mean 2, deviation sqrt(2).
        self.assertEqual([rows["none"][k] for k in ("seeds", "U_mf_df", "U_mf_df_sd", "cohesion_side")],
                         ["2", "2", "1.41", "1"])
        # A log is of one start: none begins when all is done.
        stamps = [file.stat().st_mtime_ns for file in sorted(out.glob("runs/*/log.blockMesh"))]
        self.assertIn("4 of 4 runs are done", self.call(*words))
        self.assertEqual(stamps,
                         [file.stat().st_mtime_ns for file in sorted(out.glob("runs/*/log.blockMesh"))])

    @unittest.skipUnless((BUILD / "openfoam/libcohesionLiggghtsEngine.so").exists(), "built without LIGGGHTS")
    def test_beds_of_both_engines(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text("name, engine, A, settle\na, lammps, 1e-19, 0.01\nb, liggghts, 1e-19, 0.01\n"
                         "other, liggghts, 0, 0.01\n")
        words = ("--seeds", 10007, 10009)
        *_, heading, line, _, _ = self.call(study, table, *words, "--out", out).splitlines()
        for name, engine, A in (("a", "lammps", 1e-19), ("b", "liggghts", 1e-19), ("other", "liggghts", 0)):
            for seed in words[1:]:
                case = out / "runs" / f"{name}-{seed}"
                self.assertEqual(variables(case, engine)["A"], A)
                self.assertEqual(variables(case, engine)["seed"], seed)
                self.assertTrue((case / f"log.{engine}").exists())
        with open(out / "summary.csv") as file:
            self.assertEqual([row["engine"] for row in csv.DictReader(file)], ["lammps", "liggghts", "liggghts"])
        # The same figures: only of the same bed, in the heading's errors.
        self.assertTrue(heading.startswith("LIGGGHTS - LAMMPS"), heading)
        self.assertEqual(line.split(), ["b"] + 5 * ["+0.000", "(0.0)"] + ["+0.00e+00", "(0.0)"])

    def test_difference_of_engines(self):
        """Means 2 and 5, deviations sqrt(2) of two and 1 of three: 3 over sqrt(1 + 1/3)."""
        figure = "U_mf_df"
        one, other = ([{figure: value} for value in values] for values in ((1.0, 3.0), (4.0, 5.0, 6.0)))
        self.assertEqual(study.difference(one, other, figure), "+3.000 (2.6)")
        self.assertEqual(study.difference(one, other[:1], figure), "none")
        self.assertEqual(study.difference(one, 2 * other[:1], figure), "+2.000 (2.0)")
        self.assertEqual(study.difference(2 * one[:1], 2 * other[:1], figure), "+3.000 (no spread)")
        self.assertEqual(study.difference(one, [*other, {figure: math.nan}], figure), "none")

    def test_a_figure_that_one_seed_has_not(self):
        """Of the same: none, not a number that is none."""
        row = {name: float(k) for k, name in enumerate(study.PRINTED)}
        results = {"a": [row, {**row, "overshoot": math.nan}]}
        heading, line = study.text({"a": parameters("lammps")}, results, {"a": 0}, {"a": {"v_esc": 0.1}}).splitlines()
        self.assertEqual(line.count("none"), 1)
        self.assertEqual(line.index("none"), heading.index("overshoot"))

    def test_refuses_what_liggghts_would_stop_at(self):
        table = self.folder / "table.csv"
        table.write_text("name, engine\na, liggghts\n")
        for seed in (4711, 9973, 10008, -10007):
            with self.assertRaisesRegex(study.TableError, f"primes above 10000, and {seed}"):
                self.call(study, table, "--seeds", seed, "--out", self.folder / "out")
        table.write_text("name, engine, law\na, lammps, hamaker\nb, liggghts, hamaker\n")
        with self.assertRaisesRegex(study.TableError, "'b'.*'law'.*'liggghts'"):
            self.call(study, table, "--out", self.folder / "out")
        table.write_text("name, engine\na, yade\n")
        with self.assertRaisesRegex(study.TableError, "'a'.*'yade'; there are lammps, liggghts"):
            self.call(study, table, "--out", self.folder / "out")

    def test_refuses_a_scheme_that_is_none(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text("name, scheme, settle\na, Exact, 0.01\n")
        with self.assertRaisesRegex(RunError, "1 of 1 runs failed"):
            self.call(study, table, "--seeds", 1, "--out", out)
        self.assertIn("scheme is Exact; there are sampled and exact", (out / "runs/a-1/log.lammps").read_text())

    def test_a_summary_of_both_engines_without_results(self):
        """Parameters that one engine only has, and a row without figures."""
        file = self.folder / "summary.csv"
        table = {"a": {"A": 0, "scheme": "exact"}, "b": {"A": 1, "other": 2}}
        for results, expected in (({"a": [], "b": [{"u": 3.0}]}, [["a", "", "exact", ""], ["b", "3", "", "2"]]),
                                  ({"a": [{"u": 3.0}], "b": []}, [["a", "3", "exact", ""], ["b", "", "", "2"]])):
            study.write_summary(file, table, results, {"a": 0, "b": 0})
            with open(file) as lines:
                rows = list(csv.DictReader(lines))
            self.assertEqual(list(rows[0]), ["name", "A", "scheme", "other", "seeds", "failed", "u", "u_sd"])
            self.assertEqual([[row[k] for k in ("name", "u", "scheme", "other")] for row in rows], expected)

    def test_kernels_and_schemes(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text(OTHERS)
        self.call(study, table, "--seeds", 1, "--out", out)
        for name, kernel, width, style in (("smooth", "sphereOverlap", 0.001, "gran/hooke/history"),
                                           ("exact", "particleCentre", None, "gran/hamaker"),
                                           ("well", "particleCentre", None, "gran/squarewell")):
            case = out / "runs" / f"{name}-1"
            text = (case / "constant/couplingProperties").read_text()
            self.assertRegex(text, rf"\nvoidFraction\s+{kernel};")
            found = re.search(r"\nsmoothingWidth\s+(\S+);", text)
            self.assertEqual(found and float(found[1]), width)
            told = (case / "log.lammps").read_text()
            self.assertIn(f"\npair_style {style}", told)
            for law in ("hamaker", "squarewell"):
                self.assertEqual(f"\nfix plate all wall/gran/{law}" in told, style == f"gran/{law}")
        self.assertIn(" well 5e-11 1.02\n", told)
        with open(out / "summary.csv") as file:
            found = {row["name"]: row for row in csv.DictReader(file)}
        self.assertEqual((found["smooth"]["v_esc"], found["smooth"]["mixing"], found["smooth"]["movement"]),
                         ("0.0", "1", "1"))
        if (BUILD / "tools/cohesion-mapping").exists():
            # The closed form of a well, sqrt(2 D/m (1/e^2 - 1)) with the m of a pair, a half; six digits.
            well, mass = found["well"], math.pi / 6 * 2650 * 1e-9
            for place, D, m in (("v_esc", 5e-11, mass / 2), ("v_esc_side", 1e-10, mass), ("v_esc_plate", 1e-10, mass)):
                e = restitution(800, 0.79e-3, m)
                self.assertAlmostEqual(float(well[place]) / math.sqrt(2 * D / m * (1 / e**2 - 1)), 1, delta=5e-6)
            self.assertGreater(float(found["exact"]["v_esc"]), 0)

    def test_a_change_of_what_reads_figures_reads_them_again(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text("name, A, settle\na, 0, 0.01\n")
        words = (study, table, "--seeds", 1, "--out", out)
        self.call(*words)
        stamp = (out / "runs/a-1/log.blockMesh").stat().st_mtime_ns
        with mock.patch.object(figures, "programs", lambda: "others"):
            self.assertIn("reading those of 1 again", self.call(*words))
        self.assertEqual((out / "runs/a-1/log.blockMesh").stat().st_mtime_ns, stamp)
        for changed in (Path(bed_case.__file__), Path(geometry.__file__), self.folder / "case/bed.lmp"):
            marks = [bed_case.fingerprint(BUILD, environment(BUILD))]
            read = Path.read_bytes
            with mock.patch.object(Path, "read_bytes",
                                   lambda file: read(file) + (b"#" if file == changed else b"")):
                marks.append(bed_case.fingerprint(BUILD, environment(BUILD)))
            self.assertNotEqual(*marks, changed)

    def test_escape_velocities_that_are_not_known(self):
        """No program, or words in the place of numbers: they are left empty, and it is said why."""
        row = {**parameters("lammps"), "A": 1e-19}
        for build, given, says in ((self.folder, row, "cohesion-mapping' does not exist"),
                                   (BUILD, {**row, "A": "much"}, "could not convert .*'much'")):
            with contextlib.redirect_stdout(io.StringIO()) as output:
                self.assertEqual(set(study.known_speeds(build, "a", given).values()), {None})
            self.assertRegex(output.getvalue(), f"row 'a': .*{says}")

    def test_what_the_walls_carry_is_what_stops_the_bed(self):
        """bed.lmp alone, without gas, while the poured particles hit the plate: the impulse of what is `carried` is
        that of gravity and the change of the momentum, from the heights. Heights are means over windows, their
        differences velocities weighted by triangles: with quarters at the ends the impulse is too. In those four of 25
        windows the weights are linear in time, a quarter about their mean: forces that differ there from their mean by
        the weight of the bed, up and down, count for an eighth of it each: 4/8/25 = 2 %."""
        program, plugin = launcher(BUILD)
        dt, mass = 1.125e-5, 1000 * math.pi / 6 * 2650 * 1e-9
        for scheme in ("sampled", "exact"):
            for A, D in ((0, 0), (7.49e-19, 0), (0, 5e-11)):
                folder = self.folder / f"{scheme}-{A}-{D}"
                folder.mkdir()
                (folder / "in.bed").write_text(f"include {self.folder / 'case/bed.lmp'}\nunfix gas\nrun 2000\n")
                given = {"plugin": plugin, "A": A, "dt": dt, "settle": 0.01, "node": 3.333e-3, "scheme": scheme,
                         "D": D, "law": "square_well" if D else "hamaker", "width": 0.02}
                words = [word for name, value in given.items() for word in ("-var", name, str(value))]
                subprocess.run([program, "-in", "in.bed", *words], cwd=folder, check=True, stdout=subprocess.DEVNULL)
                rows = read_columns(folder / "bed.dat")
                height, walls = rows[:, 2] / 2, read_columns(folder / "walls.dat")
                carried, plate_pull = walls[:, 1], walls[:, 3]
                window = 80 * dt
                weights = [0.25, 0.75] + [1] * (len(rows) - 4) + [0.75, 0.25]
                impulse = window * sum(weight * force for weight, force in zip(weights, carried))
                gained = mass * (height[-1] - height[-2] - height[1] + height[0]) / window
                self.assertAlmostEqual((impulse - gained) / (mass * 9.81 * window * sum(weights)), 1, delta=0.02,
                                       msg=f"{scheme}, A = {A} J, D = {D} J")
                # Of the plate's attraction alone: none without cohesion, down with it in the mean.
                if A or D:
                    self.assertLess(plate_pull.mean(), 0)
                else:
                    self.assertEqual(set(plate_pull), {0.0})

    def test_a_bed_that_fails_leaves_the_table_of_the_others(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text(TABLE)
        figures = bed_case.BedRun.figures

        def fail(job):
            if job.name == "no-side-1":
                raise ValueError("no curve")
            return figures(job)

        with mock.patch.object(bed_case.BedRun, "figures", fail), \
                self.assertRaisesRegex(RunError, "1 of 2 runs failed"):
            self.call(study, table, "--seeds", 1, "--out", out)
        with open(out / "summary.csv") as file:
            self.assertEqual([(row["name"], row["failed"], row["U_mf_df"]) for row in csv.DictReader(file)],
                             [("none", "0", "1"), ("no-side", "1", "")])
        # The failed one is ours and may be made anew; the results of other settings not.
        table.write_text(TABLE.replace("none, 0", "none, 1e-19"))
        with self.assertRaisesRegex(RunError, "none-1.*--overwrite"):
            self.call(study, table, "--seeds", 1, "--out", out)

    def test_refuses_a_seed_that_stands_twice(self):
        table = self.folder / "table.csv"
        table.write_text(TABLE)
        with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as said:
            self.call(study, table, "--seeds", 7, 7, "--out", self.folder / "out")
        self.assertIn("twice", said.getvalue())

    def test_beside_is_read_first(self):
        with mock.patch.object(run, "evaluate", side_effect=FileNotFoundError("log")), \
                self.assertRaisesRegex(CaseError, "--beside '.*nowhere'"):
            self.call(run, "--out", self.folder / "out", "--beside", self.folder / "nowhere")
        self.assertFalse((self.folder / "out").exists())

    def test_refuses_a_schedule_that_is_none(self):
        table = self.folder / "table.csv"
        table.write_text("name, schedule\na, long\n")
        with self.assertRaisesRegex(study.TableError, "'a'.*'long'; there are short, brief, thesis"):
            self.call(study, table, "--out", self.folder / "out")

    def test_the_main_job_keeps_what_is_not_its(self):
        out = self.folder / "out"
        (out / "Hamaker").mkdir(parents=True)
        (out / "Hamaker/letter.txt").write_text("mine")
        with self.assertRaisesRegex(RunError, "Hamaker.*would be lost"):
            self.call(run, "--out", out, "--overwrite")
        self.assertTrue((out / "Hamaker/letter.txt").exists())
        # Nor is a copy of the case, run by hand.
        shutil.rmtree(out / "Hamaker")
        shutil.copytree(self.folder / "case", out / "Hamaker")
        with self.assertRaisesRegex(RunError, "Hamaker.*would be lost"):
            self.call(run, "--out", out)

    def test_a_killed_bed_is_made_again(self):
        env = environment(BUILD)
        parameters = {"engine": "lammps", "schedule": "short", "A": 0.0, "settle": 0.01, "seed": 2}
        job = bed_case.BedRun(self.folder / "bed", parameters, env, "this build")
        job.launch()
        job.process.kill()
        job.process.wait()
        self.assertIsNone(job.result())
        require_ours([job], bed_case.MARK)
        result, = carry_out([job], 1)
        self.assertEqual(result["U_mf_th"], 2)
        other = bed_case.BedRun(self.folder / "bed", {**parameters, "A": 1e-19}, env, "this build")
        with self.assertRaisesRegex(RunError, "--overwrite"):
            require_ours([other], bed_case.MARK)


if __name__ == "__main__":
    unittest.main()
