# SPDX-License-Identifier: BSD-3-Clause
"""What the particle engine says stands in the solver's log, once, on 1 and 2 ranks: its error, also one of a
single rank, and its warnings. That it ended the run is said when it did, also by `quit`, and not when the gas did.
While it is at its script for long, the log says how far it is."""

import re
import time
import unittest

from cohesion_studies.foam_case import CaseError
from cohesion_tests.coupling.cases import COUPLING, ENGINE, append, script_file
from cohesion_tests.coupling.test_case import CoupledTestCase

SCRIPT = script_file("particles")
LOG = f"log.{ENGINE}"
ENDED = "The particle engine ended the run"


def make(column, name, old, new):
    """The case of one sphere, with something else in its script."""
    case = column(name)
    script = case.folder / SCRIPT
    text = script.read_text()
    assert old in text, f"{script} has no '{old}'"
    script.write_text(text.replace(old, new))
    append(case, "system/controlDict", "endTime 0.002; writeInterval 0.001; writePrecision 17;")
    case.mesh()
    return case


def outcome(case, ranks):
    """Whether the run fails, and its log."""
    try:
        return False, case.solve(ranks=ranks)
    except CaseError:
        return True, case.log("cohesiveBedFoam").read_text()


class EngineMessages(CoupledTestCase):
    def fails_with(self, case, ranks, said):
        """Each of the texts once, and nothing computed."""
        failed, log = outcome(case, ranks)
        self.expect_true(f"{case.folder.name}: fails", failed)
        for text in said:
            self.expect_equal(f"{case.folder.name}: times that the log says \"{text}\"", log.count(text), 1)
        self.expect_equal(f"{case.folder.name}: steps", log.count("\nTime = "), 0)
        return log

    def error_of_all(self, ranks):
        case = make(self.column, f"all-{ranks}", "pair_coeff ", "pair_coef ")
        self.fails_with(case, ranks, ["ERROR: Unknown command: pair_coef", ENDED, f"Its log is '{case.folder}/{LOG}'"])

    def error_of_one(self, ranks):
        # The sphere is on the last rank, and there alone is something to divide by nothing.
        case = make(self.column, f"one-{ranks}", "fix move ",
                    "variable nothing atom 1/(id-id)\nvelocity all set v_nothing 0 0\nfix move ")
        self.fails_with(case, ranks, [f"ERROR on proc {ranks - 1}: Divide by 0 in variable formula"])

    def test_error_of_script(self):
        case = make(self.column, "script", "fix move ", "print 'ERROR: A is missing'\nquit\nfix move ")
        self.fails_with(case, 1, ["ERROR: A is missing", ENDED])

    def quits(self, ranks):
        case = make(self.column, f"quit-{ranks}", "fix move ", "quit\nfix move ")
        log = self.fails_with(case, ranks, [ENDED, "has its script a 'quit'?"])
        # What Open MPI 5 says of a rank that ends before the other is no error of the engine's.
        self.expect_equal(f"quit-{ranks}: errors", re.findall(r"(?<!PMIX )ERROR:.*", log), [])

    def error_of_gas(self, ranks):
        case = make(self.column, f"gas-{ranks}", "fix move ", "fix move ")
        append(case, COUPLING, "minVoidFraction 0.99999999;")
        failed, log = outcome(case, ranks)
        self.expect_true(f"gas-{ranks}: fails", failed)
        self.expect_true(f"gas-{ranks}: by the gas", "below minVoidFraction" in log)
        self.expect_equal(f"gas-{ranks}: times that the log names the engine for it", log.count("The particle engine"),
                          0)

    def warning(self, ranks):
        # Said whenever the engine sets a run up: at the start, and twice at each of two times that are written
        text = "WARNING: One or more atoms are time integrated more than once"
        case = make(self.column, f"warning-{ranks}", "fix move ", "fix again all nve/sphere\nfix move ")
        failed, log = outcome(case, ranks)
        self.expect_true(f"warning-{ranks}: runs", not failed)
        self.expect_true(f"warning-{ranks}: the engine says it several times",
                         (case.folder / LOG).read_text(errors="replace").count(text) > 1)
        self.expect_equal(f"warning-{ranks}: times that the solver's log says it", log.count(text), 1)

    @unittest.skipUnless(ENGINE == "lammps", "a style of the LAMMPS package")
    def test_overlap(self):
        """Two spheres, one in the other, of a style that says why they fly apart."""
        case = make(self.column, "overlap", "set          group",
                    "create_atoms 1 single 0.031 0.029 0.190001\nset          group")
        # A contact takes many of these steps: nothing else stops the run. The skin is one that the spheres soon cross.
        append(case, COUPLING, 'lammpsCoeffs { script "particles.lmp"; variables { dt 1e-7; } }')
        append(case, "system/controlDict", "deltaT 1e-6; endTime 1e-4; writeInterval 1e-4;")
        script = case.folder / SCRIPT
        coefficients = "stiffness 100 restitution 0.9 friction 0.1 hamaker 1e-19 cutoff 4e-10 1e-7"
        script.write_text(script.read_text()
                          .replace("gran/hooke/history 100 NULL 0 NULL 0 0", "gran/hamaker")
                          .replace("neighbor     1e-3 bin", "atom_modify sort 0 0\nneighbor 1e-7 nsq")
                          .replace("pair_coeff   * *", f"pair_coeff * * {coefficients}"))
        failed, log = outcome(case, 1)
        self.expect_true("overlap: fails", failed)
        reasons = re.findall(r"^ERROR.*", (case.folder / LOG).read_text(), re.M)
        self.expect_equal("reasons in the engine's log", len(reasons), 1)
        self.expect_equal("times that the solver's log says them", [log.count(reason) for reason in reasons], [1])
        for reason in reasons:
            for part in ("overlaps particle", "apart"):
                self.expect_true(f"the reason says \"{part}\": {reason}", part in reason)

    def test_long_script(self):
        # Far longer than the test, of a sphere that nothing moves
        steps = 2000000000
        case = make(self.column, "long", "fix weight ", f"run {steps}\nfix weight ")
        process = case.start()
        said, begin = None, time.time()
        while process.poll() is None and not said and time.time() < begin + 60:
            time.sleep(0.1)
            said = re.search(rf"{SCRIPT}: (\S+) s, step (\d+) of {steps} of a run, about (\S+) s left of it",
                             case.log("cohesiveBedFoam").read_text())
        process.kill()
        process.wait()
        self.expect_true("a long script: the log says how far it is", said)
        if said:
            seconds, at, left = map(float, said.groups())
            self.expect_true(f"after some seconds: {seconds}", 2 < seconds < 30)
            # The run began a little after the script, and is first seen a quarter of a second after that.
            whole = seconds * steps / at
            self.expect_true(f"seconds left: {left:.4g} of about {whole:.4g}", 0.5 * whole < left < 2 * whole)

    def test_error_of_all(self):
        for ranks in (1, 2):
            self.error_of_all(ranks)

    def test_error_of_one(self):
        for ranks in (1, 2):
            self.error_of_one(ranks)

    def test_quits(self):
        for ranks in (1, 2):
            self.quits(ranks)

    def test_error_of_gas(self):
        for ranks in (1, 2):
            self.error_of_gas(ranks)

    def test_warning(self):
        for ranks in (1, 2):
            self.warning(ranks)


if __name__ == "__main__":
    unittest.main()
