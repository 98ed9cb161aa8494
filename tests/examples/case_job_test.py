# SPDX-License-Identifier: BSD-3-Clause
"""A case as a job: how it is made, and when a finished one is no longer that of its settings."""

import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from cohesion_studies import foam_case
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.job_pool import RESULT

SOLVER = "build/openfoam/cohesiveBedFoam"


class Small(CaseJob):
    """A case of one file, which it changes."""

    def change(self):
        self.seen = {"mark": json.loads((self.folder / MARK).read_text()), "file": (self.folder / "file").read_text()}
        (self.folder / "file").write_text("changed")


class Cases(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.root = Path(keeper.name).resolve()
        self.template, self.build = self.root / "case", self.root / "build"
        for file, text in (("case/file", "as it is"), ("case/constant/other", "1"), (SOLVER, "2"),
                           ("build/lib/one.so", "3"), ("build/lib/one.txt", "4"), ("engine/two.so", "5"),
                           ("reader.py", "6")):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            (self.root / file).write_text(text)
        self.env = {"LD_LIBRARY_PATH": f"{self.build}/lib:{self.root}/engine"}

    def mark(self):
        return fingerprint(self.template, self.build, self.env, [self.root / "reader.py"])

    def test_fingerprint_tells_case_programs_and_others_alone(self):
        """Of libraries those of the package: engines are the machine's."""
        for file, tells in (("case/file", True), ("case/constant/other", True), (SOLVER, True),
                            ("build/lib/one.so", True), ("reader.py", True), ("build/lib/one.txt", False),
                            ("engine/two.so", False)):
            before = self.mark()
            self.assertEqual(before, self.mark())
            (self.root / file).write_text("else")
            self.assertEqual(before != self.mark(), tells, file)

    def test_a_case_is_marked_changed_and_then_meshed(self):
        job = Small(self.root / "run", "small", self.env, {"a": 1}, [foam_case], self.template)
        with mock.patch.object(foam_case.FoamCase, "mesh", autospec=True,
                               side_effect=lambda case: (case.folder / "meshed").write_text(
                                   (case.folder / "file").read_text())):
            job.prepare()
        self.assertEqual(job.seen, {"mark": {"a": 1}, "file": "as it is"})
        self.assertEqual((job.folder / "meshed").read_text(), "changed")
        self.assertTrue((job.folder / "case.foam").exists())
        self.assertEqual((self.template / "file").read_text(), "as it is")

    def test_a_finished_case_is_of_its_settings_and_read_by_its_readers(self):
        def job(value, reader):
            return Small(self.root / "run", "small", self.env, {"a": value}, [reader], self.template)
        first = job(1, foam_case)
        first.folder.mkdir()
        first.keep({"settings": first.settings, "readers": first.readers, "figure": 7})
        self.assertEqual(json.loads((first.folder / RESULT).read_text())["figure"], 7)
        self.assertEqual(job(1, foam_case).result()["figure"], 7)
        self.assertFalse(job(2, foam_case).finished())
        other = job(1, json)
        self.assertTrue(other.finished())
        self.assertIsNone(other.result())

    def test_share_is_that_of_the_solver_and_none_before_its_first_step(self):
        job = Small(self.root / "run", "small", self.env, {}, [], self.template)
        for progress, share in ((None, 0.0), ((0.25, 3.0), 0.25)):
            job.case = mock.Mock(progress=lambda: progress)
            self.assertEqual(job.share(), share)


if __name__ == "__main__":
    unittest.main()
