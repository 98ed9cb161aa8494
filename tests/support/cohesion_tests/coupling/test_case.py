# SPDX-License-Identifier: BSD-3-Clause
"""Tests of coupled cases. Their environment: COHESION_BUILD, the build folder, and COHESION_WORK, a folder for the
cases, which stay there for who wants to look at them."""

import os
import unittest
from pathlib import Path

from cohesion_studies.foam_case import CaseError
from cohesion_tests.coupling.cases import ENGINE, Columns
from cohesion_tests.refusals import assert_says

SOLVER = "cohesiveBedFoam"


class CoupledTestCase(unittest.TestCase):
    """Runs are long, so each checks much: an expectation that fails is reported, and the test continues with the
    next."""

    build, work = os.environ["COHESION_BUILD"], Path(os.environ["COHESION_WORK"])
    _columns = Columns(build, work)

    @classmethod
    def column(cls, name, engine=ENGINE):
        """The column case, fresh, in the folder `name`."""
        return cls._columns(name, engine)

    def _expect(self, what, right, text):
        with self.subTest(what):
            if not right:
                self.fail(f"{what}: {text}")

    def expect_below(self, what, found, limit):
        self._expect(what, found < limit, f"{found:.4g}, must be below {limit:.4g}")

    def expect_near(self, what, found, expected, tolerance):
        self._expect(what, abs(found - expected) <= tolerance,
                     f"{found:.10g}, expected {expected:.10g} +- {tolerance:.2g}")

    def expect_equal(self, what, found, expected):
        self._expect(what, found == expected, f"{found!r}, expected {expected!r}")

    def expect_true(self, what, condition):
        self._expect(what, condition, "is not so")

    def expect_balance(self, what, lines):
        """What the gas gave is what the particles got, and their volume is on the mesh, in every step of `lines`, of
        exchange_lines(). Sums of some 1e3 terms, each rounded to 1e-16: 1e-13 at most. Asked for: 1e-12."""
        self.expect_below(f"{what}: largest imbalance of the forces", max(x["imbalance"] for x in lines), 1e-12)
        self.expect_below(f"{what}: largest error of the solid volume", max(x["volume"] for x in lines), 1e-12)

    def refused(self, what, case, *parts, options=(), ranks=1, begun=False, written=False):
        """The solver stops with a message that has all `parts`, and no trace of calls; before the first step unless it
        has `begun`, and with the time folders as they were unless some may be `written`. Gives the log."""
        before = times(case)
        with self.subTest(what):
            with self.assertRaises(CaseError, msg=f"{what}: runs"):
                case.solve(*options, ranks=ranks)
        log = case.log(SOLVER).read_text()
        # A dictionary in that of a file has a dot before its name in OpenFOAM v1912 and a slash in later releases.
        said = log.replace("Properties.", "Properties/")
        for part in parts:
            with self.subTest(what, says=part):
                assert_says(self, said, part)
        self.expect_true(f"{what}: no trace of calls", "printStack" not in log)
        if not begun:
            self.expect_equal(f"{what}: steps", log.count("\nTime = "), 0)
        if not written:
            self.expect_equal(f"{what}: time folders", times(case), before)
        return log


def times(case):
    """Names of the time folders."""
    return sorted(d.name for d in case.folder.iterdir() if d.is_dir() and d.name[0].isdigit())
