# SPDX-License-Identifier: BSD-3-Clause
"""Drops 500 hard spheres in a plane into a box, with several seeds, time steps and contact times, as many runs at
a time as there are cores, and ends in a table, figures beside those expected, and a picture. Runs that are
finished are not run again.

    run.py [--build FOLDER] [--out FOLDER] [--seeds N ...] [--together N]
"""

import argparse
import csv
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import analyse  # noqa: E402
import picture  # noqa: E402
from job_pool import Job, RunError, carry_out, cores, dies_with_us, digest_of  # noqa: E402
from lammps_run import NotBuilt, launcher  # noqa: E402
from study_table import over_seeds  # noqa: E402

# Variables of in.pouring. The columns, 1.5 diameters apart, fill a box 24 diameters wide.
BED = {"count": 500, "columns": 16, "height": 48, "e": 0.9, "mu": 0.3, "time": 0.6}
SPACING = 1.5 * analyse.DIAMETER
STEP, CONTACT = 1e-4, 1e-6  # s; the step is that of Hoomans et al.
KINDS = ((STEP, CONTACT), (2 * STEP, CONTACT))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3], metavar="N",
                        help="of the places from which the spheres fall (%(default)s)")
    parser.add_argument("--out", type=Path, default=None, help="folder for runs and results (BUILD/pouring)")
    parser.add_argument("--build", type=Path, default=HERE.parents[1] / "build",
                        help="build folder of the package")
    parser.add_argument("--together", type=int, default=cores(), metavar="N",
                        help="runs at a time (the cores there are: %(default)s)")
    args = parser.parse_args()
    if args.together < 1:
        parser.error(f"--together {args.together}: it must be 1 or more")
    return args


class Pouring(Job):
    """One run of in.pouring."""

    def __init__(self, out, engine, seed, dt, contact, **changed):
        variables = {**BED, **changed, "seed": seed, "dt": dt, "contact": contact}
        self.kind = f"dt {dt:g} s, contact {contact:g} s"
        programs = digest_of([HERE / "in.pouring", engine[1]])
        super().__init__(out / f"dt-{dt:g}-contact-{contact:g}-seed-{seed}",
                         {**variables, "programs": programs}, work=1 / dt,
                         readers=digest_of([analyse.__file__]))
        self.engine, self.variables = engine, variables
        self.width = variables["columns"] * SPACING

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        program, plugin = self.engine
        command = [program, "-in", HERE / "in.pouring", "-log", "none", "-var", "plugin", plugin]
        for name, value in self.variables.items():
            command += ["-var", name, str(value)]
        with open(self.folder / "log", "w") as log:
            return subprocess.Popen(dies_with_us(command), cwd=self.folder, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL, env={**os.environ, "OMP_NUM_THREADS": "1"})

    def log(self):
        return (self.folder / "log").read_text()

    def figures(self):
        return analyse.figures(self.folder, self.log(), self.width, self.variables["dt"])

    def share(self):
        rows = [words for words in map(str.split, self.log().splitlines()[-4:])
                if len(words) == 8 and words[0].isdigit()]
        return float(rows[-1][0]) * self.variables["dt"] / self.variables["time"] if rows else 0.0

    def tail(self):
        return "\n".join(self.log().splitlines()[-15:])


def expected():
    """Rows of expected.csv as dicts."""
    with open(HERE / "expected.csv") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def table(by_kind):
    """Means and standard deviations over the seeds for each kind of run, and expected.csv beside the first.
    by_kind: {kind: [results]}."""
    means = {kind: over_seeds(results) for kind, results in by_kind.items()}
    first = next(iter(means.values()))
    rows = [("", *means)]
    for name in first:
        if name == "seconds":  # by the clock: says more of the machine's other work
            continue
        rows.append((name, *("{:.4g} +- {:.1g}".format(*mean[name]) for mean in means.values())))
    lines = aligned(rows)
    lines += ["", "expected of the first column:"]
    for row in expected():
        mean = first[row["quantity"]][0]
        within = "yes" if float(row["low"]) <= mean <= float(row["high"]) else "NO"
        lines.append(f"{row['quantity']} {mean:.4g} between {row['low']} and {row['high']}: {within} "
                     f"({row['origin']})")
    return "\n".join(lines)


def aligned(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]


def main():
    args = arguments()
    out = (args.out or args.build / "pouring").resolve()
    engine = launcher(args.build)
    jobs = [Pouring(out, engine, seed, *kind) for kind in KINDS for seed in args.seeds]
    by_kind = {}
    for job, result in zip(jobs, carry_out(jobs, args.together)):
        by_kind.setdefault(job.kind, []).append(result)
    text = table(by_kind)
    (out / "result.txt").write_text(text + "\n")
    picture.draw(out / "result.png", jobs)
    print(text)
    print(f"\npicture: {out / 'result.png'}\ntable:   {out / 'result.txt'}")


if __name__ == "__main__":
    try:
        main()
    except (NotBuilt, RunError) as error:
        sys.exit(f"run.py: {error}")
