# SPDX-License-Identifier: BSD-3-Clause
"""Lets hard inelastic spheres cool freely, with and without square wells, with several seeds, as many runs at a time as
there are cores, and ends in a table, figures beside those expected, and a picture. Runs that are finished are not
run again.

    run.py [--build FOLDER] [--out FOLDER] [--together N] [--overwrite]
"""

import argparse
import math
from pathlib import Path

import analyse
import picture
import theory
from cohesion_studies import expected, program
from cohesion_studies.expected_study import carry_out_study
from cohesion_studies.job_pool import RunError, digest_of
from cohesion_studies.lammps_run import NotBuilt, ScriptRun, launcher

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"

# Variables of in.cooling, which in KINDS are others.
GAS = {"side": 13, "phi": 0.1, "e": 0.9, "D": 0.0, "w": 1.25, "growth": 1.1, "intervals": 32}
STEP, SKIN = 0.06, 1.0  # of a diameter's time at thermal speed, a tenth of the mean free time at 0.1; diameters
MIX = 30  # mean free times
DILUTE = {"phi": 0.02, "intervals": 16}

# Name, what is other than in GAS, number of seeds.
KINDS = (("e 0.9", {}, 16),
         ("e 0.98", {"e": 0.98, "intervals": 16}, 8),
         ("D 0.02", {"D": 0.02}, 3),
         ("D 0.2", {"D": 0.2}, 3),
         ("phi 0.02", DILUTE, 4),
         ("phi 0.02, D 0.02", {**DILUTE, "D": 0.02}, 4))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/free-cooling")
    program.together_words(parser)
    return parser.parse_args()


class Cooling(ScriptRun):
    """One run of in.cooling."""

    def __init__(self, out, engine, kind, seed, **changed):
        self.kind = kind
        gas = {**GAS, **changed, "seed": seed}
        known = theory.Gas(gas["phi"], gas["e"])
        # Wells give the spheres the speed of falling in, however cold they are: the step stops growing there.
        most = 1e9 if gas["D"] == 0 else gas["D"]**-0.5
        self.given = {**gas, "tau": known.tau, "dt": STEP, "mix": math.ceil(MIX / known.frequency / STEP),
                      "most": most, "skin": SKIN, "half": gas["intervals"] // 2}
        collisions = gas["side"]**3 * known.frequency * known.tau * math.log(gas["growth"]) * gas["intervals"]
        programs = digest_of([HERE / "in.cooling", engine[1]])
        super().__init__(out / f"{kind.replace(', ', '-').replace(' ', '-')}-seed-{seed}", HERE / "in.cooling", engine,
                         {**self.given, "programs": programs}, work=collisions * (1 + 25 * gas["D"]),
                         readers=digest_of([analyse.__file__, theory.__file__]))

    def variables(self):
        return self.given

    def figures(self):
        return analyse.figures(self.folder, self.log(), self.given)

    def share(self):
        done = sum(line.startswith("cooling ") for line in self.log().splitlines()) - 1
        return max(done, 0) / self.given["intervals"]


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    out = program.out_folder(args, "free-cooling").resolve()
    engine = launcher(args.build)
    jobs = [Cooling(out, engine, kind, seed, **changed)
            for kind, changed, seeds in KINDS for seed in range(1, seeds + 1)]
    carry_out_study(jobs, args, out, EXPECTED)
    picture.draw(out / "result.png", jobs)


if __name__ == "__main__":
    program.run(main, NotBuilt, RunError, expected.ExpectationError)
