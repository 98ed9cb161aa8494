# SPDX-License-Identifier: BSD-3-Clause
"""Runs the sheared discs with square wells, as many runs at a time as there are cores, and ends in a table
of findings and a picture. Runs that are finished are not run again.

    run.py [--full | --thesis] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse
import functools
import hashlib
import math
import re
from pathlib import Path

import analyse
import claims
import events
import picture
import sweep
from cohesion_studies import program
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.lammps_run import MARK, NotBuilt, ScriptRun, launcher

HERE = Path(__file__).resolve().parent

TOO_FAR = "could miss a partner"  # the engine: particles fly too far in a step


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--full", action="store_true",
                       help="the whole sweep with the thesis's block rule (hours) instead of the subset")
    which.add_argument("--thesis", action="store_true",
                       help="runs that decide the thesis's claims, on its own parameters with at most 6 blocks")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/shear, BUILD/shear-full, BUILD/shear-thesis")
    program.together_words(parser)
    return parser.parse_args()


def discs(fraction, side):
    return round(fraction * side**2 / math.pi)


def step(run):
    """A fifteenth of the mean free time at the temperature of the run, which goes roughly as that of a
    dilute gas, 0.3/((1 - e^2) phi^2); deep wells make faster clusters."""
    contact = (1 - 7 * run.phi / 16) / (1 - run.phi)**2
    path = math.pi / (4 * math.sqrt(2) * run.phi * contact)
    speed = math.sqrt(math.pi / 2 * (0.3 / ((1 - run.e**2) * run.phi**2) + run.D))
    return path / speed / 15


@functools.lru_cache(maxsize=None)
def content(file):
    """What a result of other content was not made with."""
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


class ShearRun(ScriptRun):
    """One run of in.shear."""

    def __init__(self, run, rule, out, engine, record=False):
        settings = {**run._asdict(), **rule._asdict(), "count": discs(run.phi, rule.side),
                    "dt": step(run), "skin": 4 if run.phi < 0.25 else 2.5,
                    "script": content(HERE / "in.shear"), "package": content(engine[1]),
                    "record": "yes" if record else "no"}
        # Collisions, and how long they take: wells add events, and close clusters collide as they like.
        super().__init__(out / "runs" / (run.name + "-events" * record), HERE / "in.shear", engine, settings,
                         work=settings["count"] * (1 if run.D == 0 else 2))
        self.dt, self.tries = settings["dt"], 0  # dt: halved where it is too long
        self.most_progress = rule.start + rule.most * rule.block

    def variables(self):
        names = ("skin", "count", "phi", "e", "D", "w", "seed", "start", "block", "most", "record")
        return {"dt": f"{self.dt:.6g}", **{name: self.settings[name] for name in names}}

    def again(self):
        self.tries += 1
        self.dt /= 2
        return TOO_FAR in self.log() and self.tries <= 5

    def figures(self):
        log = self.log()
        # Not self.dt: the run may be one that was started with half of it, and is read again.
        found = {"dt": float(re.search(r"^\s*Time step\s*:\s*(\S+)", log, re.M)[1]), **analyse.read_log(log)}
        if self.settings["record"] == "yes":
            start = self.settings["start"] / (self.settings["start"] + found["blocks"] * self.settings["block"])
            found.update(events.evaluate(self.folder, found["dt"], start))
        return found

    def share(self):
        """Of the longest that the run can be."""
        row = self.last_row(columns=6)
        return min(row[2] / self.most_progress, 1.0) if row else 0.0


def main():
    args = arguments()
    args.build = args.build.resolve()
    name = "shear-full" if args.full else "shear-thesis" if args.thesis else "shear"
    out, engine = program.out_folder(args, name).resolve(), launcher(args.build)
    if args.thesis:
        jobs = [ShearRun(run, rule, out, engine) for run, rule in sweep.thesis()]
        jobs += [ShearRun(run, rule, out, engine, record=True) for run, rule in sweep.recorded()]
    else:
        runs, rule = (sweep.full(), sweep.THESIS) if args.full else (sweep.subset(), sweep.SHORT)
        jobs = [ShearRun(run, rule, out, engine) for run in runs]
    require_ours(jobs, MARK, args.overwrite)
    results = carry_out(jobs, args.together)
    if args.thesis:
        program.leave_table(out, claims.report(results))
        return
    program.leave_table(out, analyse.report(results))
    picture.draw(out, results)


if __name__ == "__main__":
    program.run(main, NotBuilt, RunError)
