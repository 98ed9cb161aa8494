# SPDX-License-Identifier: BSD-3-Clause
"""A swarm of falling, colliding spheres, killed (signal 9) at random moments and continued with
`startFrom latestTime`: the same gas, particles and forces at the end as without the stops, on 1 and 2
ranks. Time folders that are not complete are set aside, also one that was cut off while it was written,
on some ranks before others; what cannot be continued, and what would overwrite results, is refused."""

import random
import shutil
import time
import unittest

from cohesion_tests.coupling.cases import CONTROL, ENGINE, exchange_lines
from cohesion_tests.coupling.swarm import (END, STEPS, complete, difference, kill, make, make_to_kill, state,
                                           steps_begun, undisturbed)
from cohesion_tests.coupling.test_case import CoupledTestCase


def kill_after(case, steps, ranks):
    """Starts the solver and kills one of its ranks when its log has `steps` steps; whether it was in
    time. The others are ended by mpirun, wherever they are."""
    process = case.start(ranks=ranks)
    while process.poll() is None and steps_begun(case) < steps:
        time.sleep(0.005)
    return kill(case, process, ranks)


class Restart(CoupledTestCase):
    def check_killed(self, ranks, kills, reference):
        """Kills after each of `kills` steps, counted from where the run is continued."""
        case = make_to_kill(self.column, f"killed-{ranks}", ranks)
        for steps in kills:
            done = complete(case, ranks)
            self.expect_true(f"{ranks} ranks: killed after {steps} steps from {done[-1] if done else 0}",
                             kill_after(case, steps, ranks))
            # A time that was written is met exactly; what was kept between two times is not (last_state.py).
            for kept in (case.folder / "kept", *case.folder.glob("processor*/kept")):
                shutil.rmtree(kept, ignore_errors=True)
        done = complete(case, ranks)
        self.expect_true(f"{ranks} ranks: something is kept: {done}", len(done) > 0)
        case.finish(case.start(ranks=ranks))
        log = case.log("cohesiveBedFoam").read_text()
        left = STEPS - round(done[-1] / 1e-4)
        self.expect_equal(f"{ranks} ranks: steps that were left to do", len(exchange_lines(log)), left)
        self.compare(f"{ranks} ranks, continued", state(case, log, ranks), reference)

    def compare(self, what, found, reference):
        """reference: the state of the whole run, and the difference that a disturbance makes."""
        whole, limits = reference
        for name, apart in difference(found, whole).items():
            self.expect_below(f"{what}: {name}, largest difference / largest value", apart, limits[name])

    def check_cut_off(self, ranks, reference):
        """Ended while the last time was written: half a file, no mark, and on the last of several ranks no
        folder. Of an earlier end at the same time a folder is there. Two times are kept, so that there is
        one to continue from."""
        case = make(self.column, f"cut-off-{ranks}")
        case.set(CONTROL, "endTime", 0.012)
        case.set(CONTROL, "purgeWrite", 2)
        case.solve(ranks=ranks)
        folder = case.folder / "processor0" if ranks > 1 else case.folder
        self.expect_equal(f"cut off, {ranks} ranks: times kept", complete(case, ranks), [0.008, 0.012])
        cut = folder / "0.012"
        (cut / "uniform/completeState").unlink()
        text = (cut / "U").read_text()
        (cut / "U").write_text(text[:len(text) // 2])
        if ranks > 1:
            shutil.rmtree(case.folder / f"processor{ranks - 1}/0.012")
        (folder / "incomplete-0.012").mkdir()
        (folder / "incomplete-0.012/earlier").touch()
        case.set(CONTROL, "endTime", END)
        case.set(CONTROL, "startFrom", "latestTime")
        case.finish(case.start(ranks=ranks))
        log = case.log("cohesiveBedFoam").read_text()
        self.expect_true(f"cut off, {ranks} ranks: it says what was set aside",
                         "Time folders after 0.008 are incomplete" in log)
        self.expect_true(f"cut off, {ranks} ranks: the folder is kept",
                         (folder / "incomplete-0.012.2/U").exists())
        self.expect_true(f"cut off, {ranks} ranks: that of an earlier end, too",
                         (folder / "incomplete-0.012/earlier").exists())
        found = state(case, log, ranks)
        self.compare(f"cut off, {ranks} ranks", found, reference)
        if ranks == 1:
            # That is the number of ranks of the whole run.
            self.expect_equal("cut off, continued: largest difference", max(difference(found, reference[0]).values()), 0)

    def test_refused(self):
        case = make(self.column, "refused", "swarm")
        case.set(CONTROL, "endTime", 0.008)
        case.solve()
        case.set(CONTROL, "endTime", 0.012)
        case.set(CONTROL, "startFrom", "latestTime")
        self.refused("script without read_restart", case, "had done 800 steps", "have done 0",
                     "read_restart ${restart}", "couplingProperties")
        case.set(CONTROL, "startFrom", "startTime")
        case.set(CONTROL, "startTime", 0.004)
        (case.folder / "0.004/uniform/completeState").unlink()
        self.refused("start at a time that is not complete", case, "start at time 0.004",
                     "Complete are 0.008: in system/controlDict use 'startFrom latestTime;'",
                     "startFrom startTime; startTime 0;")

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_results_are_kept(self):
        """Results after the start are overwritten with -overwrite only, and then none of them passes for
        complete any more; nor are results without any mark renamed unasked."""
        case = make(self.column, "kept")
        case.set(CONTROL, "endTime", 0.012)
        log = case.solve()
        self.expect_true("no warning of digits", "fields are written with" not in log)
        case.set(CONTROL, "startTime", 0.004)
        written = (case.folder / "0.008/U").stat().st_mtime_ns
        self.refused("start before the last complete time", case, "after the start at 0.004",
                     "at 2 times from 0.008 to 0.012", "-overwrite")
        self.expect_equal("start before the last complete time: all are complete", complete(case, 1),
                          [0.004, 0.008, 0.012])
        # Five steps: none is written.
        case.set(CONTROL, "endTime", 0.0045)
        case.solve("-overwrite")
        self.expect_equal("overwritten from 0.004 on: complete", complete(case, 1), [0.004])
        self.expect_equal("overwritten from 0.004 on: not yet at 0.008",
                          (case.folder / "0.008/U").stat().st_mtime_ns, written)

        (case.folder / "0.004/uniform/completeState").unlink()
        case.set(CONTROL, "startFrom", "latestTime")
        self.refused("no time is complete", case, "3 of them, but none with 'uniform/completeState'",
                     "-overwrite")
        self.expect_true("no time is complete: nothing is renamed", (case.folder / "0.012/U").exists())
        log = case.solve("-overwrite")
        self.expect_true("no time is complete, -overwrite: starts at 0", "\nTime = 0.0001 " in log)
        self.expect_true("no time is complete, -overwrite: set aside", (case.folder / "incomplete-0.012/U").exists())

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_not_written(self):
        """A field that cannot be written: its name is that of a folder. What is complete then is what was kept."""
        case = make(self.column, "not-written")
        case.set(CONTROL, "writePrecision", 12)
        (case.folder / "0.004/U").mkdir(parents=True)
        self.refused("a field that cannot be written", case, "time 0.004 could not be written in full",
                     "fields are written with 12 digits", "writePrecision 17", options=["-overwrite"], begun=True,
                     written=True)
        done = complete(case, 1)
        self.expect_true(f"a field that cannot be written: complete are {done}", len(done) == 1 and done[0] < 0.004)

    @classmethod
    def setUpClass(cls):
        cls.reference = undisturbed(cls.column)

    def test_disturbance_is_a_yardstick(self):
        for name, limit in self.reference[1].items():
            # Chaos would make the yardstick as long as the values, and nothing would be compared.
            self.expect_below(f"disturbed: {name}, largest difference / largest value", limit, 1e-4)

    def test_killed(self):
        draw = random.Random(20)
        # Moments between two writes, 40 steps apart, and near one; counted from the last complete time
        self.check_killed(1, [draw.randint(41, 79), draw.randint(1, 39), 40], self.reference)
        self.check_killed(2, [draw.randint(41, 119)], self.reference)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_cut_off(self):
        for ranks in (1, 2):
            self.check_cut_off(ranks, self.reference)


if __name__ == "__main__":
    unittest.main()
