# SPDX-License-Identifier: BSD-3-Clause
"""A message of the exchange between ranks that is not of the size that is expected stops the run, and says both sizes:
exchange_sizes.cpp sends such ones through the functions of the coupling.

    exchange_sizes.py BUILD WORK PROGRAM"""

import re
import subprocess
import sys

from cohesion_studies.foam_case import environment
from cohesion_tests.coupling.cases import Expectations


def main():
    build, _, program = sys.argv[1:4]
    expect = Expectations()

    def run(word):
        done = subprocess.run(["mpirun", "--oversubscribe", "-np", "2", program, word], env=environment(build),
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
        return done.returncode, " ".join(done.stdout.replace("[1]", "").split())

    code, output = run("right")
    expect.equal("three whole records: exit code", code, 0)
    expect.true("they are what rank 0 sent", "received 0 0" in output)
    for word, came in (("fewer", 2 * 32), ("more", 4 * 32), ("part", 3 * 24)):
        code, output = run(word)
        expect.true(f"{word}: stops", code != 0 and "received" not in output)
        said = f"rank 0 sent {came} bytes to rank 1, which expected 3 records of 32 bytes"
        expect.true(f"{word}: says '{said}'", said in output)
    code, output = run("size")
    said = re.search(r"rank 0 said in (\d+) bytes .* rank 1, which expected a number of (\d+) bytes", output)
    expect.true("size: stops", code != 0 and "received" not in output)
    expect.true("size: says that a byte is missing", said is not None and int(said[1]) == int(said[2]) - 1)
    expect.exit()


if __name__ == "__main__":
    main()
