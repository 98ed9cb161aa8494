# SPDX-License-Identifier: BSD-3-Clause
"""Runs the sheared discs with square wells, as many runs at a time as there are cores, and ends in a table
of findings and a picture. Runs that are finished are not run again.

    run.py [--full] [--out FOLDER] [--build FOLDER]
"""

import argparse
import functools
import hashlib
import math
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import analyse  # noqa: E402
import picture  # noqa: E402
import sweep  # noqa: E402
from job_pool import Job, RunError, carry_out, cores, dies_with_us  # noqa: E402
from lammps_run import NotBuilt, launcher  # noqa: E402

TOO_FAR = "could miss a partner"  # the engine: particles fly too far in a step


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--full", action="store_true",
                        help="the whole sweep with the thesis's block rule (hours) instead of the subset")
    parser.add_argument("--out", type=Path, default=None,
                        help="folder for runs and results (BUILD/shear, with --full BUILD/shear-full)")
    parser.add_argument("--build", type=Path, default=HERE.parents[1] / "build",
                        help="build folder of the package")
    parser.add_argument("--together", type=int, default=cores(), metavar="N",
                        help="runs at a time (the cores there are: %(default)s)")
    args = parser.parse_args()
    if args.together < 1:
        parser.error(f"--together {args.together}: it must be 1 or more")
    return args


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


class ShearRun(Job):
    """One run of in.shear."""

    def __init__(self, run, rule, out, engine):
        settings = {**run._asdict(), **rule._asdict(), "count": discs(run.phi, rule.side),
                    "dt": step(run), "skin": 4 if run.phi < 0.25 else 2.5,
                    "script": content(HERE / "in.shear"), "package": content(engine[1])}
        # Collisions, and how long they take: wells add events, and close clusters collide as they like.
        super().__init__(out / "runs" / run.name, settings,
                         work=settings["count"] * (1 if run.D == 0 else 2))
        self.engine = engine
        self.dt, self.tries = settings["dt"], 0  # dt: halved where it is too long
        self.most_progress = rule.start + rule.most * rule.block

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        program, plugin = self.engine
        command = [program, "-in", HERE / "in.shear", "-log", "none", "-var", "plugin", plugin,
                   "-var", "dt", f"{self.dt:.6g}", "-var", "skin", str(self.settings["skin"])]
        for name in ("count", "phi", "e", "D", "w", "seed", "start", "block", "most"):
            command += ["-var", name, str(self.settings[name])]
        with open(self.folder / "log", "w") as log:
            return subprocess.Popen(dies_with_us(command), cwd=self.folder, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL, env={**os.environ, "OMP_NUM_THREADS": "1"})

    def log(self):
        return (self.folder / "log").read_text()

    def again(self):
        self.tries += 1
        self.dt /= 2
        return TOO_FAR in self.log() and self.tries <= 5

    def figures(self):
        return {"dt": self.dt, **analyse.read_log(self.log())}

    def share(self):
        """Of the longest that the run can be."""
        rows = [words for words in map(str.split, self.log().splitlines()[-4:])
                if len(words) == 6 and words[0].isdigit()]
        return min(float(rows[-1][2]) / self.most_progress, 1.0) if rows else 0.0

    def tail(self):
        return "\n".join(self.log().splitlines()[-15:])


def main():
    args = arguments()
    args.build = args.build.resolve()
    out = (args.out or args.build / ("shear-full" if args.full else "shear")).resolve()
    runs, rule = (sweep.full(), sweep.THESIS) if args.full else (sweep.subset(), sweep.SHORT)
    engine = launcher(args.build)
    results = carry_out([ShearRun(run, rule, out, engine) for run in runs], args.together)
    text = analyse.report(results)
    (out / "result.txt").write_text(text + "\n")
    picture.draw(out, results)
    print(text)
    print(f"\npicture: {out / 'result.png'}\ntable:   {out / 'result.txt'}")


if __name__ == "__main__":
    try:
        main()
    except (NotBuilt, RunError) as error:
        sys.exit(f"run.py: {error}")
