# SPDX-License-Identifier: BSD-3-Clause
"""A message of the exchange between ranks that is not of the size that is expected stops the run, and says both sizes:
exchange_sizes.cpp, which the environment names (COHESION_EXCHANGE_SIZES), sends such ones through the functions of the
coupling."""

import os
import re
import subprocess
import unittest

from cohesion_studies.foam_case import environment
from cohesion_tests.coupling.test_case import CoupledTestCase


class ExchangeSizes(CoupledTestCase):
    def run_program(self, word):
        done = subprocess.run(["mpirun", "--oversubscribe", "-np", "2", os.environ["COHESION_EXCHANGE_SIZES"], word],
                              env=environment(self.build), text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=120)
        return done.returncode, " ".join(done.stdout.replace("[1]", "").split())

    def stops(self, word):
        code, output = self.run_program(word)
        self.expect_true(f"{word}: stops", code != 0 and "received" not in output)
        return output

    def test_right(self):
        code, output = self.run_program("right")
        self.expect_equal("three whole records: exit code", code, 0)
        self.expect_true("they are what rank 0 sent", "received 0 0" in output)

    def test_other_sizes(self):
        for word, came in (("fewer", 2 * 32), ("more", 4 * 32), ("part", 3 * 24)):
            said = f"rank 0 sent {came} bytes to rank 1, which expected 3 records of 32 bytes"
            self.assertIn(said, self.stops(word))

    def test_number_of_another_size(self):
        said = re.search(r"rank 0 said in (\d+) bytes .* rank 1, which expected a number of (\d+) bytes",
                         self.stops("size"))
        self.expect_true("size: says that a byte is missing", said is not None and int(said[1]) == int(said[2]) - 1)


if __name__ == "__main__":
    unittest.main()
