# SPDX-License-Identifier: BSD-3-Clause
"""A run that ends itself in its middle, by an error of the particle engine or of the gas's side, leaves its last complete
state, and is continued from there; so is a run that a signal ends. The engine may do fewer steps than a gas step has.
On 1 and 2 ranks, with either engine. Keeping that state changes nothing of a run, and leaves nothing after one that
comes to its end."""

import math
import re
import shutil
import signal
import subprocess
import time
import unittest

import numpy as np

from cohesion_studies.mpi_start import short_start
from cohesion_tests.coupling.cases import CONTROL, ENGINE, append, edit, script_file
from cohesion_tests.coupling.fields import cells
from cohesion_tests.coupling.swarm import complete, steps_begun
from cohesion_tests.coupling.test_case import CoupledTestCase, times
from cohesion_tests.refusals import assert_says

SCRIPT = script_file("particles")
CREATE = {"lammps": ('"${continued} == no"', "create_atoms 1 single 0.031 0.029 0.19", "region       box block 0 0.06 0 0.06"
                     " 0 0.2"),
          "liggghts": ('"${continued} == 0"', "create_atoms 1 single 0.031 0.029 0.19 units box",
                       "region       box block 0 0.06 0 0.06 0 0.2 units box")}
ENTRIES = "type fieldAverage; libs (fieldFunctionObjects); writeControl writeTime;"
# One average from the start, one that begins after the first run has ended, one of each written interval
AVERAGES = f"""
particles {{ type particleFields; libs (cohesionFunctionObjects); writeControl writeTime; }}
whole {{ {ENTRIES} fields ( U {{ mean on; prime2Mean off; base time; }} ); }}
late {{ {ENTRIES} timeStart 5e-3; fields ( particleVelocity {{ mean on; prime2Mean off; base time; }} ); }}
each {{ {ENTRIES} restartOnOutput yes; fields ( voidFraction {{ mean on; prime2Mean off; base time; }} ); }}
"""
SET = "set          group all diameter 1e-4 density 2000"


def make(column, name, speed):
    """A sphere 1 cm below the top, with this speed upwards [m/s]: at 40 m/s it leaves the box in the third gas step. A run
    that is continued stops it."""
    case = column(name)
    condition, create, region = CREATE[ENGINE]
    edit(case, SCRIPT, f"{region}\ncreate_box   1 box\n{create}\n{SET}\n",
         f'if {condition} then "{region}" "create_box 1 box" "{create}" "{SET}" "velocity all set 0 0 {speed}" else'
         ' "read_restart ${restart}" "velocity all set 0 0 0"\n')
    # The engine finds that a sphere is lost when it makes its list, within the gas step.
    edit(case, SCRIPT, "thermo       10000", "thermo       1")
    append(case, CONTROL, "endTime 1e-3; writeInterval 1e-3; startFrom latestTime; writePrecision 17;")
    case.mesh()
    return case


class LastState(CoupledTestCase):
    def ends(self, name, case, ranks):
        """The time that a run that fails leaves."""
        with self.subTest(name), self.assertRaises(Exception, msg=f"{name}: runs"):
            case.solve(ranks=ranks)
        log = case.log("cohesiveBedFoam").read_text()
        said = re.search(r"The last complete state, that of time (\S+), has been written", log)
        self.expect_true(f"{name}: the log says which state there is", said)
        folder = case.folder / "processor0" if ranks > 1 else case.folder
        self.expect_true(f"{name}: nothing is left of what was kept", not (folder / "kept").exists())
        self.expect_equal(f"{name}: complete times", complete(case, ranks), [float(said[1])] if said else [])
        return log

    def engine_error(self, ranks):
        name = f"engine, {ranks} ranks"
        case = make(self.column, f"engine-{ranks}", 40)
        log = self.ends(name, case, ranks)
        self.expect_true(f"{name}: by the engine", "ost atoms" in log or "Atom lost" in log or "lost" in log)
        # Without the decomposition that solve() begins with
        append(case, CONTROL, "writeControl timeStep; writeInterval 1;")
        case.finish(case.start(ranks=ranks))
        self.expect_equal(f"{name}: complete in the end", complete(case, ranks)[-1], 1e-3)

    def test_engine_error(self):
        for ranks in (1, 2):
            self.engine_error(ranks)

    def halted(self, ranks, kind):
        """The engine ends a run in the third gas step, after 6 of its 10 steps, and reports no error."""
        name = f"{kind} halt, {ranks} ranks"
        case = make(self.column, f"halt-{kind}-{ranks}", 0)
        edit(case, SCRIPT, "fix gas ", f"variable done equal step\nfix halt all halt 1 v_done > 25 error {kind}\nfix gas ")
        log = self.ends(name, case, ranks)
        assert_says(self, log, "the particle engine did 6 of the 10 steps of this gas step and stands at its step 26",
                    "'fix halt' with 'error soft'", "'timer timeout'", "log.lammps")
        self.expect_equal(f"{name}: gas steps", log.count("\nTime = "), 3)

    @unittest.skipUnless(ENGINE == "lammps", "commands of LAMMPS")
    def test_engine_halts(self):
        for ranks in (1, 2):
            self.halted(ranks, "soft")
        self.halted(1, "continue")

    @unittest.skipUnless(ENGINE == "lammps", "commands of LAMMPS")
    def test_engine_never_advances(self):
        """No step is done once a time limit or a halt in the script has ended its runs."""
        for number, lines in enumerate(("timer timeout 0:00:00 every 1",
                                        "variable done equal step\nfix halt all halt 1 v_done >= 5 error soft\nrun 10")):
            case = make(self.column, f"limit-{number}", 0)
            edit(case, SCRIPT, "fix gas ", f"{lines}\nfix gas ")
            self.refused(lines, case, "the particle engine did 0 of the 10 steps", begun=True)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_error_of_the_gas(self):
        """A function object that misses a step stops the second one."""
        case = make(self.column, "gas", 0)
        append(case, CONTROL, "functions { observed { libs (cohesionFunctionObjects); type forceBudget; executeControl"
                              " timeStep; executeInterval 2; writeControl timeStep; writeInterval 10; } }")
        log = self.ends("gas", case, 1)
        self.expect_true("gas: the error is said", "was left out" in log)
        append(case, CONTROL, "functions { observed { enabled false; } } writeControl timeStep; writeInterval 1;")
        case.finish(case.start())
        self.expect_equal("gas: complete in the end", complete(case, 1)[-1], 1e-3)

    def test_error_as_a_state_is_kept(self):
        """A sphere is outside the mesh when the first state is kept, before the engine makes a list of neighbours."""
        case = make(self.column, "outside", 150)
        edit(case, SCRIPT, "timestep ", "neigh_modify delay 20\ntimestep ")
        self.refused("outside", case, "1 particle is outside the mesh", "Make the mesh as large as the box", begun=True)

    def stopped(self, ranks, number, entries="writeControl runTime;"):
        """A signal ends the run before a time is written: the next run begins at the state that was kept."""
        name = f"signal {number}, {ranks} ranks"
        case = make(self.column, f"signal-{number}-{ranks}", 0)
        append(case, CONTROL, "endTime 100; writeInterval 100;")
        if ranks > 1:
            case.set("system/decomposeParDict", "numberOfSubdomains", ranks)
            case.run("decomposePar", "-force")
        process = case.start(ranks=ranks)
        while process.poll() is None and steps_begun(case) < 20:
            time.sleep(0.005)
        process.send_signal(number)
        process.wait()
        self.expect_equal(f"{name}: complete times", complete(case, ranks), [])
        folder = case.folder / "processor0" if ranks > 1 else case.folder
        kept = re.search(r'name +"(\S+)"', (folder / "kept/uniform/time").read_text())[1]
        # Written times are counted from the start of the first run.
        interval = 4e-4
        expected = [float(kept), *(interval * (math.floor(float(kept) / interval + 1e-6) + k) for k in (1, 2))]
        append(case, CONTROL, f"endTime {expected[-1]:.8g}; writeInterval {interval}; {entries}")
        case.finish(case.start(ranks=ranks))
        log = case.log("cohesiveBedFoam").read_text()
        assert_says(self, log, f"The last complete state is that of time {kept}", "To begin anew remove 'kept'",
                    f"to continue from a written time remove {kept}")
        first = re.search(r"\nTime = (\S+)", log)[1]
        self.expect_near(f"{name}: the first step ends at", float(first), float(kept) + 1e-4, 1e-9)
        self.expect_equal(f"{name}: complete times", complete(case, ranks), [float(f"{t:.8g}") for t in expected])
        self.expect_true(f"{name}: nothing is left of what was kept", not (folder / "kept").exists())

    def test_stopped_by_a_signal(self):
        for ranks in (1, 2):
            self.stopped(ranks, signal.SIGTERM)
        self.stopped(1, signal.SIGKILL, "writeControl adjustable; adjustTimeStep yes; maxDeltaT 1e-4;")

    def averaged(self, name, ranks, ends):
        """Averages of 60 steps at the end; a signal ends the first run where `ends` says so."""
        case = make(self.column, name, 0)
        edit(case, SCRIPT, ' "velocity all set 0 0 0"', "")
        append(case, CONTROL, f"endTime 6e-3; writeInterval 6e-3; functions {{ {AVERAGES} }}")
        if ranks > 1:
            case.set("system/decomposeParDict", "numberOfSubdomains", ranks)
            case.run("decomposePar", "-force")
        if ends:
            append(case, CONTROL, "endTime 100; writeInterval 100;")
            process = case.start(ranks=ranks)
            while process.poll() is None and steps_begun(case) < 20:
                time.sleep(0.005)
            process.terminate()
            process.wait()
            folder = case.folder / "processor0" if ranks > 1 else case.folder
            state = (folder / "kept/uniform/functionObjects/functionObjectProperties").read_text()
            self.expect_true(f"{name}: only the average that has begun is kept", re.search(r"whole\s*{\s*U\s*{", state)
                             and "particleVelocity" not in state and "voidFraction" not in state)
            append(case, CONTROL, "endTime 6e-3; writeInterval 6e-3;")
        case.finish(case.start(ranks=ranks))
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        return {field: cells(case, "0.006", field) for field in ("UMean", "particleVelocityMean", "voidFractionMean")}

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_averages_continue(self):
        whole = self.averaged("averages", 1, False)
        for ranks in (1, 2):
            found = self.averaged(f"averages-ended-{ranks}", ranks, True)
            for name in ("UMean", "particleVelocityMean"):
                # The particle's force is computed anew where the run continues. Without the first step it is 1/60.
                self.expect_below(f"{ranks} ranks: {name}, largest difference / largest value",
                                  np.abs(found[name] - whole[name]).max() / np.abs(whole[name]).max(), 1e-4)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_average_that_cannot_be_written(self):
        """Files may be larger than the fields, but not as large as an average of six components, as with a disk that
        becomes full. OpenFOAM does not say so of text. After the first step that average is uniform."""
        case = make(self.column, "full", 0)
        edit(case, SCRIPT, "thermo       1", "thermo       10000")
        average = f"whole {{ {ENTRIES} fields ( U {{ mean on; prime2Mean on; base time; }} ); }}"
        append(case, CONTROL, f"functions {{ {average} }}")
        case.solve()
        fields = {file.name: file.stat().st_size for file in (case.folder / "0.001").iterdir() if file.is_file()}
        largest, other = fields.pop("UPrime2Mean"), max(fields.values())
        limit = (largest + other) // 2048  # [KiB]
        self.expect_true(f"{limit} KiB between {other} and {largest} bytes", other < 1024 * limit < largest)
        shutil.rmtree(case.folder / "0.001")
        append(case, CONTROL, "endTime 100; writeInterval 100;")
        # The log goes through a pipe: it may be longer.
        command = f"trap '' XFSZ; ulimit -f {limit}; exec cohesiveBedFoam"
        run = subprocess.run(["bash", "-c", command], cwd=case.folder, env={**short_start(), **case.env},
                             capture_output=True, text=True, timeout=120)
        self.expect_true("the run fails", run.returncode != 0)
        assert_says(self, run.stdout + run.stderr, "could not be written in full", "See whether the disk is full",
                    "The last complete state, that of time 0.0001, has been written")
        self.expect_equal("complete times", complete(case, 1), [1e-4])

    def test_state_of_the_gas_that_a_run_discards(self):
        said = "has lost the forces of the gas"
        case = make(self.column, "discarded", 0)
        case.solve()
        for end, edits, warned in ((2e-3, (), False), (3e-3, ("fix gas ", "run 0\nfix gas "), True)):
            append(case, CONTROL, f"endTime {end};")
            if edits:
                edit(case, SCRIPT, *edits)
            case.finish(case.start())
            log = case.log("cohesiveBedFoam").read_text()
            self.expect_equal(f"until {end}: the warning", said in log, warned)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_begun_anew(self):
        """A run that starts elsewhere leaves what is kept until it has a complete state of its own; with -overwrite that
        is complete no more."""
        case = make(self.column, "anew", 0)
        old = case.folder / "kept/uniform"
        for options, left in (((), True), (("-overwrite",), False)):
            old.mkdir(parents=True)
            (old / "time").write_text('value 50; name "50";\n')
            (old / "completeState").write_text("engineSteps 500000;\n")
            append(case, CONTROL, "startFrom startTime; deltaT 1.05e-4;")
            self.refused(f"before the first step {options}", case, "whole multiple", options=options)
            self.expect_equal(f"complete, started with {options}", (old / "completeState").exists(), left)
            append(case, CONTROL, "deltaT 1e-4;")
            case.solve("-overwrite")
            self.expect_true("nothing is left after a complete state", not old.parent.exists())

    def test_nothing_is_left(self):
        case = make(self.column, "whole", 0)
        case.solve()
        self.expect_equal("time folders", times(case), ["0", "0.001", "0.orig"])
        self.expect_true("no folder 'kept'", not (case.folder / "kept").exists())


if __name__ == "__main__":
    unittest.main()
