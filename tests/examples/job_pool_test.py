# SPDX-License-Identifier: BSD-3-Clause
"""Studies: what is finished is not run again, what was killed or failed is, nothing outlives the pool; tables
of runs and figures over seeds.

Started with a folder and names of jobs, this file is a pool of small jobs that a test can kill."""

import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from cohesion_studies import job_pool, study_table
from cohesion_studies.job_pool import Job, RunError, carry_out, dies_with_us, digest_of, require_ours

job_pool.POLL = 0.05  # the jobs here are short


class Shell(Job):
    """A job of `sh`: waits until its folder holds a file `go`, and counts how often it has begun."""

    def __init__(self, folder, value=0):
        super().__init__(folder, {"value": value}, work=1 + value)

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        script = ("echo $$ >> begun; while [ ! -e go ]; do sleep 0.02; done; "
                  "[ ! -e wrong ] || { echo it is wrong; exit 3; }; echo 12.5 > figure")
        with open(self.folder / "log", "w") as log:
            return subprocess.Popen(dies_with_us(["sh", "-c", script]), cwd=self.folder, stdout=log)

    def figures(self):
        return {"figure": float((self.folder / "figure").read_text())}

    def share(self):
        return 0.5

    def again(self):
        again = (self.folder / "again").exists()
        (self.folder / "again").unlink(missing_ok=True)
        return again

    def tail(self):
        return (self.folder / "log").read_text()

    def begun(self):
        """Numbers of the processes that were started."""
        file = self.folder / "begun"
        return [int(line) for line in file.read_text().split()] if file.exists() else []

    def mark(self, *names):
        self.folder.mkdir(parents=True, exist_ok=True)
        for name in names:
            (self.folder / name).touch()


def alive(process):
    """Whether a process runs: one that has ended but that nobody has waited for does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def wait_for(condition):
    end = time.time() + 60  # far above what a small process needs
    while not condition():
        if time.time() > end:
            raise AssertionError("waited in vain")
        time.sleep(0.02)


class Pool(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)

    def jobs(self, *names):
        return [Shell(self.folder / name) for name in names]

    def test_killed_and_resumed(self):
        for kill in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            done, waits = self.jobs(f"done-{kill}", f"waits-{kill}")
            done.mark("go")
            pool = subprocess.Popen([sys.executable, __file__, self.folder, done.name, waits.name],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            wait_for(lambda: done.result() and waits.begun())
            pool.send_signal(kill)
            pool.wait()
            first, = waits.begun()
            wait_for(lambda: not alive(first))
            self.assertIsNone(waits.result())
            waits.mark("go")
            results = carry_out([done, waits], 2)
            self.assertEqual([r["figure"] for r in results], [12.5, 12.5])
            self.assertEqual((len(done.begun()), len(waits.begun())), (1, 2))
            carry_out([done, waits], 2)
            self.assertEqual((len(done.begun()), len(waits.begun())), (1, 2))

    def test_other_settings_are_another_run(self):
        job, = self.jobs("a")
        job.mark("go")
        carry_out([job], 1)
        other = Shell(job.folder, value=1)
        self.assertIsNone(other.result())
        self.assertEqual(carry_out([other], 1)[0]["settings"], {"value": 1})
        self.assertEqual(len(job.begun()), 2)
        self.assertIsNone(job.result())

    def test_figures_are_read_again_by_other_readers(self):
        """The run is not made again, and its times stay."""
        job, = self.jobs("a")
        job.readers = "these"
        job.mark("go")
        first, = carry_out([job], 1)
        (job.folder / "figure").write_text("13.5")
        self.assertEqual(carry_out([job], 1), [first])
        job.readers = "others"
        self.assertTrue(job.finished())
        self.assertIsNone(job.result())
        second, = carry_out([job], 1)
        self.assertEqual(second, {**first, "readers": "others", "figure": 13.5})
        self.assertEqual(len(job.begun()), 1)
        # Figures that cannot be read are a failure, and the run is not lost.
        job.readers = "none"
        (job.folder / "figure").unlink()
        with self.assertRaisesRegex(RunError, r"(?s)its figures cannot be read.*1 of 1 runs failed"):
            carry_out([job], 1)
        self.assertTrue(job.finished())
        self.assertIsNone(job.result())

    def test_a_run_whose_figures_cannot_be_read_is_kept(self):
        """With its settings and times; the next start reads it, whether its readers have a mark or none."""
        for readers in (None, "these"):
            job, = self.jobs(f"a-{readers}")
            job.readers = readers
            job.mark("go", "mark")
            with mock.patch.object(Shell, "figures", lambda job: {}["figure"]):
                for _ in range(2):
                    with self.assertRaisesRegex(RunError, r"KeyError\('figure'\).*once its folder is removed"):
                        carry_out([job], 1)
                    kept = json.loads((job.folder / "result.json").read_text())
                    self.assertEqual((set(kept), kept["settings"], kept["readers"]),
                                     ({"settings", "readers", "unread", "seconds", "processor_seconds"}, {"value": 0},
                                      None))
                    self.assertTrue(job.finished())
                    self.assertIsNone(job.result())
            require_ours([job], "mark")
            result, = carry_out([job], 1)
            self.assertEqual(result, {"settings": {"value": 0}, "readers": readers, "seconds": kept["seconds"],
                                      "processor_seconds": kept["processor_seconds"], "figure": 12.5})
            self.assertEqual(job.result(), result)
            self.assertEqual(len(job.begun()), 1)

    def test_processor_seconds_are_those_of_the_run_alone(self):
        """Of three runs at once, the one that works has them."""
        jobs = _, busy, _ = self.jobs("lazy", "busy", "other")
        busy.start = lambda: subprocess.Popen(
            [sys.executable, "-c", "import time\nwhile time.process_time() < 1: pass\nopen('figure', 'w').write('1')"],
            cwd=busy.folder)
        for job in jobs:
            job.mark("go")
        lazy, worked, _ = (result["processor_seconds"] for result in carry_out(jobs, 3))
        # The interpreter starts in less than another second; a shell that ends at once takes far less than one.
        self.assertTrue(1 <= worked < 2, worked)
        self.assertLess(lazy, 0.5)

    def test_digest_tells_a_change(self):
        file = self.folder / "program.py"
        file.write_text("1")
        before = digest_of([file, self.folder])
        self.assertEqual(digest_of([self.folder, file]), before)
        file.write_text("2")
        self.assertNotEqual(digest_of([file]), before)

    def test_folders_that_are_not_ours_are_kept(self):
        """Ours are none, finished ones, and those with the mark and no result; not those of other settings."""
        none, finished, begun, alien, other = jobs = self.jobs("none", "finished", "begun", "alien", "other")
        finished.mark("go", "mark")
        other.mark("go", "mark")
        carry_out([finished, other], 2)
        begun.mark("mark")
        alien.mark("letter")
        require_ours([none, finished, begun], "mark")
        other.settings = {"value": 7}
        for job, words in ((alien, "would be lost"), (other, "--overwrite")):
            with self.assertRaisesRegex(RunError, f"{job.name}' holds .*{words}"):
                require_ours(jobs[:3] + [job], "mark")

    def test_overwrite_replaces_results_and_nothing_else(self):
        other, alien = self.jobs("other", "alien")
        other.mark("go", "mark")
        carry_out([other], 1)
        other.settings = {"value": 7}
        require_ours([other], "mark", overwrite=True)
        alien.mark("letter")
        with self.assertRaisesRegex(RunError, "alien' holds .*would be lost"):
            require_ours([alien], "mark", overwrite=True)

    def test_a_failure_does_not_stop_the_others(self):
        jobs = good, bad, last = self.jobs("good", "bad", "last")
        for job in jobs:
            job.mark("go")
        bad.mark("wrong")
        with self.assertRaisesRegex(RunError, r"(?s)bad, in .*it is wrong.*1 of 3 runs failed"):
            carry_out(jobs, 1)
        self.assertTrue(good.result() and last.result())
        self.assertIsNone(bad.result())
        (bad.folder / "wrong").unlink()
        self.assertTrue(all(carry_out(jobs, 1)))
        self.assertEqual([len(job.begun()) for job in jobs], [1, 2, 1])

    def test_neither_does_a_program_or_a_log_that_is_not_there(self):
        good, no_program, no_log = self.jobs("good", "no-program", "no-log")
        for job in (good, no_log):
            job.mark("go")
        no_log.mark("wrong")

        def missing():
            raise FileNotFoundError(2, "No such file or directory", "missing")

        no_program.start = missing
        no_log.share = no_log.tail = good.share = missing
        with self.assertRaisesRegex(RunError, r"(?s)no-log, in .*no log.*2 of 3 runs failed") as caught:
            carry_out([good, no_program, no_log], 2)
        self.assertRegex(str(caught.exception), "no-program, in .*'missing'")
        self.assertTrue(good.result())

    def test_neither_does_one_without_figures_or_one_that_does_not_start(self):
        good, no_figure, no_start = self.jobs("good", "no-figure", "no-start")
        good.mark("go")
        no_figure.mark("go")
        no_figure.figures = lambda: {}["figure"]

        def start():
            raise RunError("no-start: no mesh")

        no_start.start = start
        with self.assertRaisesRegex(RunError, r"(?s)no-start: no mesh.*KeyError\('figure'\).*2 of 3 runs"):
            carry_out([good, no_figure, no_start], 1)
        self.assertTrue(good.result())
        self.assertIsNone(no_figure.result())

    def test_started_once_more_if_it_says_so(self):
        job, = self.jobs("a")
        job.mark("go", "wrong", "again")
        with self.assertRaises(RunError):
            carry_out([job], 1)
        self.assertEqual(len(job.begun()), 2)

    def test_longest_first_and_not_more_than_asked(self):
        jobs = [Shell(self.folder / str(value), value) for value in (1, 3, 2)]
        for job in jobs:
            job.mark("go")
        carry_out(jobs, 1)
        ends = {job.settings["value"]: (job.folder / "result.json").stat().st_mtime_ns for job in jobs}
        self.assertTrue(ends[3] < ends[2] < ends[1])
        for job in jobs:
            self.assertLess(json.loads((job.folder / "result.json").read_text())["seconds"], 60)


class Tables(unittest.TestCase):
    KNOWN = {"A": 0.0, "side": 1, "schedule": "short"}

    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.file = Path(keeper.name) / "table.csv"

    def read(self, text):
        self.file.write_text(text)
        return study_table.read_table(self.file, self.KNOWN)

    def test_rows_with_defaults(self):
        found = self.read("# of the thesis\nname, A, schedule\n\nnone, 0,\nall , 1e-18, thesis\n")
        self.assertEqual(found, {"none": {"A": 0, "side": 1, "schedule": "short"},
                                 "all": {"A": 1e-18, "side": 1, "schedule": "thesis"}})

    def test_refuses(self):
        for text, says in (("", "column names"), ("A\n1\n", "'name'"), ("name,A\n", "rows"),
                           ("name,B\nx,1\n", "no parameter 'B'; there are A, side, schedule"),
                           ("name,A,A\nx,1,2\n", "twice"), ("name,A\nx,1\nx,2\n", "'x'.*twice"),
                           ("name,A\nx,1,2\n", "'x' has 3 cells for 2"), ("name,A\na/b,1\n", "a/b")):
            with self.assertRaisesRegex(study_table.TableError, says):
                self.read(text)

    def test_mean_and_deviation_over_seeds(self):
        results = {"one": [{"U": 1.0, "ended": True}],
                   "three": [{"U": 1.0, "ended": True}, {"U": 2.0, "ended": True}, {"U": 6.0, "ended": True}]}
        found = study_table.over_seeds(results["three"])
        # (4 + 1 + 9)/2 = 7
        self.assertEqual(set(found), {"U"})
        self.assertAlmostEqual(found["U"][0], 3.0, delta=1e-15)
        self.assertAlmostEqual(found["U"][1], math.sqrt(7), delta=1e-15)
        self.assertTrue(math.isnan(study_table.over_seeds(results["one"])["U"][1]))
        # A seed without the figure.
        self.assertTrue(all(map(math.isnan, study_table.over_seeds([{"U": 1.0}, {"U": math.nan}, {"U": 2.0}])["U"])))
        study_table.write_summary(self.file, {"one": {"A": 0}, "three": {"A": 1e-18}}, results)
        self.assertEqual(self.file.read_text().split(),
                         ["name,A,seeds,U,U_sd", "one,0,1,1,nan", "three,1e-18,3,3,2.65"])
        study_table.write_summary(self.file, {"none": {"A": 0}, "three": {"A": 1e-18}},
                                  {**results, "none": []}, {"none": 2, "three": 0})
        self.assertEqual(self.file.read_text().split(),
                         ["name,A,seeds,failed,U,U_sd", "none,0,0,2,,", "three,1e-18,3,0,3,2.65"])


def main(folder, *names):
    os.chdir(folder)
    carry_out([Shell(Path(folder) / name) for name in names], len(names))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(*sys.argv[1:])
    else:
        unittest.main()
