# SPDX-License-Identifier: BSD-3-Clause
"""Measures the excess compressibility and the viscosity of gases of hard and soft spheres, with and without cohesion, for
each row of a table, as many runs at a time as there are cores, and ends in a table beside theory, a law fitted to the
cohesive ones, figures beside those expected, and a picture. Runs that are finished are not run again.

    run.py [--table FILE] [--build FOLDER] [--out FOLDER] [--together N] [--overwrite]
"""

import argparse
import math
from pathlib import Path

import analyse
import laws
import picture
import theory
from cohesion_studies import expected, program, study_table
from cohesion_studies.job_pool import RunError, carry_out, digest_of, require_ours
from cohesion_studies.lammps_run import MARK, NotBuilt, ScriptRun, launcher

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"
BLOCKS = 20

# Of a row. collisions: of a sphere, while it is measured, in all seeds together.
KNOWN = {"script": "gas", "lattice": "sc", "side": 8, "phi": 0.3, "e": 1, "D": 0, "w": 1.05, "by": "none",
         "collisions": 800, "seeds": 1, "K": 66826, "contact": 20, "scheme": "exact", "A": 0, "Hc": 0.02, "Ho": 0.2,
         "rate": 0}
LOOSE = 0.3  # fraction up to which spheres of a simple cubic lattice have room to melt at once
STEP = {"none": 0.5, "rescale": 0.3, "random": 0.1, "redraw": 0.1}  # mean free times; no flight may be half a box long
MIX = 50  # collisions of a sphere
SKIN = 0.5


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--table", type=Path, default=HERE / "gases.csv", metavar="FILE", help="rows (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/compressibility")
    program.together_words(parser)
    return parser.parse_args()


class Gas(ScriptRun):
    """One run of a row with one seed; `known`: what the script does not ask for, and analyse.py does."""

    shared = ("side", "phi", "e")

    def __init__(self, out, engine, name, row, seed):
        self.kind, self.row = name, row
        script = HERE / f"in.{row['script']}"
        count = (4 if row["lattice"] == "fcc" else 1) * row["side"]**3
        self.given = {**{key: row[key] for key in self.shared}, "skin": SKIN, "seed": seed}
        self.known = {"count": count}
        self.collisions = row["collisions"] / row["seeds"]
        self.free = 1 / theory.frequency(row["phi"])
        self.plan(row)
        super().__init__(out / f"{name}-seed-{seed}", script, engine,
                         {**self.given, "programs": digest_of([script, engine[1]])},
                         work=count * self.weight(), readers=digest_of([analyse.__file__, theory.__file__]))

    def growing(self, row, stages):
        melts = row["lattice"] == "fcc" or row["phi"] <= LOOSE
        return {"start": row["phi"] if melts else LOOSE, "stages": 0 if melts else stages}

    def variables(self):
        return self.given

    def figures(self):
        return self.read(self.log(), {**self.given, **self.known, **{"by": self.row["by"]}})


class HardGas(Gas):
    shared = ("lattice", "side", "phi", "e", "D", "w", "by")
    read = staticmethod(analyse.hard)

    def plan(self, row):
        dt = STEP[row["by"]] * self.free
        # Elastic spheres lose nothing; what their wells take and give back is little.
        every = 3 if row["by"] == "rescale" and row["e"] == 1 else 1
        self.given.update(self.growing(row, 200), every=every, dt=dt, blocks=BLOCKS,
                          rest=every * math.ceil(10 / every), mix=every * math.ceil(MIX / STEP[row["by"]] / every),
                          steps=every * math.ceil(self.collisions / STEP[row["by"]] / BLOCKS / every))

    def weight(self):
        return self.collisions * (1 + 1 / STEP[self.row["by"]])

    def share(self):
        return max(sum(line.startswith("gas ") for line in self.log().splitlines()) - 2, 0) / BLOCKS


class SoftGas(Gas):
    shared = ("lattice", "side", "phi", "e", "by", "K", "contact", "scheme", "A", "Hc", "Ho")
    read = staticmethod(analyse.soft)

    def plan(self, row):
        self.known["dt"] = math.pi / math.sqrt(2 * row["K"]) / row["contact"]
        steps = self.free / self.known["dt"]  # of a mean free time
        every = max(1, round(0.1 * steps))
        self.given.update(self.growing(row, 100), every=every, rest=math.ceil(0.2 * steps), blocks=BLOCKS,
                          mix=math.ceil(MIX * steps), steps=every * math.ceil(self.collisions * steps / BLOCKS / every))

    def weight(self):
        return 3 * BLOCKS * self.given["steps"]

    def share(self):
        rows = self.last_row(6 + 3 + 13)
        return rows[0] / (self.given["steps"] * BLOCKS) / 2 if rows else 0.0


class Flow(Gas):
    shared = ("side", "phi", "e", "rate")
    read = staticmethod(analyse.flow)

    def plan(self, row):
        every = 5 if row["rate"] else 3
        dt = (0.05 if row["rate"] else 0.2) * self.free
        lines = math.ceil(self.collisions * self.free / dt / every)
        self.given.update(dt=dt, every=every, mix=every * math.ceil(MIX * self.free / dt / every), lines=lines)

    def weight(self):
        return 8 * self.given["lines"] * self.given["every"]

    def share(self):
        rows = self.last_row(15)
        return rows[0] / (self.given["lines"] * self.given["every"]) if rows else 0.0


SCRIPTS = {"gas": HardGas, "soft": SoftGas, "flow": Flow}


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    out = program.out_folder(args, "compressibility").resolve()
    engine = launcher(args.build)
    table = study_table.read_table(args.table, KNOWN)
    jobs = [SCRIPTS[row["script"]](out, engine, name, row, seed)
            for name, row in table.items() for seed in range(1, row["seeds"] + 1)]
    require_ours(jobs, MARK, args.overwrite)
    found = laws.rows(study_table.by_kind(jobs, carry_out(jobs, args.together)), table)
    found.update(laws.together(found, table))
    program.leave_table(out, laws.text(found) + "\n\n" + expected.text(EXPECTED, found))
    picture.draw(out / "result.png", found, table)


if __name__ == "__main__":
    program.run(main, NotBuilt, RunError, study_table.TableError, expected.ExpectationError)
